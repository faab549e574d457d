// Exercise 16: every misconception is told from the answer.
#include "lessons/16_jacobi/exercise.hpp"

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise16 {
namespace {

bool is_told(Answer answer, const std::string& misconception) {
  Grade marks;
  grade(marks, answer);
  return testing::names(marks, misconception);
}

}  // namespace

TEST_CASE("exercise 16 tells whole corrections, half ones, and such that take for ever") {
  CHECK(is_told([](int) { return 1.0; }, "far too much"));
  CHECK(is_told([](int) { return 0.5; }, "nobody to disturb"));
  CHECK(is_told([](int) { return 0.5; }, "too much"));
  CHECK(is_told([](int) { return 0.001; }, "for ever"));
  CHECK(is_told([](int contacts) { return 0.3 / contacts; }, "a larger omega"));
}

}  // namespace cairn::exercise16
