// Exercise 07. Write what one foot does to the other. Then: bash lessons/run check 7
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise07 {

double coupling(const Feet& feet) {
  (void)feet;
  return std::nan("");  // <- your code
}

}  // namespace cairn::exercise07
