// Exercise 06. Write the inner loop of Algorithm 1 for one contact. Then: bash lessons/run check 6
// j v of a contact is the velocity of the box above less that of the box below. Give both boxes the impulse
// that makes it 0, as far as a contact that cannot pull is able to, and add it to what the contact has given
// so far.
#include <algorithm>

#include "exercise.hpp"

namespace cairn::exercise06 {

void update(Contact& contact, List<Box>& boxes) {
  Box& below = boxes[contact.below];
  Box& above = boxes[contact.above];
  (void)below, (void)above;  // <- your code: about five lines
}

}  // namespace cairn::exercise06
