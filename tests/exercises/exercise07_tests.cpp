// Exercise 07: every misconception is told from the answer.
#include "lessons/07_clamp_the_sum/exercise.hpp"

#include <cmath>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise07 {
TEST_CASE(
    "exercise 07 tells a place without its sign, a box that does not turn or rise, and a mass for its "
    "inverse") {
  CHECK(testing::tells<grade>([](const Feet& f) { return 1 / f.mass - f.left * f.right / f.inertia; },
                              "the sign of a place"));
  CHECK(testing::tells<grade>(
      [](const Feet& f) { return 1 / f.mass - std::abs(f.left * f.right) / f.inertia; }, "Feet at one side"));
  CHECK(testing::tells<grade>([](const Feet& f) { return 1 / f.mass; }, "turns as well"));
  CHECK(
      testing::tells<grade>([](const Feet& f) { return f.left * f.right / f.inertia; }, "rises as a whole"));
  CHECK(testing::tells<grade>([](const Feet& f) { return f.mass + f.left * f.right / f.inertia; },
                              "The inverse mass"));
}

}  // namespace cairn::exercise07
