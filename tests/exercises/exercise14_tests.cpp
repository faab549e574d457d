// Exercise 14: every misconception is told from the answer.
#include "lessons/14_pulley/exercise.hpp"

#include "exercises/wrong_answers.hpp"
#include "math/list.hpp"

namespace cairn::exercise14 {
namespace {

using Row = FixedList<double, 2>;

}  // namespace

TEST_CASE("exercise 14 tells wheels that mesh from inside, and teeth that change places") {
  CHECK(testing::tells<grade>([](double a, double b) { return Row{a, -b}; }, "opposite ways"));
  CHECK(testing::tells<grade>([](double a, double b) { return Row{b, a}; }, "which number belongs"));
  CHECK(testing::tells<grade>([](double a, double b) { return Row{b, -a}; }, "the other way round"));
}

}  // namespace cairn::exercise14
