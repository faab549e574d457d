// Exercise 09. Write the row of a contact that removes its own error. Then: bash lessons/run check 9
#include <algorithm>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise09 {

/// Moves up and down only.
struct Body {
  double inverse_mass = 0;  // [1/kg], 0 for the ground
  double speed = 0;         // [m/s] upwards; gravity has acted
};

struct Rules {
  double beta = 0;
  double slop = 0;  // [m] a depth that is left alone: β takes its share of what is deeper
  double dt = 0;    // [s]
};

// One visit to the contact of two bodies, one above the other. `gap` [m] is the c of the row: how far they
// are apart, and below 0 how deep one is in the other. j·v is the speed of the upper less that of the lower.
// The ground may be either of them. A contact pushes, and does not pull.
void visit(double gap, const Rules& rules, Body& upper, Body& lower) {
  // Your code begins here: about six lines.

  // Your code ends here.
}

}  // namespace cairn::exercise09
