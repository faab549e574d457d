// Exercise 00, answered.
#include "exercise.hpp"

namespace cairn::exercise00 {

void integrate(Falling& body, double acceleration, double dt) {
  body.velocity += acceleration * dt;  // first the velocity,
  body.height += body.velocity * dt;   // then the place, with the new velocity
}

}  // namespace cairn::exercise00
