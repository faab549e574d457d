// Exercise 03. Write the inner loop of Algorithm 1 for one contact. Then: bash lessons/run check 3
#include <algorithm>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise03 {

/// A box that can only move up and down.
struct Box {
  double inverse_mass = 0;  // [1/kg]; 0: the ground
  double velocity = 0;      // [m/s] upwards
};

/// One-sided: the box above may rise from the one below, and must not sink into it.
struct Contact {
  int below = 0;  // places in the list of boxes
  int above = 0;
  double impulse = 0;  // [N s] that it has given so far, in total
};

// j·v of a contact is the velocity of the box above less that of the box below. Give both boxes the impulse
// that makes it 0, as far as a contact that cannot pull is able to, and add it to what the contact has given
// so far.
void update(Contact& contact, List<Box>& boxes) {
  Box& below = boxes[contact.below];
  Box& above = boxes[contact.above];
  // Your code begins here: about five lines.

  // Your code ends here.
}

}  // namespace cairn::exercise03
