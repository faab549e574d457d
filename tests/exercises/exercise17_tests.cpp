// Exercise 17: every misconception is told from the answer.
#include "lessons/17_tower/exercise.hpp"

#include <cmath>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise17 {
namespace {

double rate_of(int boxes) { return std::pow(std::cos(std::acos(-1.0) / (2.0 * boxes)), 2); }

int whole_above(double sweeps) { return static_cast<int>(std::ceil(sweeps)); }

int of_jacobi(int boxes, double share) { return whole_above(2 * std::log(share) / std::log(rate_of(boxes))); }

int rounded_down(int boxes, double share) {
  return static_cast<int>(std::log(share) / std::log(rate_of(boxes)));
}

int without_height(int, double share) { return whole_above(-std::log(share)); }

int mixed_logarithms(int boxes, double share) {
  return whole_above(-std::log10(share) / (1 - rate_of(boxes)));
}

}  // namespace

TEST_CASE("exercise 17 tells Jacobi's rate, a sweep too few, a tower without height and mixed logarithms") {
  CHECK(testing::tells<grade>(of_jacobi, "That is Jacobi"));
  CHECK(testing::tells<grade>(rounded_down, "One too few"));
  CHECK(testing::tells<grade>(without_height, "Where is the height"));
  CHECK(testing::tells<grade>(mixed_logarithms, "Mind the logarithms"));
}

}  // namespace cairn::exercise17
