// Exercise 19. Predict, then measure. Then: bash lessons/run check 19
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise19 {

struct Study {
  int predicted = 0;         // sweeps, computed before the first one
  List<double> errors = {};  // of the load on the ground, over the exact load: after each sweep
};

// A box of `below` kg stands on the ground and carries one of `above` kg. Both begin to fall, at g Δt.
// Predict after how many sweeps at most `share` of the error of the load on the ground is left. Then measure:
// sweep from the ground up, from impulses of 0, and note the error after each sweep, until it is at most
// `share`, or `at_most` are done.
Study study(double below, double above, double gravity, double dt, double share, int at_most) {
  Study result;
  // Your code begins here: about fifteen lines.

  // Your code ends here.
  return result;
}

}  // namespace cairn::exercise19
