// Exercise 01: every misconception is told from the answer.
#include "lessons/01_constraint_and_jacobian/exercise.hpp"

#include <cmath>

#include "exercises/wrong_answers.hpp"
#include "math/list.hpp"

namespace cairn::exercise01 {
namespace {

using Row = FixedList<double, 3>;

Row along(const Rail& rail) { return {std::cos(rail.slope), std::sin(rail.slope), 0}; }

Row below(const Rail& rail) { return {std::sin(rail.slope), std::cos(rail.slope), 0}; }

/// Right but for the turn.
Row across(const Rail& rail, double turn) { return {-std::sin(rail.slope), std::cos(rail.slope), turn}; }

Row other_order(const Rail& r) {
  return across(r, -(r.arm_x * std::cos(r.slope) + r.arm_y * std::sin(r.slope)));
}

Row product(const Rail& r) { return across(r, -r.arm_x * std::sin(r.slope) + r.arm_y * std::cos(r.slope)); }

Row one_sign(const Rail& r) { return across(r, r.arm_x * std::cos(r.slope) - r.arm_y * std::sin(r.slope)); }

}  // namespace

TEST_CASE("exercise 01 tells along from across, a forgotten arm, an order and a sign") {
  CHECK(testing::tells<grade>(along, "along the rail"));
  CHECK(testing::tells<grade>(below, "upper side"));
  CHECK(testing::tells<grade>([](const Rail& r) { return across(r, 0); }, "where is the arm"));
  CHECK(testing::tells<grade>(other_order, "The order"));
  CHECK(testing::tells<grade>(product, "That is r n"));
  CHECK(testing::tells<grade>(one_sign, "n_x is negative"));
}

}  // namespace cairn::exercise01
