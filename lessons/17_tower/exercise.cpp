// Exercise 17. How many sweeps does a tower take? Then: bash lessons/run check 17
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise17 {

// Each sweep of PGS or SI multiplies the slowest error of a stack of n boxes by cos^2(pi / (2 n)). Return
// after how many sweeps no more than `share` of it is left (0.01: one per cent), rounded up.
int sweeps_needed(int boxes, double share) {
  (void)boxes, (void)share;
  return -1;  // <- your code
}

}  // namespace cairn::exercise17
