// Floor 3. Soft rows: a spring and a damper in place of a rigid condition.
#pragma once

#include <limits>
#include <string>
#include <variant>

#include "math/math.hpp"

namespace cairn {

/// A spring by how the two bodies would swing on it, whatever their masses.
struct SwingSoftness {
  double frequency = 1;      // f [Hz], as it would be without damping
  double damping_ratio = 0;  // zeta; 1: the fastest return without overshoot

  /// Member by member.
  bool operator==(const SwingSoftness&) const = default;
};

/// A spring by its constants.
struct SpringSoftness {
  double stiffness = 0;  // k [N/m]; of an angle [N m/rad]
  double damping = 0;    // c [N s/m]; of an angle [N m s/rad]

  /// Member by member.
  bool operator==(const SpringSoftness&) const = default;
};

/// How a row gives way: force = -k C - c dC/dt, instead of whatever force keeps C at 0. An inequality gives
/// way only where it is violated, and its spring only pushes.
using Softness = std::variant<SwingSoftness, SpringSoftness>;

// Taking the force at the end of a step of h makes it implicit Euler, which is stable for any k, c and h.
// With impulse = -h (k (C + h j v) + c j v) the row is j v + gamma * impulse = -rate * C:
//   gamma = 1 / (h (c + h k)),   rate = k / (c + h k)
// and with m = 1 / (j M^-1 j^T) and w = 2 pi f a frequency means k = m w^2, c = 2 m zeta w. For a free mass
// at C it gives v' = (v - h w^2 C) / (1 + 2 zeta w h + h^2 w^2). Implicit Euler damps by itself: an undamped
// spring loses the share w^2 h^2 / (1 + w^2 h^2) of its energy in every step. Source: E. Catto, Soft
// Constraints (2011).

/// `rate` above [1/s]: how fast the row takes its error back.
template <Scalar Real>
Real return_rate(const Softness& softness, Real dt);

/// `gamma` above [1/kg]. `inverse_mass` is j M^-1 j^T of the row.
template <Scalar Real>
Real row_softness(const Softness& softness, Real inverse_mass, Real dt);

/// What j M^-1 j^T is divided by for `gamma` of a spring that is given by how it swings.
template <Scalar Real>
Real softness_divisor(const SwingSoftness& swing, Real dt);

/// `gamma` [1/kg] of a spring too weak for Real to tell from none: finite, so that gamma times no impulse is
/// 0.
template <Scalar Real>
constexpr Real most_softness() {
  return std::numeric_limits<Real>::max() / 4;
}

/// @throws std::invalid_argument unless frequency is from 1e-6 to 1e6 Hz, the other numbers from 0 to 1e30,
/// and stiffness and damping not both 0.
void require_softness(const Softness& softness, const std::string& place);

}  // namespace cairn
