// Exercise 02, graded: three places of the peg, and a point that is to move upwards.
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise02 {
namespace {

constexpr double dt = 0.02;                   // [s]
constexpr double rounding = 16 * 2.2204e-16;  // a few operations on numbers of this size

ExpectedNumber expected(const char* what, const Meeting& m) {
  const double gives = m.inverse_mass + m.arm * m.arm * m.inverse_inertia;
  const double change = m.wanted - m.speed;
  const double right = change / gives;
  return {
      .what = what,
      .value = right,
      .tolerance = rounding * std::abs(change) * (gives + 1 / gives) / dt,
      .misconceptions = {{-right, "The sign: the push has to take the speed away, not to double it."},
                         {right / dt, "That is the force λ in N. The impulse is λ times dt."},
                         {right * dt, "One dt too many: (22) divides by dt, the impulse multiplies by it."},
                         {change * gives, "Divide by j M⁻¹ jᵀ: what gives way easily needs less."},
                         {change, "That is the change of speed. How heavy is the body, here, this way?"},
                         {change / m.inverse_mass, "The body turns as well: where is the arm?"},
                         {change / (m.inverse_mass + m.arm * m.inverse_inertia),
                          "The arm comes in twice: once in j, once in jᵀ."},
                         {-m.speed / gives, "ζ is what j v₂ is to be: it is not always 0."}}};
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const Meeting middle{.inverse_mass = 1.0 / 6, .inverse_inertia = 1, .arm = 0, .speed = -1, .wanted = 0};
  Meeting quarter = middle, corner = middle, lifted = middle;
  quarter.arm = 0.25;
  corner.arm = -0.5;
  lifted.arm = 0.5;
  lifted.wanted = 0.3;
  grade.number(expected("peg at x = 0.25 m: impulse (N s)", quarter), answer(quarter));
  grade.number(expected("peg at x = -0.5 m: impulse (N s)", corner), answer(corner));
  grade.number(expected("peg at x = 0.5 m, to leave at 0.3 m/s: impulse (N s)", lifted), answer(lifted));
  grade.number(expected("peg under the middle: impulse (N s)", middle), answer(middle));
}

Exercise exercise() {
  return {.lesson = 2,
          .task = "The impulse that makes one point of a body move as it should: equation (22), times dt.",
          .file = "lessons/02_effective_mass/exercise.cpp",
          .hints = {"How fast does the point move after a push of 1 N s, if it stood still before?",
                    "A push of p changes the body by M⁻¹ jᵀ p, and its point by j M⁻¹ jᵀ p.",
                    "j = (0, 1, arm), so j M⁻¹ jᵀ = 1/m + arm²/I; the change that is wanted, divided by it."},
          .grade = [](Grade& marks) { grade(marks, impulse_of); }};
}

}  // namespace cairn::exercise02
