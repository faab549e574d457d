// Exercise 06: every misconception is told from the answer.
#include "lessons/06_sequential_impulses/exercise.hpp"

#include <algorithm>

#include "exercises/wrong_answers.hpp"
#include "math/list.hpp"

namespace cairn::exercise06 {
namespace {

struct Pair {
  Box& below;
  Box& above;
};

Pair pair_of(const Contact& contact, List<Box>& boxes) {
  return {boxes[contact.below], boxes[contact.above]};
}

double correction_of(const Pair& p) {
  return -(p.above.velocity - p.below.velocity) / (p.below.inverse_mass + p.above.inverse_mass);
}

void give(const Pair& p, double impulse) {
  p.below.velocity -= p.below.inverse_mass * impulse;
  p.above.velocity += p.above.inverse_mass * impulse;
}

void clamped_correction(Contact& contact, List<Box>& boxes) {
  const double correction = std::max(correction_of(pair_of(contact, boxes)), 0.0);
  contact.impulse += correction;
  give(pair_of(contact, boxes), correction);
}

void unclamped(Contact& contact, List<Box>& boxes) {
  const double correction = correction_of(pair_of(contact, boxes));
  contact.impulse += correction;
  give(pair_of(contact, boxes), correction);
}

void all_of_it_given(Contact& contact, List<Box>& boxes) {
  const double correction = correction_of(pair_of(contact, boxes));
  contact.impulse = std::max(contact.impulse + correction, 0.0);
  give(pair_of(contact, boxes), correction);
}

void replaced(Contact& contact, List<Box>& boxes) {
  const double correction = correction_of(pair_of(contact, boxes));
  contact.impulse = std::max(correction, 0.0);
  give(pair_of(contact, boxes), correction);
}

void nothing_applied(Contact& contact, List<Box>& boxes) {
  contact.impulse = std::max(contact.impulse + correction_of(pair_of(contact, boxes)), 0.0);
}

void only_above(Contact& contact, List<Box>& boxes) {
  const double correction = correction_of(pair_of(contact, boxes));
  contact.impulse += correction;
  pair_of(contact, boxes).above.velocity += correction * pair_of(contact, boxes).above.inverse_mass;
}

void one_mass(Contact& contact, List<Box>& boxes) {
  const Pair p = pair_of(contact, boxes);
  const double correction = -(p.above.velocity - p.below.velocity) / p.above.inverse_mass;
  contact.impulse += correction;
  give(p, correction);
}

void multiplied(Contact& contact, List<Box>& boxes) {
  const Pair p = pair_of(contact, boxes);
  const double inverse = p.below.inverse_mass + p.above.inverse_mass;
  const double correction = correction_of(p) * inverse * inverse;
  contact.impulse += correction;
  give(p, correction);
}

void wrong_sign(Contact& contact, List<Box>& boxes) {
  const double correction = -correction_of(pair_of(contact, boxes));
  contact.impulse += correction;
  give(pair_of(contact, boxes), correction);
}

}  // namespace

TEST_CASE("exercise 06 tells what was clamped, forgotten, replaced or given to one body only") {
  CHECK(testing::tells<grade>(clamped_correction, "Clamp the sum"));
  CHECK(testing::tells<grade>(unclamped, "cannot pull"));
  CHECK(testing::tells<grade>(all_of_it_given, "what the clamp has left"));
  CHECK(testing::tells<grade>(replaced, "add it"));
  CHECK(testing::tells<grade>(nothing_applied, "apply the impulse at once"));
  CHECK(testing::tells<grade>(only_above, "Action and reaction"));
  CHECK(testing::tells<grade>(one_mass, "the effective mass has both"));
  CHECK(testing::tells<grade>(multiplied, "divide by"));
  CHECK(testing::tells<grade>(wrong_sign, "The sign"));
}

}  // namespace cairn::exercise06
