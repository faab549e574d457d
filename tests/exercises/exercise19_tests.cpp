// Exercise 19: every misconception is told from the answer.
#include "lessons/19_extremes/exercise.hpp"

#include <cmath>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise19 {
namespace {

double sweeps_of(double above, double below, double share) {
  return std::log(share) / std::log(above / (above + below));
}

int rounded_down(double above, double below, double share) {
  return static_cast<int>(sweeps_of(above, below, share));
}

int upside_down(double above, double below, double share) {
  return static_cast<int>(std::ceil(sweeps_of(below, above, share)));
}

int of_jacobi(double above, double below, double share) {
  return static_cast<int>(std::ceil(2 * sweeps_of(above, below, share)));
}

int with_mixed_logarithms(double above, double below, double share) {
  return static_cast<int>(std::ceil(std::log10(share) / std::log(above / (above + below))));
}

int below_at_rest(double above, double below, double share) {
  const double rate = 1 - below / above;
  return rate > 0 ? static_cast<int>(std::ceil(std::log(share) / std::log(rate))) : 1;
}

int by_the_rule_of_thumb(double above, double below, double) {
  return static_cast<int>(std::ceil(4.6 * above / below));
}

}  // namespace

TEST_CASE(
    "exercise 19 tells a sweep too few, boxes upside down, Jacobi, mixed logarithms and a box at rest") {
  CHECK(testing::tells<grade>(rounded_down, "One too few"));
  CHECK(testing::tells<grade>(by_the_rule_of_thumb, "asks for the exact number"));
  CHECK(testing::tells<grade>(upside_down, "Mind which box is above"));
  CHECK(testing::tells<grade>(of_jacobi, "That is Jacobi"));
  CHECK(testing::tells<grade>(with_mixed_logarithms, "Mind the logarithms"));
  CHECK(testing::tells<grade>(below_at_rest, "the light box falls too"));
}

}  // namespace cairn::exercise19
