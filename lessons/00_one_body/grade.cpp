// Exercise 00, graded: a thrown body after 60 steps, and how far it is from the parabola.
#include "exercise.hpp"

namespace cairn::exercise00 {
namespace {

constexpr double gravity = 10, start_speed = 5, start_height = 1;  // [m/s^2], [m/s], [m]
constexpr double duration = 1.2;                                   // [s]
constexpr double sum_rounding = 1e-12;  // 120 sums of numbers below 10, each with an error of at most 1e-15

Falling flown(Answer answer, int steps) {
  Falling body{.height = start_height, .velocity = start_speed};
  for (int i = 0; i < steps; ++i) answer(body, -gravity, duration / steps);
  return body;
}

ExpectedNumber height_after(const char* what, int steps) {
  const double dt = duration / steps;
  const double parabola = start_height + start_speed * duration - gravity * duration * duration / 2;
  const double error = gravity * dt * duration / 2;  // of either Euler: below, or above
  return {.what = what,
          .value = parabola - error,
          .tolerance = sum_rounding,
          .misconceptions = {
              {parabola + error, "That is explicit Euler: the place was moved with the old velocity."},
              {parabola, "That is the parabola itself: right, and not what the engine does."},
              {start_height, "The height has not changed."},
              {start_height + start_speed * duration, "Gravity has not changed the velocity."}}};
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const Falling one = flown(answer, 60);
  grade.number(
      {.what = "60 steps of 0.02 s: velocity (m/s)",
       .value = start_speed - gravity * duration,
       .tolerance = sum_rounding,
       .misconceptions = {{start_speed - gravity * 60, "An acceleration times dt is a change of velocity."},
                          {start_speed + gravity * duration,
                           "The sign: the acceleration comes with its own."},
                          {start_speed, "The velocity has not changed."}}},
      one.velocity);
  grade.number(height_after("60 steps of 0.02 s: height (m)", 60), one.height);
  grade.number(height_after("120 steps of 0.01 s: height (m)", 120), flown(answer, 120).height);
}

Exercise exercise() {
  return {
      .lesson = 0,
      .task =
          "One step of semi-implicit Euler. With half of dt the error halves: watch the last two numbers.",
      .file = "lessons/00_one_body/exercise.cpp",
      .hints = {"Which of the two has to be new when the other is computed?",
                "The velocity first: it grows by acceleration times dt.",
                "Then the height grows by the new velocity times dt."},
      .grade = [](Grade& marks) { grade(marks, integrate); }};
}

}  // namespace cairn::exercise00
