// Exercise 02, graded: bodies of 2 kg and 0.5 kg, a point that has to move upwards, and one that rises too
// fast.
#include <cmath>

#include "exercise.cpp"

namespace cairn::exercise02 {
namespace {

constexpr double rounding = 16 * 2.2204e-16;  // a few operations on numbers of this size

ExpectedNumber expected(const char* what, const Meeting& m) {
  const double gives = m.inverse_mass + m.arm * m.arm * m.inverse_inertia;
  const double change = m.wanted - m.speed;
  const double right = change / gives;
  const char* const signs = "The signs: (22) has ζ − j·v₁, and a point that rises has j·v₁ above 0.";
  return {
      .what = what,
      .value = right,
      .tolerance = rounding * std::abs(change) * (gives + 1 / gives),
      .misconceptions = {
          {-right, "The sign: the push has to take the speed away, not to double it."},
          {right / m.dt, "That is the force λ in N. The impulse is λ Δt."},
          {right * m.dt, "One Δt too many: (22) divides by Δt, the impulse multiplies by it."},
          {change * gives, "Divide by j M⁻¹ jᵀ: what yields easily needs less."},
          {change, "That is the change of velocity. Multiply it by the effective mass."},
          {change / m.inverse_mass, "The body turns as well: where is the arm?"},
          {change / (m.inverse_mass + std::abs(m.arm) * m.inverse_inertia),
           "The arm comes in twice: once in j, once in jᵀ."},
          {1 / gives, "That is the effective mass. Multiply it by the change of velocity."},
          {-m.speed / gives, "ζ is what j·v₂ has to be: it is not always 0."},
          {(m.wanted + m.speed) / gives, signs},
          {-(m.wanted + m.speed) / gives, signs},
          {m.wanted / gives, "How fast is the point before? (22) has ζ − j·v₁."},
          {0, "Nothing is clamped here: where the point is too fast, the impulse is negative."},
          {change / (m.arm * m.arm * m.inverse_inertia), "The body moves as a whole, too: where is 1/m?"},
          {change / (1 / m.inverse_mass + m.arm * m.arm / m.inverse_inertia),
           "These are inverses already: do not invert them again."},
          {change / (m.inverse_mass + m.arm * m.arm * m.inverse_mass), "Weigh the arm with 1/I, not 1/m."}}};
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 2,
      .task =
          "The impulse that gives one point of a body the velocity it should have: equation (22), times Δt.",
      .file = "lessons/02_effective_mass/exercise.cpp",
      .hints = {"How fast does the point move after a push of 1 N s, if it stood still before?",
                "A push of p changes the body by M⁻¹ jᵀ p, and its point by j M⁻¹ jᵀ p.",
                "j = (0, 1, arm), so j M⁻¹ jᵀ = 1/m + arm²/I. Divide the wanted change by it."},
      .grade = [](Grade& grade) {
        // 2 kg and 0.4 kg m², then 0.5 kg and 0.05 kg m².
        const Meeting heavy{
            .inverse_mass = 0.5, .inverse_inertia = 2.5, .arm = 0.25, .speed = -3, .dt = 0.02};
        const Meeting light{.inverse_mass = 2, .inverse_inertia = 20, .arm = -0.5, .speed = -3, .dt = 0.01};
        Meeting lifted = heavy, middle = light;
        lifted.wanted = 0.3;
        Meeting slowed = lifted;
        slowed.speed = 1;
        middle.arm = 0;
        grade.number(expected("2 kg, peg at x = 0.25 m: impulse (N s)", heavy), impulse_of(heavy));
        grade.number(expected("0.5 kg, peg at x = -0.5 m: impulse (N s)", light), impulse_of(light));
        grade.number(expected("2 kg, to leave at 0.3 m/s: impulse (N s)", lifted), impulse_of(lifted));
        grade.number(expected("2 kg, rises at 1 m/s, to leave at 0.3 m/s: impulse (N s)", slowed),
                     impulse_of(slowed));
        grade.number(expected("0.5 kg, peg under the middle: impulse (N s)", middle), impulse_of(middle));
      }};
}

}  // namespace cairn::exercise02
