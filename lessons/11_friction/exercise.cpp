// Exercise 11. One update of a friction row. Then: bash lessons/run check 11
#include <algorithm>
#include <cmath>

#include "lessons/exercise.hpp"

namespace cairn::exercise11 {

/// A block on a plane.
struct Block {
  double inverse_mass = 0;  // [1/kg]
  double slide = 0;         // [m/s] along the plane: j·v of the friction row
};

/// What the contact under it has given so far, in total.
struct Contact {
  double normal_impulse = 0;   // [N s]
  double tangent_impulse = 0;  // [N s]
  double friction = 0;         // mu
};

// One visit to the friction row: takes the sliding away, as far as ± mu times the normal impulse allows.
void update(Contact& contact, Block& block) {
  // Your code begins here: about four lines.

  // Your code ends here.
}

}  // namespace cairn::exercise11
