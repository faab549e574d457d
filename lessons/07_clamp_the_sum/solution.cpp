// Exercise 07, answered.

#include "exercise.hpp"

namespace cairn::exercise07 {

double coupling(const Feet& feet) {
  // The box rises by 1/m and turns by left/I; the right foot goes up by right times that.
  return 1 / feet.mass + feet.left * feet.right / feet.inertia;
}

}  // namespace cairn::exercise07
