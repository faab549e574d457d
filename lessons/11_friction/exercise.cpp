// Exercise 11. Write an update of a friction row. Then: bash lessons/run check 11
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise11 {

// block.slide is j v of the row [m/s], block.inverse_mass its j M^-1 j^T [1/kg]. Change
// contact.tangent_impulse, the sum of what the row has given [N s], and block.slide; contact.normal_impulse
// is the sum of the row beside it.
void update(Contact& contact, Block& block) {
  (void)contact, (void)block;  // <- your code: about five lines
}

}  // namespace cairn::exercise11
