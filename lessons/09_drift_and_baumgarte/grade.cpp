// Exercise 09, graded: single visits, and two balls that begin inside the ground.
#include "exercise.cpp"

namespace cairn::exercise09 {
namespace {

constexpr double rounding = 1e-13;  // a dozen operations on numbers near 1
constexpr double dt = 0.02;         // [s]

struct Visit {
  double gap = 0;  // [m]
  Rules rules = {};
  Body upper = {};
  Body lower = {};
};

/// The speeds after it [m/s].
Visit visited(Visit one) {
  visit(one.gap, one.rules, one.upper, one.lower);
  return one;
}

/// A ball of 2 kg and the ground: its speed afterwards [m/s].
double ball_speed(double gap, const Rules& rules, double speed) {
  return visited({gap, rules, {0.5, speed}, {}}).upper.speed;
}

/// Inside the ground.
void grade_depth(Grade& grade) {
  grade.number(
      {.what = "2 kg, 100 mm deep, β = 1, v = −0.2 m/s: speed after (m/s)",
       .value = 5,
       .misconceptions = {{-0.2, "The ground has not pushed. c is below 0 inside, and ζ = −β c/Δt above 0."},
                          {4.8, "The row asks for ζ in the end: what is missing is ζ − j·v."},
                          {4.6, "What is missing is ζ − j·v: a ball that comes closer needs more."},
                          {0.1, "The error is to be gone in one step: ζ = −β c/Δt, a velocity."},
                          {0, "ζ is 0 there: inside the ground the row asks for −β c/Δt."},
                          {2.4,
                           "Impulse = mass times velocity, and that push is half of it: divide by Σ 1/m."},
                          {-5.4, "The upper body is pushed up: its speed grows by the impulse times 1/m."}},
       .tolerance = rounding},
      ball_speed(-0.1, {1, 0, dt}, -0.2));
  grade.number({.what = "105 mm deep, β = 0.2, slop 5 mm",
                .value = 1,
                .misconceptions = {{1.05, "β takes its share of what is deeper than the slop only."},
                                   {1.1, "What is deeper than the slop is the depth less the slop."},
                                   {5, "β: the row removes a share of the error in each step, not all."},
                                   {1.045, "β takes its share of what is deeper than the slop only."}},
                .tolerance = rounding},
               ball_speed(-0.105, {0.2, 0.005, dt}, -0.2));
  grade.number({.what = "4 mm deep, slop 5 mm: 0, so it stays",
                .value = 0,
                .misconceptions = {{-0.01, "Within the slop the row asks for 0: it must not sink further."},
                                   {-0.2, "Within the slop the row asks for 0: it must not sink further."}},
                .tolerance = rounding},
               ball_speed(-0.004, {0.2, 0.005, dt}, -0.2));
}

/// Outside the ground, and on the way out.
void grade_gap(Grade& grade) {
  const char* const in_the_air =
      "Above the ground β has no part: ζ = −c/Δt, down to the surface in this step.";
  grade.number(
      {.what = "3 mm above, β = 0.2, v = −0.2 m/s",
       .value = -0.15,
       .misconceptions = {{0, "It hangs in the air: above the ground it may come down, ζ = −c/Δt."},
                          {-0.03, in_the_air},
                          {0.03, in_the_air},
                          {0.15, "Above the ground ζ is negative: it may come down by c."},
                          {-0.2, "It falls 1 mm into the ground: 3 mm are left for this step, ζ = −c/Δt."},
                          {-0.05, "The slop is a depth inside the ground; here is none."}},
       .tolerance = rounding},
      ball_speed(0.003, {0.2, 0.002, dt}, -0.2));
  grade.number({.what = "on the ground, v = 4.8 m/s upwards: it leaves",
                .value = 4.8,
                .misconceptions = {{0, "That pulls it back. A contact pushes only: no impulse below 0."}},
                .tolerance = rounding},
               ball_speed(0, {1, 0, dt}, 4.8));
}

/// 2 kg above 0.5 kg, 10 mm in each other, β = ½: ζ = 0.25 m/s, j·v = −1.5 m/s, Σ 1/m = 2.5 per kg: 0.7 N s.
void grade_two_bodies(Grade& grade) {
  const Visit two = visited({-0.01, {0.5, 0, dt}, {0.5, -1}, {2, 0.5}});
  grade.number(
      {.what = "2 kg on 0.5 kg, 10 mm, β = ½: speed of the upper (m/s)",
       .value = -0.65,
       .misconceptions = {{0.75, "Both bodies give way: j M⁻¹ jᵀ = 1/m + 1/m."},
                          {0.25, "j·v: the speed of the upper less that of the lower; and both give way."},
                          {-0.85, "j·v is the speed of the upper less that of the lower."},
                          {-0.75, "j·v is the speed of the upper less that of the lower."}},
       .tolerance = rounding},
      two.upper.speed);
  grade.number({.what = "and of the lower",
                .value = -0.9,
                .misconceptions = {{0.5, "What pushes the upper up, pushes the lower down."},
                                   {1.9, "The lower gets the opposite impulse."},
                                   {0.15, "Each body divides the impulse by its own mass."}},
                .tolerance = rounding},
               two.lower.speed);
  const Visit ceiling = visited({0, {0.5, 0, dt}, {0, 0}, {0.5, 3}});
  grade.number({.what = "2 kg meet a ceiling at 3 m/s: speed after (m/s)",
                .value = 0,
                .misconceptions = {{3, "The upper body may be the one that cannot move."},
                                   {std::nan(""), "The upper body may be the one that cannot move."},
                                   {-std::numeric_limits<double>::infinity(),
                                    "The upper body may be the one that cannot move."}},
                .tolerance = rounding},
               ceiling.lower.speed);
}

/// [m] How high a ball of 2 kg comes that begins at rest this deep.
double highest(double depth, double beta) {
  double height = -depth, top = height;
  Body ball{.inverse_mass = 0.5}, ground;
  for (int step = 0; step < 200; ++step) {
    ball.speed -= 10 * dt;
    visit(height, {beta, 0, dt}, ball, ground);
    height += ball.speed * dt;
    top = std::max(top, height);
  }
  return top;
}

}  // namespace

Exercise exercise() {
  return {.lesson = 9,
          .task = "One visit to a contact that removes its own error: ζ of both cases, λ, both bodies.",
          .file = "lessons/09_drift_and_baumgarte/exercise.cpp",
          .hints = {"The page has this row for a ball of 1 kg on the ground. What is j M⁻¹ jᵀ here?",
                    "ζ: above, −gap/Δt; inside, β/Δt times what is deeper than the slop, or 0.",
                    "The impulse is (ζ − j·v) / Σ 1/m, at least 0. The upper body gets it, the lower its "
                    "opposite."},
          .grade = [](Grade& grade) {
            grade_depth(grade);
            grade_gap(grade);
            grade_two_bodies(grade);
            // The page's ball. 200 steps of a few roundings of numbers up to 5.
            grade.number(
                {.what = "begins 100 mm deep, β = 1: rises to (m)", .value = 1.2, .tolerance = 1e-11},
                highest(0.1, 1));
            // By 20 mm in step 1; from then on the row asks for what the ball has, or more.
            grade.number(
                {.what = "with β = 0.2: above the surface by at most (m)", .value = 0, .tolerance = 1e-11},
                std::max(0.0, highest(0.1, 0.2)));
          }};
}

}  // namespace cairn::exercise09
