// Exercise 00, graded: a thrown body after 60 steps, and how far it is from the parabola.
#include "exercise.cpp"

namespace cairn::exercise00 {
namespace {

constexpr double gravity = 10, start_speed = 5, start_height = 1;  // [m/s^2], [m/s], [m]
constexpr double gravity_of_the_moon = 1.62;                       // [m/s^2]
constexpr double duration = 1.2;                                   // [s]
constexpr double sum_rounding = 1e-12;  // 120 sums of numbers below 10, each with an error of at most 1e-15

Falling flown(double acceleration, int steps) {
  Falling body{.height = start_height, .velocity = start_speed};
  for (int i = 0; i < steps; ++i) integrate(body, acceleration, duration / steps);
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
              {start_height + (parabola - error - start_height) / dt,
               "A velocity times dt is a change of height."},
              {start_height + start_speed * duration, "Gravity has not changed the velocity."}}};
}

void grade_velocities(Grade& grade) {
  grade.number(
      {.what = "60 steps of 0.02 s: velocity (m/s)",
       .value = start_speed - gravity * duration,
       .tolerance = sum_rounding,
       .misconceptions = {{start_speed - gravity * 60, "An acceleration times dt is a change of velocity."},
                          {start_speed + gravity * duration,
                           "The sign: the acceleration comes with its own."},
                          {-gravity * duration / 60, "Add to the velocity: do not replace it."},
                          {start_speed, "The velocity has not changed."}}},
      flown(-gravity, 60).velocity);
  grade.number({.what = "60 steps on the Moon: velocity (m/s)",
                .value = start_speed - gravity_of_the_moon * duration,
                .tolerance = sum_rounding,
                .misconceptions = {{start_speed - gravity * duration,
                                    "On the Moon too? Use the acceleration that the function gets."}}},
               flown(-gravity_of_the_moon, 60).velocity);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 0,
      .task =
          "One step of semi-implicit Euler. With half of dt the error halves: watch the last two numbers.",
      .file = "lessons/00_one_body/exercise.cpp",
      .hints = {"Which of the two has to be new when the other is computed?",
                "The velocity first: it grows by acceleration times dt.",
                "Then the height grows by the new velocity times dt."},
      .grade = [](Grade& grade) {
        grade_velocities(grade);
        grade.number(height_after("60 steps of 0.02 s: height (m)", 60), flown(-gravity, 60).height);
        grade.number(height_after("120 steps of 0.01 s: height (m)", 120), flown(-gravity, 120).height);
      }};
}

}  // namespace cairn::exercise00
