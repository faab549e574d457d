// Exercise 07. Write what one foot does to the other. Then: bash lessons/run check 7
// A push of 1 N s upwards at the left foot: how much faster does the right foot rise [m/s]? It moves with the
// centre, and it turns about it. Feet has the mass, the inertia, and where both feet are.
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise07 {

double coupling(const Feet& feet) {
  (void)feet;
  return std::nan("");  // <- your code
}

}  // namespace cairn::exercise07
