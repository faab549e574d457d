// Lesson 13. What the lesson says of itself.
#include "lessons/card.hpp"

namespace cairn {

LessonInfo card() {
  return {
      .number = 13,
      .name = "soft",
      .title = "A row that gives way",
      .idea =
          "A spring need not be a force. A row that gives way by γ for every unit of its own impulse is a "
          "spring, once β and γ come from its stiffness and its damping.",
      .paper = "paper 4.3, with eq (7), (15), (22)",
      .equations = {"4.3   j·v + γ λ Δt = ζ = −β c / Δt               (11) of a row that gives way",
                    "      γ = 1 / (Δt (d + Δt k)),  β = Δt k / (d + Δt k)",
                    "(15)  (A + γ) λ = b                               PGS: γ on the diagonal of A",
                    "(22)  Δλ = (ζ − j·v − γ λ Δt) / ((A_ii + γ) Δt)   SI: one more term, in one class"},
      .needs = {"lesson 03", "lesson 06"},
      .reads = {"src/constraints/softness.hpp", "src/solvers/iterative/sequential_impulse.cpp"},
      .question =
          "The spring gets stiffer and stiffer, and its γ goes to 0. Where does β go, and how far "
          "(in mm) does the weight sag then? (two numbers)",
      .spoilers = {"goes to 1", "rigid row", "stiffest", "sag to 0"},
      .hints = {"Which of the two terms in d + Δt k grows faster with the frequency?",
                "k grows like its square, d in proportion: Δt k / (d + Δt k) is nearly Δt k / Δt k.",
                "A row with γ = 0 is one of lesson 03. Which β takes all of its error back in one step?"},
      .parameters = {{"frequency", 2, 1, 100, "Hz", "of the spring, as it would swing undamped"},
                     {"damping", 0.5, 0.1, 2, "", "ratio; 1 is the fastest return without overshoot"},
                     {"dt", 0.02, 0.005, 0.05, "s", "time step"},
                     {"mass", 1, 0.01, 100, "kg", "of each weight"},
                     {"pressed", 0.2, 0, 0.3, "m", "how far the spring is pressed together at the start"}},
      .cover = 1,
      .next = "bash lessons/run 14   (one row on as many bodies as it likes)"};
}

}  // namespace cairn
