// Exercise 03, answered.
#include <algorithm>

#include "exercise.hpp"

namespace cairn::exercise03 {

double wanted_speed(double depth, const Recovery& recovery) {
  const double error = std::max(depth - recovery.slop, 0.0);                 // what is deeper than it may be
  return std::min(recovery.beta * error / recovery.dt, recovery.max_speed);  // (7); c = -depth
}

}  // namespace cairn::exercise03
