// Exercise 11, answered.
#include <algorithm>

#include "exercise.hpp"

namespace cairn::exercise11 {

void update(Contact& contact, Block& block) {
  const double bound = contact.friction * contact.normal_impulse;  // of what has been given in total
  const double before = contact.tangent_impulse;
  contact.tangent_impulse = std::clamp(before - block.slide / block.inverse_mass, -bound, bound);
  block.slide += block.inverse_mass * (contact.tangent_impulse - before);
}

}  // namespace cairn::exercise11
