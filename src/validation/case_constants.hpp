// Floor 8. Numbers that cases share.
#pragma once

#include <limits>

#include "math/math.hpp"

namespace cairn::cases {

inline constexpr double standard_gravity = 10;   // [m/s^2] g, the default of a scene
inline constexpr double standard_dt = 1.0 / 60;  // [s], the default of a scene
inline constexpr double double_epsilon = std::numeric_limits<double>::epsilon();

constexpr double in_radians(double degrees) { return degrees * pi / 180; }
constexpr double in_degrees(double radians) { return radians * 180 / pi; }

}  // namespace cairn::cases
