// Exercise 19. How many sweeps does a heavy box on a light one take? Then: bash lessons/run check 19
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise19 {

// A box of `below` kg stands on the ground and carries one of `above` kg. Each sweep leaves R / (1 + R) of
// the error of the load on the ground, R = above / below. Return after how many sweeps no more than `share`
// of it is left (0.01: one per cent), rounded up.
int sweeps_needed(double above, double below, double share) {
  (void)above, (void)below, (void)share;
  return -1;  // <- your code
}

}  // namespace cairn::exercise19
