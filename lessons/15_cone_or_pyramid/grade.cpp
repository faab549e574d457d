// Exercise 15, graded: vectors inside, outside and on the axes.
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise15 {
namespace {

constexpr double circle_rounding = 1e-15;  // a few operations on numbers near 1

struct Push {
  double x = 0;
  double y = 0;
};

Push clamped(Answer answer, Push push, double limit) {
  answer(push.x, push.y, limit);
  return push;
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const Push outside = clamped(answer, {3, 4}, 1);
  grade.number(
      {.what = "(3, 4) N s, limit 1: x (N s)",
       .value = 0.6,
       .tolerance = circle_rounding,
       .misconceptions = {{1, "Each part for itself: that is a square, and (1, 1) is longer than 1."},
                          {std::sqrt(0.5), "The direction has changed: scale both parts by the same factor."},
                          {0.12, "Divide by the length, not by its square."},
                          {3, "Nothing was clamped."}}},
      outside.x);
  grade.number(
      {.what = "(3, 4) N s, limit 1: y (N s)",
       .value = 0.8,
       .tolerance = circle_rounding,
       .misconceptions = {{1, "Each part for itself: that is a square, and (1, 1) is longer than 1."},
                          {4 / std::hypot(0.6, 4),
                           "The length is that of both as they were: x must not be changed before."}}},
      outside.y);
  const Push inside = clamped(answer, {0.3, -0.4}, 1);
  grade.number({.what = "(0.3, -0.4) N s, limit 1: y (N s)",
                .value = -0.4,
                .tolerance = circle_rounding,
                .misconceptions = {{-0.8, "What is within the circle stays as it is."}}},
               inside.y);
  grade.number({.what = "(-0.8, 0.8) N s, limit 1: x (N s)",
                .value = -std::sqrt(0.5),
                .tolerance = circle_rounding,
                .misconceptions = {{-0.8, "Inside the square, but outside the circle."}}},
               clamped(answer, {-0.8, 0.8}, 1).x);
  grade.number({.what = "(0, 0) N s, limit 0: x (N s)", .value = 0, .tolerance = circle_rounding},
               clamped(answer, {0, 0}, 0).x);
}

Exercise exercise() {
  return {
      .lesson = 15,
      .task = "One clamp for both friction rows: a circle instead of a square.",
      .file = "lessons/15_cone_or_pyramid/exercise.cpp",
      .hints =
          {"How long is the vector, and how long may it be?",
           "If it is too long, both parts shrink by the same factor.",
           "limit / length, where length is sqrt(x x + y y); and nothing at all where it is short enough."},
      .grade = [](Grade& marks) { grade(marks, clamp_to_circle); }};
}

}  // namespace cairn::exercise15
