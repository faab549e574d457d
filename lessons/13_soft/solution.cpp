// Exercise 13, answered.
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise13 {

Soft soften(double mass, double frequency, double damping_ratio, double dt) {
  const double omega = 2 * std::acos(-1.0) * frequency;
  const double stiffness = mass * omega * omega, damping = 2 * mass * damping_ratio * omega;
  return {1 / (dt * (damping + dt * stiffness)), dt * stiffness / (damping + dt * stiffness)};
}

}  // namespace cairn::exercise13
