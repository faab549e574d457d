// Exercise 11: every misconception is told from the answer.
#include "lessons/11_friction/exercise.hpp"

#include <algorithm>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise11 {
namespace {

/// The tangent impulse becomes `sum`, and the block is pushed by what that adds.
void become(Contact& contact, Block& block, double sum) {
  block.slide += block.inverse_mass * (sum - contact.tangent_impulse);
  contact.tangent_impulse = sum;
}

double stopping(const Block& block) { return -block.slide / block.inverse_mass; }

double bound_of(const Contact& contact) { return contact.friction * contact.normal_impulse; }

void unbounded(Contact& c, Block& b) { become(c, b, c.tangent_impulse + stopping(b)); }

void clamped_correction(Contact& c, Block& b) {
  become(c, b, c.tangent_impulse + std::clamp(stopping(b), -bound_of(c), bound_of(c)));
}

void one_way(Contact& c, Block& b) {
  become(c, b, std::clamp(c.tangent_impulse + stopping(b), -bound_of(c), 0.0));
}

void other_sign(Contact& c, Block& b) {
  become(c, b, std::clamp(c.tangent_impulse - stopping(b), -bound_of(c), bound_of(c)));
}

void not_applied(Contact& c, Block& b) {
  c.tangent_impulse = std::clamp(c.tangent_impulse + stopping(b), -bound_of(c), bound_of(c));
}

/// Never takes back what an earlier bound allowed.
void old_bound(Contact& c, Block& b) {
  const double bound = std::max(bound_of(c), std::abs(c.tangent_impulse));
  become(c, b, std::clamp(c.tangent_impulse + stopping(b), -bound, bound));
}

}  // namespace

TEST_CASE(
    "exercise 11 tells a bound forgotten, one way only, on the correction or of yesterday, and a velocity "
    "left as it was") {
  CHECK(testing::tells<grade>(unbounded, "at most mu times"));
  CHECK(testing::tells<grade>(clamped_correction, "Clamp the sum"));
  CHECK(testing::tells<grade>(one_way, "both ways"));
  CHECK(testing::tells<grade>(other_sign, "The sign"));
  CHECK(testing::tells<grade>(not_applied, "has not changed"));
  CHECK(testing::tells<grade>(old_bound, "as it is now"));
}

}  // namespace cairn::exercise11
