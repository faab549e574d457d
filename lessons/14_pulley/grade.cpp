// Exercise 14, graded: one row update on two wheels, with the effective mass of the answer's own row.
#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise14 {
namespace {

constexpr double gear_rounding = 1e-13;  // a dozen operations on numbers below 100

struct Wheels {
  FixedList<double, 2> inverse_inertia = {2, 0.5};  // [1/(kg m^2)]
  FixedList<double, 2> omega = {3, 1};              // [rad/s]
};

/// Equation (22) and (23) with the row, once.
Wheels solved(const FixedList<double, 2>& j) {
  Wheels wheels;
  const double speed = j[0] * wheels.omega[0] + j[1] * wheels.omega[1];
  const double gives = j[0] * j[0] * wheels.inverse_inertia[0] + j[1] * j[1] * wheels.inverse_inertia[1];
  for (int k = 0; k < 2; ++k) wheels.omega[k] -= wheels.inverse_inertia[k] * j[k] * speed / gives;
  return wheels;
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const double a = 10, b = 20;
  const Wheels right = solved({a, b}), inside = solved({a, -b}), swapped = solved({b, a}),
               belt = solved({b, -a});
  const Wheels got = solved(answer(a, b));
  for (int k = 0; k < 2; ++k) {
    grade.number({.what = k == 0 ? "10 and 20 teeth: the small wheel turns at (rad/s)"
                                 : "10 and 20 teeth: the large wheel turns at (rad/s)",
                  .value = right.omega[k],
                  .tolerance = gear_rounding,
                  .misconceptions = {{inside.omega[k], "Wheels that mesh from outside turn opposite ways."},
                                     {swapped.omega[k],
                                      "The wheel with fewer teeth turns faster: which number belongs to it?"},
                                     {belt.omega[k],
                                      "The wheel with fewer teeth turns faster, and the other way round."}}},
                 got.omega[k]);
  }
  grade.number(
      {.what = "teeth that pass: 10 omega_a + 20 omega_b (1/s)", .value = 0, .tolerance = 10 * gear_rounding},
      a * got.omega[0] + b * got.omega[1]);
}

Exercise exercise() {
  return {.lesson = 14,
          .task = "A gear: the row of two wheels. No solver has to know of it.",
          .file = "lessons/14_pulley/exercise.cpp",
          .hints = {"How fast do the teeth of a wheel with n teeth pass the mesh, when it turns at omega?",
                    "n omega, up to a factor that both wheels share. From outside the one goes up where the "
                    "other goes down.",
                    "teeth_a omega_a + teeth_b omega_b = 0: these are the two entries."},
          .grade = [](Grade& marks) { grade(marks, gear_row); }};
}

}  // namespace cairn::exercise14
