// Exercise 14: every misconception is told from the answer.
#include "lessons/14_pulley/exercise.hpp"

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise14 {
namespace {

bool is_told(Answer answer, const std::string& misconception) {
  Grade marks;
  grade(marks, answer);
  return testing::names(marks, misconception);
}

using Row = std::array<double, 2>;

}  // namespace

TEST_CASE("exercise 14 tells wheels that mesh from inside, and teeth that change places") {
  CHECK(is_told([](double a, double b) { return Row{a, -b}; }, "opposite ways"));
  CHECK(is_told([](double a, double b) { return Row{b, a}; }, "which number belongs"));
  CHECK(is_told([](double a, double b) { return Row{b, -a}; }, "the other way round"));
}

}  // namespace cairn::exercise14
