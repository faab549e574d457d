// Exercise 06, answered.
#include <algorithm>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise06 {

void update(Contact& contact, List<Box>& boxes) {
  Box& below = boxes[contact.below];
  Box& above = boxes[contact.above];
  const double correction =
      -(above.velocity - below.velocity) / (below.inverse_mass + above.inverse_mass);  // (22)
  const double before = contact.impulse;
  contact.impulse = std::max(before + correction, 0.0);  // the sum is clamped, not the correction
  const double given = contact.impulse - before;
  below.velocity -= below.inverse_mass * given;  // (23): both bodies, at once
  above.velocity += above.inverse_mass * given;
}

}  // namespace cairn::exercise06
