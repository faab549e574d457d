// Exercise 05, graded: a stack at rest, which has to carry its weight, and a row between two bodies that fly
// and turn.
#include "exercise.cpp"

namespace cairn::exercise05 {
namespace {

constexpr double dt = 0.02;  // [s]
const char* const two_bodies = "A row has two bodies, and both have a velocity and a force.";
const char* const sign = "The sign: b has −j·v₁, and v₁ is v plus M⁻¹ f Δt.";
const char* const three_numbers = "Three numbers a body: j·v has x, y and the angle.";

/// A unit box at rest, under gravity.
Body resting(double mass) {
  return {.inverse_mass = {1 / mass, 1 / mass, 6 / mass}, .force = {0, -10 * mass, 0}};
}

/// One number of b; NaN where the answer has not one for each row.
double number(int i, const List<Row>& rows, const List<Body>& bodies) {
  const List<double> b = right_side(rows, bodies, dt);
  return b.size() == rows.size() ? b[i] : std::nan("");
}

void grade_rest(Grade& grade) {
  const List<Body> bodies = {{}, resting(2), resting(0.5)};
  const List<Row> rows = {{.a = 0, .b = 1, .j_a = {0, -1, 0}, .j_b = {0, 1, 0}},
                          {.a = 1, .b = 2, .j_a = {0, -1, 0}, .j_b = {0, 1, 0}}};
  grade.number({.what = "2 kg on the ground, 0.5 kg on top, at rest: b_1 (m/s²)",
                .value = 10,
                .misconceptions = {{0, "b knows of no gravity, and a stack at rest then carries nothing."},
                                   {20, "A force changes v by M⁻¹ f Δt: M⁻¹ is missing."},
                                   {40, "A force changes v by M⁻¹ f Δt, not by M f Δt."},
                                   {500, "A force changes v by M⁻¹ f Δt: Δt is missing."},
                                   {-10, sign},
                                   {0.2, "b is an acceleration: a velocity divided by Δt."}}},
               number(0, rows, bodies));
  grade.number({.what = "between the two: b_2 (m/s²)",
                .value = 0,
                .misconceptions = {{10, two_bodies}, {-15, ""}, {-37.5, ""}}},
               number(1, rows, bodies));
}

void grade_flight(Grade& grade) {
  const List<Body> bodies = {
      {},
      {.inverse_mass = {0.5, 0.5, 3}, .velocity = {0.3, -0.4, 2}, .force = {4, -20, 1.5}},
      {.inverse_mass = {2, 2, 24}, .velocity = {-0.1, 0.2, -1}, .force = {0.5, -5, -0.25}}};
  const List<Row> rows = {{.a = 1, .b = 2, .j_a = {-0.6, -0.8, 0.1}, .j_b = {0.6, 0.8, -0.3}, .zeta = 0.05}};
  // v₁ is (0.34, −0.6, 2.09) and (−0.08, 0, −1.12), so j·v₁ is 0.773 m/s.
  grade.number({.what = "two that fly and turn, pushed from all sides: b (m/s²)",
                .value = -36.15,
                .misconceptions = {{-8.9, three_numbers},
                                   {-21.5, three_numbers},
                                   {-33.9, "A torque changes ω: M⁻¹ has 1/I, too."},
                                   {-38.6, "ζ is divided by Δt, too."},
                                   {-38.65, "ζ is missing."},
                                   {-41.15, "The row wants j·v = ζ: b has ζ/Δt with a plus."},
                                   {2.5, "j·v₁ is missing."},
                                   {50.85, "a is the first body, whose three numbers are j_a."},
                                   {-11.9, two_bodies},
                                   {-28.9, two_bodies}}},
               number(0, rows, bodies));
}

}  // namespace

Exercise exercise() {
  return {.lesson = 5,
          .task = "b of (15), for bodies on which forces act: a stack at rest has to carry its weight.",
          .file = "lessons/05_big_matrices/exercise.cpp",
          .hints = {"With the velocity of a stack at rest, b is 0. Which velocity does (15) mean by v₁?",
                    "By (12), forces that are no rows change v by M⁻¹ f Δt. Do that first, then form ζ/Δt − "
                    "j·v₁/Δt.",
                    "v₁ = v + M⁻¹ f Δt for each of the three numbers of both bodies; b_i = (ζ_i − j_a·v₁a − "
                    "j_b·v₁b)/Δt."},
          .grade = [](Grade& grade) {
            grade_rest(grade);
            grade_flight(grade);
          }};
}

}  // namespace cairn::exercise05
