// Exercise 15, answered.
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise15 {

void clamp_to_circle(double& x, double& y, double limit) {
  const double length = std::hypot(x, y);
  if (length <= limit) return;  // also where nothing is pushed at all
  x *= limit / length;
  y *= limit / length;
}

}  // namespace cairn::exercise15
