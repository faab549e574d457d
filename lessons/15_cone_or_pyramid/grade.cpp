// Exercise 15, graded: pucks whose friction is beyond the circle, within it, and between circle and square.
#include "exercise.cpp"

namespace cairn::exercise15 {
namespace {

constexpr double circle_rounding = 1e-14;  // a few operations on numbers near 4

Puck braked(Puck puck, double normal_force, double friction, double dt) {
  brake(puck, normal_force, friction, dt);
  return puck;
}

/// 2 kg at (3, 4) m/s: stopped by 10 N s, and friction has 0.4 × 10 × 0.02 = 0.08 N s, a share of 0.008.
void grade_outside(Grade& grade) {
  const Puck puck = braked({.mass = 2, .vx = 3, .vy = 4}, 10, 0.4, 0.02);
  grade.number({.what = "2 kg at (3, 4) m/s, μN = 4 N, 0.02 s: v_x (m/s)",
                .value = 3 * (1 - 0.008),
                .tolerance = circle_rounding,
                .misconceptions = {{3, "Nothing has been applied."},
                                   {0, "Nothing was clamped: friction has no more than μNΔt."},
                                   {3 - 0.08 / 2, "Each part for itself: that is a square."},
                                   {3 * (1 - 0.4), "μN is a force: an impulse has at most μNΔt."},
                                   {3 * (1 - 2 * 0.008), "An impulse is no change of velocity: divide by m."},
                                   {3 * (1 - 0.02), "Where is μ?"},
                                   {3 * (1 + 0.008), "The sign: friction acts against v."},
                                   {3 * (1 - 0.0008), "Divide by the length, not by its square."}}},
               puck.vx);
  const double length_after_x = std::hypot(6 * 0.008, 8);
  grade.number({.what = "the same: v_y (m/s)",
                .value = 4 * (1 - 0.008),
                .tolerance = circle_rounding,
                .misconceptions = {{4 - 0.08 / 2, "Each part for itself: that is a square."},
                                   {4 * (1 - 0.08 / length_after_x),
                                    "The length is that of both as they were: x has already been changed."},
                                   {4, "The other row has to act, too."}}},
               puck.vy);
}

/// 0.5 kg at (0.06, −0.08) m/s: stopped by 0.05 N s, and friction has 0.4 × 8 × 0.04 = 0.128 N s.
void grade_inside(Grade& grade) {
  grade.number(
      {.what = "0.5 kg at (0.06, −0.08) m/s, μN = 3.2 N, 0.04 s: v_x (m/s)",
       .value = 0,
       .tolerance = circle_rounding,
       .misconceptions = {{0.06 * (1 - 0.128 / 0.05), "An impulse within the circle stays as it is."},
                          {-0.06, "The impulse that stops it is m v: a light puck needs less."}}},
      braked({.mass = 0.5, .vx = 0.06, .vy = -0.08}, 8, 0.4, 0.04).vx);
  grade.number(
      {.what = "a puck at rest, without a load: v_x (m/s)", .value = 0, .tolerance = circle_rounding},
      braked({.mass = 2}, 0, 0.4, 0.04).vx);
}

/// 0.5 kg at (−0.18, 0.18) m/s: stopped by (0.09, −0.09) N s, and friction has 0.4 × 5 × 0.05 = 0.1 N s.
void grade_between(Grade& grade) {
  grade.number({.what = "0.5 kg at (−0.18, 0.18) m/s, μN = 2 N, 0.05 s: v_x (m/s)",
                .value = -0.18 * (1 - 0.1 / std::hypot(0.09, 0.09)),
                .tolerance = circle_rounding,
                .misconceptions = {{0, "Inside the square, but outside the circle: clamp the length."}}},
               braked({.mass = 0.5, .vx = -0.18, .vy = 0.18}, 5, 0.4, 0.05).vx);
}

}  // namespace

Exercise exercise() {
  return {.lesson = 15,
          .task = "One step of friction from above: one clamp for both rows, a circle instead of a square.",
          .file = "lessons/15_cone_or_pyramid/exercise.cpp",
          .hints =
              {"How long is the impulse that would stop the puck, and how long may it be?",
               "It is -m v. If it is too long, both parts shrink by the same factor.",
               "limit / length, with limit = μNΔt and length = sqrt(x x + y y); 1 where it is short enough."},
          .grade = [](Grade& grade) {
            grade_outside(grade);
            grade_inside(grade);
            grade_between(grade);
          }};
}

}  // namespace cairn::exercise15
