// Exercise 09. Write the largest β with which a ball does not jump. Then: bash lessons/run check 9
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise09 {

/// A ball at rest inside the ground, and how its steps are made.
struct Sunk {
  double depth = 0;    // [m] inside the ground, above 0
  double slop = 0;     // [m] a depth up to this may stay: β takes its share of what is deeper
  double gravity = 0;  // [m/s²]
  double dt = 0;       // [s]
};

// The largest β from 0 to 1 with which the ground still pushes in step 2, or would just not have to. A ball
// that is not deeper than the slop is not moved by any β.
double largest_beta(const Sunk& ball) {
  double beta = std::nan("");
  // Your code begins here: one or two lines.

  // Your code ends here.
  return beta;
}

}  // namespace cairn::exercise09
