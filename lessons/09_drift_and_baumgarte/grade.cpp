// Exercise 09, graded: single values, and the second step of a ball with the β that was found.
#include "exercise.cpp"

namespace cairn::exercise09 {
namespace {

constexpr double few_roundings = 1e-14;  // of numbers near 1, after at most a dozen operations
const char* const not_below_slop =
    "β takes its share of what is deeper than the slop: subtract the slop from the depth.";

/// A page's ball, with numbers of its own.
ExpectedNumber without_slop(const char* what, const Sunk& ball) {
  const double right = ball.dt * std::sqrt(ball.gravity / ball.depth);
  const char* const fall = "There is no fall here, and no ½: the page has d ≤ g Δt²/β².";
  return {
      .what = what,
      .value = right,
      .misconceptions = {{right * right, "That is β². Take the root."},
                         {1, "Try it: with β = 1 the ball of the page has to be less deep than 4 mm."},
                         {right * std::sqrt(2), fall},
                         {right / std::sqrt(2), fall},
                         {right * std::sqrt(10 / ball.gravity),
                          "There is less gravity here: take the gravity of the ball."},
                         {right * 0.02 / ball.dt, "The step is not 0.02 s here: take the dt of the ball."}},
      .tolerance = few_roundings};
}

void grade_slop(Grade& grade) {
  const Sunk deep{.depth = 0.105, .slop = 0.005, .gravity = 10, .dt = 0.02};
  const double forgotten = 0.02 * std::sqrt(10 / 0.105);
  grade.number({.what = "105 mm deep with a slop of 5 mm: β",
                .value = 0.2,
                .misconceptions = {{forgotten, not_below_slop},
                                   {forgotten - 0.005, not_below_slop},
                                   {0.02 * std::sqrt(10 / 0.11), not_below_slop}},
                .tolerance = few_roundings},
               largest_beta(deep));
  grade.number({.what = "4 mm deep with a slop of 5 mm: β",
                .value = 1,
                .misconceptions = {{std::nan(""),
                                    "A number below 0 has no root: what is deeper than the slop is 0 here."},
                                   {0, "Within the slop the ball is not moved by any β: the largest is 1."}},
                .tolerance = few_roundings},
               largest_beta({.depth = 0.004, .slop = 0.005, .gravity = 10, .dt = 0.02}));
}

/// λ Δt² [m] of the second step of a ball of 1 kg with this β, before it is clamped: the ground still pushes
/// where it is above 0.
double second_push(const Sunk& ball, double beta) {
  const double speed = beta * (ball.depth - ball.slop) / ball.dt;
  const double left = ball.depth - speed * ball.dt - ball.slop;
  return (beta * left / ball.dt - (speed - ball.gravity * ball.dt)) * ball.dt;
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 9,
      .task = "The largest β with which the ground still pushes in step 2, for any depth, slop and step.",
      .file = "lessons/09_drift_and_baumgarte/exercise.cpp",
      .hints = {"The page says how deep a ball may be for a given β. Turn that round.",
                "A slop changes the depth that counts, in both steps. What if nothing of it is left?",
                "Do three by hand: 100 mm, 1 mm, and 4 mm with a slop of 5 mm. Two of them give the same β."},
      .grade = [](Grade& grade) {
        const Sunk moon{.depth = 0.3, .gravity = 1.6, .dt = 0.05};
        grade.number(
            without_slop("100 mm deep, 10 m/s², Δt = 0.02 s: β", {.depth = 0.1, .gravity = 10, .dt = 0.02}),
            largest_beta({.depth = 0.1, .gravity = 10, .dt = 0.02}));
        grade.number(without_slop("0.4 m deep, 10 m/s², Δt = 1/60 s: β",
                                  {.depth = 0.4, .gravity = 10, .dt = 1.0 / 60}),
                     largest_beta({.depth = 0.4, .gravity = 10, .dt = 1.0 / 60}));
        grade.number(without_slop("0.3 m deep, 1.6 m/s², Δt = 0.05 s: β", moon), largest_beta(moon));
        grade.number(
            {.what = "that ball: push of step 2, times Δt²/m (m)", .value = 0, .tolerance = few_roundings},
            second_push(moon, largest_beta(moon)));
        grade.number({.what = "1 mm deep, 10 m/s², Δt = 0.02 s: β",
                      .value = 1,
                      .misconceptions = {{2, "β is at most 1: above that, the error changes its sign."}},
                      .tolerance = few_roundings},
                     largest_beta({.depth = 0.001, .gravity = 10, .dt = 0.02}));
        grade_slop(grade);
      }};
}

}  // namespace cairn::exercise09
