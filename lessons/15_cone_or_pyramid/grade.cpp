// Exercise 15, graded: pucks whose friction is beyond the circle, within it, and between circle and square.
#include "exercise.cpp"

namespace cairn::exercise15 {
namespace {

constexpr double circle_rounding = 1e-14;  // a few operations on numbers near 4

Puck braked(Puck puck, double normal_force, double friction, double dt) {
  brake(puck, normal_force, friction, dt);
  return puck;
}

/// 2 kg at (3, 4) m/s: stopped by 10 N s, and friction has 0.4 × 15 × 0.02 = 0.12 N s, a share of 0.012.
/// Whether that is what is given along x.
bool grade_outside(Grade& grade) {
  const Puck puck = braked({.mass = 2, .vx = 3, .vy = 4}, 15, 0.4, 0.02);
  const auto is_near = [&puck](double value) { return std::abs(puck.vx - value) <= circle_rounding; };
  const char* const larger = "The length of (x, y) is sqrt(x² + y²), not the larger of the two.";
  grade.number(
      {.what = "2 kg at (3, 4) m/s, μN = 6 N, 0.02 s: v_x (m/s)",
       .value = 3 * (1 - 0.012),
       .tolerance = circle_rounding,
       .misconceptions = {{3, "Nothing has been applied."},
                          {0, "Nothing was clamped: friction has no more than μNΔt."},
                          {3 - 0.12 / 2, "Each part for itself: that is a square."},
                          {3 * (1 - 0.6), "μN is a force: an impulse has at most μNΔt."},
                          {3 * (1 - 2 * 0.012),
                           "The limit is an impulse: compare it with m v, and divide by m what acts."},
                          {3 * (1 - 0.016), "The limit has the normal force in it, not m g."},
                          {3 * (1 - 0.0008), "Where is the normal force?"},
                          {3 * (1 - 0.03), "Where is μ?"},
                          {3 * (1 - 0.015), larger},
                          {3 * (1 - 0.12 / 14), "The length of (x, y) is sqrt(x² + y²), not the sum."},
                          {3 * (1 - 0.012 * 0.02), "One Δt too many: the limit is μNΔt."},
                          {3 * 0.012, "That is what is left: the share acts, and not the rest of it."},
                          {3 * (1 + 0.012), "The sign: friction acts against v."},
                          {3 * (1 - 0.0012), "Divide by the length, not by its square."}}},
      puck.vx);
  const double length_after_x = std::hypot(6 * 0.012, 8);
  grade.number(
      {.what = "the same: v_y (m/s)",
       .value = 4 * (1 - 0.012),
       .tolerance = circle_rounding,
       .misconceptions = {{4 - 0.12 / 2,
                           is_near(3 * (1 - 0.015)) ? larger : "Each part for itself: that is a square."},
                          {4 * (1 - 0.12 / length_after_x),
                           "The length is that of both as they were: x has already been changed."},
                          {4, is_near(3) ? "" : "The other row has to act, too."}}},
      puck.vy);
  return is_near(3 * (1 - 0.012)) || is_near(3 - 0.12 / 2) || is_near(3 * (1 - 0.015));
}

/// 0.5 kg at (0.06, −0.08) m/s: stopped by 0.05 N s, and friction has 0.4 × 8 × 0.04 = 0.128 N s.
void grade_inside(Grade& grade) {
  const Puck inside = braked({.mass = 0.5, .vx = 0.06, .vy = -0.08}, 8, 0.4, 0.04);
  grade.number(
      {.what = "0.5 kg at (0.06, −0.08) m/s, μN = 3.2 N, 0.04 s: v_x (m/s)",
       .value = 0,
       .tolerance = circle_rounding,
       .misconceptions = {{0.06 * (1 - 0.128 / 0.05), "An impulse within the circle stays as it is."},
                          {-0.06, "The impulse that stops it is m v: a light puck needs less."}}},
      inside.vx);
  grade.number(
      {.what = "the same: v_y (m/s)",
       .value = 0,
       .tolerance = circle_rounding,
       .misconceptions = {{-0.08, inside.vx == 0 ? "Within the circle both parts stop." : ""},
                          {-0.16,
                           inside.vx != 0 ? "" : "Both parts keep their signs: x and y are those of −m v."}}},
      inside.vy);
  grade.number({.what = "a puck at rest, without a load: v_x (m/s)",
                .value = 0,
                .tolerance = circle_rounding,
                .misconceptions = {{std::nan(""), "A puck at rest has no direction: 0 by 0 is no share."}}},
               braked({.mass = 2}, 0, 0.4, 0.04).vx);
}

/// 0.5 kg at (−0.18, 0.18) m/s: stopped by (0.09, −0.09) N s, and friction has 0.4 × 5 × 0.05 = 0.1 N s.
void grade_between(Grade& grade, bool clamps) {
  grade.number(
      {.what = "0.5 kg at (−0.18, 0.18) m/s, μN = 2 N, 0.05 s: v_x (m/s)",
       .value = -0.18 * (1 - 0.1 / std::hypot(0.09, 0.09)),
       .tolerance = circle_rounding,
       .misconceptions = {{0, clamps ? "Inside the square, but outside the circle: clamp the length." : ""}}},
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
            const bool clamps = grade_outside(grade);
            grade_inside(grade);
            grade_between(grade, clamps);
          }};
}

}  // namespace cairn::exercise15
