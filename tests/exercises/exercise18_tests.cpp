// Exercise 18: every misconception is told from the answer.
#include "lessons/18_speed_accuracy/exercise.hpp"

#include <cmath>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise18 {
namespace {

double jacobi_rate(int boxes) { return std::cos(std::acos(-1.0) / (2.0 * boxes)); }

double of_root(double rate) { return 2 / (1 + std::sqrt(1 - rate)); }

}  // namespace

TEST_CASE(
    "exercise 18 tells Gauss-Seidel, a rate not squared or squared twice, another angle, and too bold a "
    "step") {
  CHECK(testing::tells<grade>([](int) { return 1.0; }, "Gauss-Seidel"));
  CHECK(
      testing::tells<grade>([](int boxes) { return of_root(jacobi_rate(boxes)); }, "belongs under the root"));
  CHECK(testing::tells<grade>([](int boxes) { return of_root(std::pow(jacobi_rate(boxes), 4)); },
                              "not that of Gauss-Seidel"));
  CHECK(testing::tells<grade>([](int boxes) { return 2 / (1 + std::sin(std::acos(-1.0) / boxes)); },
                              "The angle"));
  CHECK(testing::tells<grade>([](int) { return 2.0; }, "At 2"));
  CHECK(testing::tells<grade>([](int) { return 1.0; }, "A neighbour does better"));
}

}  // namespace cairn::exercise18
