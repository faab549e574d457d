// Exercise 16: every misconception is told from the answer.
#include "lessons/16_jacobi/exercise.hpp"

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise16 {
TEST_CASE("exercise 16 tells whole corrections, half ones, and such that take for ever") {
  CHECK(testing::tells<grade>([](int) { return 1.0; }, "far too much"));
  CHECK(testing::tells<grade>([](int) { return 0.5; }, "nobody to disturb"));
  CHECK(testing::tells<grade>([](int) { return 0.5; }, "too much"));
  CHECK(testing::tells<grade>([](int) { return 0.5; }, "does not settle"));
  CHECK(testing::tells<grade>([](int) { return 0.001; }, "for ever"));
  CHECK(testing::tells<grade>([](int contacts) { return 0.3 / contacts; }, "a larger omega"));
}

}  // namespace cairn::exercise16
