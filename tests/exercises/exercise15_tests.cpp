// Exercise 15: every misconception is told from the answer.
#include "lessons/15_cone_or_pyramid/exercise.hpp"

#include <algorithm>
#include <cmath>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise15 {
namespace {

void to_square(double& x, double& y, double limit) {
  x = std::clamp(x, -limit, limit);
  y = std::clamp(y, -limit, limit);
}

void to_diagonal(double& x, double& y, double limit) {
  x = std::copysign(limit * std::sqrt(0.5), x);
  y = std::copysign(limit * std::sqrt(0.5), y);
}

void by_square(double& x, double& y, double limit) {
  const double squared = x * x + y * y;
  x *= limit / squared;
  y *= limit / squared;
}

void always_on_circle(double& x, double& y, double limit) {
  const double length = std::hypot(x, y);
  x *= limit / length;
  y *= limit / length;
}

void one_after_the_other(double& x, double& y, double limit) {
  x *= limit / std::hypot(x, y);
  y *= limit / std::hypot(x, y);
}

}  // namespace

TEST_CASE(
    "exercise 15 tells a square, a changed direction, a squared length, a short vector made long and parts "
    "scaled one by one") {
  CHECK(testing::tells<grade>(to_square, "that is a square"));
  CHECK(testing::tells<grade>(to_square, "outside the circle"));
  CHECK(testing::tells<grade>(to_diagonal, "The direction has changed"));
  CHECK(testing::tells<grade>(by_square, "not by its square"));
  CHECK(testing::tells<grade>(always_on_circle, "stays as it is"));
  CHECK(testing::tells<grade>([](double&, double&, double) {}, "Nothing was clamped"));
  CHECK(testing::tells<grade>(one_after_the_other, "x must not be changed"));
}

}  // namespace cairn::exercise15
