// Exercise 03. Write what a row asks for, with slop and a limit. Then: bash lessons/run check 3
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise03 {

/// How a contact removes errors.
struct Recovery {
  double beta = 0;       // share of the error that each step removes
  double slop = 0;       // [m] an error up to this may stay
  double max_speed = 0;  // [m/s] zeta is not above this
  double dt = 0;         // [s]
};

// zeta [m/s] of a contact that is `depth` m inside, equation (7): the separation speed that its row asks
// for. 0 where the depth is within the slop. Bodies that are apart (a depth below 0) get 0 here, too: how
// fast they may close in, as the page's row has it, is left out.
double wanted_speed(double depth, const Recovery& recovery) {
  double zeta = std::nan("");
  // Your code begins here: one or two lines.

  // Your code ends here.
  return zeta;
}

}  // namespace cairn::exercise03
