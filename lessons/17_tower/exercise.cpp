// Exercise 17. How many sweeps does a tower take? Then: bash lessons/run check 17
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise17 {

int sweeps_needed(int boxes, double share) {
  (void)boxes, (void)share;
  return -1;  // <- your code
}

}  // namespace cairn::exercise17
