// Floor 3. Soft rows: a spring and a damper in place of a rigid condition.
#pragma once

#include <limits>
#include <string>
#include <variant>

#include <cairn/math/math.hpp>

namespace cairn {

/// A spring by how the two bodies would swing on it without turning, whatever their masses.
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

// A step ends with v', and takes the error C to C + h j v': v' is the velocity of the middle of the step, v,
// with which the step before ended, that of the middle of that one, and C stands between them. The spring of
// a joint pushes with
//   F = -k (C + a h j v' - b h j v) - c (p j v' + (1 - p) j v)
// which is a row, j v' + gamma * impulse = bias, with R = h k a + c p:
//   gamma = 1 / (h R),   bias = -(k (C - b h j v) + c (1 - p) j v) / R
// What is right for a and b depends on how far the spring swings in a step, w h, where w^2 = k j M^-1 j^T:
//   a = b = 1/4     the mean of C in the middles of both steps: implicit midpoint. It loses nothing. But a
//                   spring of w h >> 1 is thrown from one side to the other in every step, for ever
//   a = 1, b = 0    C at the end of the step: implicit Euler. It takes the error of a spring of w h >> 1 back
//                   in one step, as a rigid row would; but of any other it loses w^2 h^2 / (1 + w^2 h^2) of
//                   the energy in every step
// So C is the mean of both, the share 1 / (1 + (w h)^4) of the first and the rest of the second. A swing of n
// steps then loses about pi (2 pi / n)^5 of its amplitude each time: 4e-7 of it at 150 steps, 4 % at 15.
// The mean of j v that the damper sees has p = (1 + q) / (2 + q) with q = c h j M^-1 j^T: alone it makes
// v / (1 + q + q^2 / 2) of v, which is e^-q to the second order and never turns.
//
// However many springs are coupled, through whatever masses, and whatever w h each of them sees: with C_m the
// mean of C at both ends of a step, the energy
//   E = v^T (M + sum h^2 k ((a + b) / 2 - 1/4) j^T j) v / 2 + sum k C_m^2 / 2
// changes by -sum k (a - b) (h j (v + v') / 2)^2 in a step, if C is linear. (Multiply M (v' - v) = h sum j^T
// F by (v + v') / 2.) Here a >= b and (a + b) / 2 >= 1/4, so no spring is too stiff for any step; masses that
// hang on a row unseen, behind a joint, can only make a swing fade that need not. A damper with p >= 1/2
// takes energy likewise. Source: N. Newmark (1959), whose average acceleration a = b = 1/4 is.
//
// A spring by its frequency has k = m w^2 and c = 2 m zeta w, with 1 / m = 1 / m_a + 1 / m_b: of masses
// alone, so that k stays what it is as arms turn, and energy with it; inertia takes part only in a row of
// angles. The spring of an inequality does not pull, and has no damper while there is room, C > 0: what then
// goes beyond the room within the step is damped.

/// Where a step begins, as a spring sees it.
template <Scalar Real>
struct SpringState {
  Real error = 0;            // C [m or rad]; of an inequality: the room left
  Real speed = 0;            // j v [m/s or rad/s], with which the step before ended
  Real inverse_mass = 0;     // j M^-1 j^T [1/kg]
  Real of_masses = 0;        // 1 / m [1/kg]
  bool only_pushes = false;  // of an inequality: it never pulls
};

/// What a spring makes of a row: j v + softness * impulse = bias.
template <Scalar Real>
struct SpringRow {
  Real bias = 0;      // [m/s or rad/s]
  Real softness = 0;  // gamma [1/kg]
};

/// The row above in a step of dt [s].
template <Scalar Real>
SpringRow<Real> spring_row(const Softness& softness, const SpringState<Real>& begin, Real dt);

/// k [N/m] of the spring between masses of 1 / `of_masses` [1/kg].
double stiffness_of(const Softness& softness, double of_masses);

// The springs of the policy soft (stabilization.hpp) are meant to lose what they hold: they push with the
// force at the end of the step, a = 1, b = 0, p = 1, and their row is j v + gamma * impulse = -rate * C:
//   gamma = 1 / (h (c + h k)),   rate = k / (c + h k)
// For a free mass at C it gives v' = (v - h w^2 C) / (1 + 2 zeta w h + h^2 w^2). Source: E. Catto, Soft
// Constraints (2011).

/// `rate` above [1/s]: how fast the row takes its error back.
template <Scalar Real>
Real return_rate(const SwingSoftness& swing, Real dt);

/// What 1 / m is divided by for `gamma` above.
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
