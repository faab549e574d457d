// Floor 8. Numbers that cases share.
#pragma once

#include <limits>

#include <cairn/math/math.hpp>

namespace cairn::cases {

inline constexpr double standard_gravity = 10;   // [m/s^2] g, the default of a scene
inline constexpr double standard_dt = 1.0 / 60;  // [s], the default of a scene
inline constexpr double double_epsilon = std::numeric_limits<double>::epsilon();

constexpr double in_radians(double degrees) { return degrees * pi / 180; }
constexpr double in_degrees(double radians) { return radians * 180 / pi; }

/// What a step of h [s] makes of the place x [m] and the speed v [m/s] of a mass on a spring of a joint, with
/// the angular frequency w [rad/s] and the damping ratio zeta, under an acceleration [m/s^2]: softness.hpp.
template <Scalar Real>
void swing_step(Real& x, Real& v, Real h, Real w, Real zeta, Real acceleration) {
  const Real s = h * h * w * w, q = 2 * zeta * w * h, share = 1 / (1 + s * s);
  const Real a = 1 - 3 * share / 4, b = share / 4, p = (1 + q) / (2 + q);
  v = (v * (1 + b * s - (1 - p) * q) + h * acceleration - h * w * w * x) / (1 + a * s + p * q);
  x += h * v;
}

}  // namespace cairn::cases
