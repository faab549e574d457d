// Exercise 00, graded: one step and two of a box that is thrown, pushed and turned, a heavier one, shorter
// steps, and sixty steps.
#include "exercise.cpp"

namespace cairn::exercise00 {
namespace {

constexpr double dt = 0.02;         // [s]
constexpr double rounding = 1e-12;  // 180 sums of numbers below 10, each with an error of at most 1e-15
using Numbers = FixedList<double, 3>;
constexpr Numbers start_place = {-4, 1, 0.5}, start_velocity = {4, 5, -1}, force = {1, -16, 0.4};
constexpr Numbers box_of_2_kg = {0.5, 0.5, 3}, box_of_4_kg = {0.25, 0.25, 1.5};  // unit boxes: I = m/6

enum Axis { x, y, angle };

/// From a place to which the velocity of the beginning has led in one step.
Body flown(const Numbers& inverse_mass, int steps, double of_dt = dt) {
  Body body{.place = start_place, .inverse_mass = inverse_mass};
  for (int i = 0; i < 3; ++i) body.before[i] = start_place[i] - start_velocity[i] * of_dt;
  for (int k = 0; k < steps; ++k) advance(body, force, of_dt);
  return body;
}

/// Where a box is after some steps: each velocity of the two lines of the page, times dt, added up.
double place_by_formula(Axis axis, double acceleration, int steps, double of_dt = dt) {
  return start_place[axis] + start_velocity[axis] * steps * of_dt +
         acceleration * of_dt * of_dt * steps * (steps + 1) / 2;
}

ExpectedNumber after_one(const char* what, Axis axis, const Numbers& inverse_mass, double of_dt = dt) {
  const double w = inverse_mass[axis], f = force[axis], old = start_place[axis],
               moved = start_velocity[axis] * of_dt, change = w * f * of_dt * of_dt;
  const char* const two_dt = "dt comes in twice: once for the velocity, once for the place.";
  return {
      .what = what,
      .value = old + moved + change,
      .misconceptions =
          {{old, "The place has not changed: all three numbers of it do."},
           {old + change, "No force stops it: it goes on moving as it moved in the last step."},
           {old - moved + change, "The sign: what it has moved leads from before to place."},
           {old + moved, "The force has not changed the velocity."},
           {old + moved + w * f * of_dt, two_dt},
           {old + moved + w * f, two_dt},
           {old + moved + change / 2, "That is the parabola. Without the half it is semi-implicit Euler."},
           {old + moved + box_of_2_kg[axis] * f * of_dt * of_dt,
            "This box has 4 kg: take its own inverse mass."},
           {old + moved + f * of_dt * of_dt, "That is a force times dt²: M⁻¹ makes a change of place of it."},
           {old + moved + f / w * of_dt * of_dt, "M⁻¹ is inverted already: multiply by it."},
           {old + moved + inverse_mass[x] * f * of_dt * of_dt, "θ has its own inverse mass, 1/I."},
           {old + moved - change, "The sign: the force comes with its own."},
           {moved + change, "Add to the place: do not replace it."},
           {old + moved + (w * f - 10) * of_dt * of_dt, "The force is all that acts: add no gravity to it."},
           {old + moved + w * f * dt * dt, "The step has 0.008 s here: take dt, not a number of your own."}},
      .tolerance = rounding};
}

ExpectedNumber after_two(const char* what) {
  const double acceleration = box_of_2_kg[y] * force[y], change = acceleration * dt * dt;
  const double first = place_by_formula(y, acceleration, 1), moved = start_velocity[y] * dt;
  return {.what = what,
          .value = place_by_formula(y, acceleration, 2),
          .misconceptions = {{first + change, "Keep the old place in before, then change it."},
                             {first + (first - start_place[y] + moved) + change,
                              "before has to become the place that this step began with."}},
          .tolerance = rounding};
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 0,
      .task = "One step of semi-implicit Euler for a body that stores two places, and no velocity.",
      .file = "lessons/00_one_body/exercise.cpp",
      .hints = {"How far would the body go in this step if no force acted on it?",
                "The page's second line moves it by the new velocity times dt. Put the first line into it.",
                "Do it by hand for the page's box: before (−4.08, 0.88), place (−4, 1), next y = 1.116."},
      .grade = [](Grade& grade) {
        const Body body = flown(box_of_2_kg, 1), heavy = flown(box_of_4_kg, 1);
        grade.number(after_one("2 kg, one step of 0.02 s: x (m)", x, box_of_2_kg), body.place[x]);
        grade.number(after_one("2 kg, one step of 0.02 s: y (m)", y, box_of_2_kg), body.place[y]);
        grade.number(after_one("2 kg, one step of 0.02 s: θ (rad)", angle, box_of_2_kg), body.place[angle]);
        grade.number(after_one("4 kg, the same force: y (m)", y, box_of_4_kg), heavy.place[y]);
        grade.number(after_one("2 kg, one step of 0.008 s: y (m)", y, box_of_2_kg, 0.4 * dt),
                     flown(box_of_2_kg, 1, 0.4 * dt).place[y]);
        grade.number(after_two("2 kg, two steps of 0.02 s: y (m)"), flown(box_of_2_kg, 2).place[y]);
        grade.number({.what = "2 kg, 60 steps of 0.02 s: y (m)",
                      .value = place_by_formula(y, box_of_2_kg[y] * force[y], 60),
                      .tolerance = rounding},
                     flown(box_of_2_kg, 60).place[y]);
      }};
}

}  // namespace cairn::exercise00
