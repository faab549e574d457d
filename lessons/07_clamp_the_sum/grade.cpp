// Exercise 07, graded: feet at several places, and from which distance on the wrong clamp does not show.
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise07 {
namespace {

constexpr double feet_rounding = 1e-15;  // a few operations on numbers below 1

/// How much more a box of 6 kg that lands with 10 m/s is given where each push is clamped, not the sum (N s).
double given_too_much(const Feet& feet, double coupling) {
  const double left = 1 / feet.mass + feet.left * feet.left / feet.inertia;
  const double right = 1 / feet.mass + feet.right * feet.right / feet.inertia;
  double each[2] = {0, 0}, sum[2] = {0, 0};
  for (int sweep = 0; sweep < 200; ++sweep) {
    each[0] += std::max(0.0, (10 - left * each[0] - coupling * each[1]) / left);
    each[1] += std::max(0.0, (10 - coupling * each[0] - right * each[1]) / right);
    sum[0] = std::max(0.0, (10 - coupling * sum[1]) / left);
    sum[1] = std::max(0.0, (10 - coupling * sum[0]) / right);
  }
  return each[0] + each[1] - sum[0] - sum[1];
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const Feet near{.mass = 6, .inertia = 1, .left = -0.25, .right = 0.25};
  Feet far = near, one_side = near;
  far.left = -0.5, far.right = 0.5;
  one_side.left = 0.1, one_side.right = 0.4;
  grade.number({.what = "feet at -0.25 and 0.25 m: A_12 (1/kg)",
                .value = 5.0 / 48,
                .tolerance = feet_rounding,
                .misconceptions = {{11.0 / 48, "That is A_11: the sign of a place counts."},
                                   {1.0 / 6, "The box turns as well."},
                                   {-1.0 / 16, "The box rises as a whole as well: 1/m."},
                                   {6 - 1.0 / 16, "The inverse mass: 1/m."}}},
               answer(near));
  grade.number(
      {.what = "feet at -0.5 and 0.5 m: A_12 (1/kg)", .value = 1.0 / 6 - 0.25, .tolerance = feet_rounding},
      answer(far));
  grade.number(
      {.what = "feet at 0.1 and 0.4 m: A_12 (1/kg)",
       .value = 1.0 / 6 + 0.04,
       .tolerance = feet_rounding,
       .misconceptions = {{1.0 / 6 - 0.04, "Feet at one side lift each other: the sign of a place counts."}}},
      answer(one_side));
  grade.number({.what = "near feet, each push clamped: too much is given (N s)",
                .value = 8160.0 / 121 - 60,
                .tolerance = 1e-9},
               given_too_much(near, answer(near)));
  grade.number(
      {.what = "far feet, each push clamped: too much is given (N s)", .value = 0, .tolerance = 1e-9},
      given_too_much(far, answer(far)));
}

Exercise exercise() {
  return {.lesson = 7,
          .task = "A_12: where it is not above 0, the wrong clamp does not show.",
          .file = "lessons/07_clamp_the_sum/exercise.cpp",
          .hints = {"Push the left foot with 1 N s. How fast does the box rise, and how fast does it turn?",
                    "1/m, and left/I. How fast is a point at `right` then?", "1/m + left right / I."},
          .grade = [](Grade& marks) { grade(marks, coupling); }};
}

}  // namespace cairn::exercise07
