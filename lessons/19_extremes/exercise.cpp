// Exercise 19. How many sweeps does a heavy box on a light one take? Then: bash lessons/run check 19
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise19 {

int sweeps_needed(double above, double below, double share) {
  (void)above, (void)below, (void)share;
  return -1;  // <- your code
}

}  // namespace cairn::exercise19
