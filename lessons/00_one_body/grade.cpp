// Exercise 00, graded: a box of 2 kg, thrown, pushed and turned for 60 steps, one of 4 kg under the same
// force, and the first one in half as long steps.
#include "exercise.cpp"

namespace cairn::exercise00 {
namespace {

constexpr double dt = 0.02, duration = 1.2;  // [s] 60 steps
constexpr double rounding = 1e-12;  // 120 sums of numbers below 10, each with an error of at most 1e-15
using Numbers = FixedList<double, 3>;
constexpr Numbers start_place = {-4, 1, 0.5}, start_velocity = {4, 5, -1}, force = {1, -16, 0.4};
constexpr Numbers box_of_2_kg = {0.5, 0.5, 3}, box_of_4_kg = {0.25, 0.25, 1.5};  // unit boxes: I = m/6

enum Axis { x, y, angle };

Body flown(const Numbers& inverse_mass, double of_dt = dt) {
  Body body{.place = start_place, .velocity = start_velocity, .inverse_mass = inverse_mass};
  for (int i = 0; i < 60; ++i) integrate(body, force, of_dt);
  return body;
}

/// What one of its rates is at the end, for a box of 2 kg.
ExpectedNumber rate_after(const char* what, Axis axis) {
  const double before = start_velocity[axis], w = box_of_2_kg[axis], f = force[axis];
  return {
      .what = what,
      .value = before + w * f * duration,
      .misconceptions =
          {{before, "The velocity has not changed: all three numbers of it do."},
           {before + w * f * 60, "An acceleration times dt is a change of velocity."},
           {before + f * duration, "That is a force times dt: M⁻¹ makes a change of velocity of it."},
           {before + f / w * duration, "M⁻¹ is inverted already: multiply by it."},
           {before - w * f * duration, "The sign: the force comes with its own."},
           {w * f * dt, "Add to the velocity: do not replace it."},
           {before + (w * f - 10) * duration, "The force is all that acts: add no gravity to it."},
           {before + box_of_2_kg[x] * f * duration, "θ has its own inverse mass, 1/I, the third number."}},
      .tolerance = rounding};
}

/// Where a box is at the end, on one axis.
ExpectedNumber place_after(const char* what, Axis axis, const Numbers& inverse_mass) {
  const double acceleration = inverse_mass[axis] * force[axis];
  const double exact =
      start_place[axis] + start_velocity[axis] * duration + acceleration * duration * duration / 2;
  const double error = acceleration * dt * duration / 2;  // of either Euler
  const double right = exact + error;
  const double other = box_of_2_kg[axis] * force[axis];
  return {
      .what = what,
      .value = right,
      .misconceptions =
          {{exact - error, "That is explicit Euler: the place was moved with the old velocity."},
           {exact, "That is the parabola itself: right, and not what the engine does."},
           {start_place[axis], "The place has not changed: all three numbers of it do."},
           {start_place[axis] + (right - start_place[axis]) / dt,
            "A velocity times dt is a change of place."},
           {start_place[axis] + start_velocity[axis] * duration, "The force has not changed the velocity."},
           {start_place[axis] - (right - start_place[axis]),
            "The sign: a body goes where its velocity points."},
           {(start_velocity[axis] + acceleration * duration) * dt, "Add to the place: do not replace it."},
           {right + (other - acceleration) * (duration + dt) * duration / 2,
            "This box has 4 kg: take its own inverse mass."}},
      .tolerance = rounding};
}

/// Where the box of 2 kg is after 60 steps of half the length.
ExpectedNumber place_after_half(const char* what) {
  const double half = dt / 2, time = duration / 2, acceleration = box_of_2_kg[y] * force[y];
  const double now = start_place[y] + start_velocity[y] * time;
  const double with_the_other = start_place[y] + start_velocity[y] * duration;
  return {.what = what,
          .value = now + acceleration * (time + half) * time / 2,
          .misconceptions = {{with_the_other + acceleration * (duration + dt) * duration / 2,
                              "The step has 0.01 s here: take dt, not a number of your own."}},
          .tolerance = rounding};
}

}  // namespace

Exercise exercise() {
  return {.lesson = 0,
          .task = "One step of semi-implicit Euler for a body: equation (12), and then its place.",
          .file = "lessons/00_one_body/exercise.cpp",
          .hints = {"Which of the two has to be new when the other is computed?",
                    "The velocity first: it grows by M⁻¹ f dt, number by number.",
                    "Then the place grows by the new velocity times dt, all three numbers of it."},
          .grade = [](Grade& grade) {
            const Body body = flown(box_of_2_kg), heavy = flown(box_of_4_kg);
            const Body shorter = flown(box_of_2_kg, dt / 2);
            grade.number(rate_after("2 kg, 60 steps of 0.02 s: v_y (m/s)", y), body.velocity[y]);
            grade.number(rate_after("2 kg, 60 steps of 0.02 s: ω (rad/s)", angle), body.velocity[angle]);
            grade.number(place_after("2 kg, 60 steps of 0.02 s: x (m)", x, box_of_2_kg), body.place[x]);
            grade.number(place_after("2 kg, 60 steps of 0.02 s: y (m)", y, box_of_2_kg), body.place[y]);
            grade.number(place_after("2 kg, 60 steps of 0.02 s: θ (rad)", angle, box_of_2_kg),
                         body.place[angle]);
            grade.number(place_after("4 kg, the same force: y (m)", y, box_of_4_kg), heavy.place[y]);
            grade.number(place_after_half("2 kg, 60 steps of 0.01 s: y (m)"), shorter.place[y]);
          }};
}

}  // namespace cairn::exercise00
