// Lesson 13. What the lesson says of itself.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson13(
    {.number = 13,
     .name = "soft",
     .title = "A row that gives way",
     .idea = "A spring can be a row instead of a force. The row asks for less velocity, by γ for every N s "
             "that it has given. β and γ follow from the spring's stiffness and damping.",
     .paper = "paper 4.3, with eq (7), (15), (22)",
     .equations = {"4.3   j·v + γ λ Δt = ζ = −β c / Δt               (11) of a row that gives way",
                   "      γ = 1 / (Δt (d + Δt k)),  β = Δt k / (d + Δt k)",
                   "(15)  A λ = b                                     PGS: with γ added on the diagonal of A",
                   "(22)  Δλ = (ζ − j·v − γ λ Δt) / ((A_ii + γ) Δt)   SI: one more term, in one class"},
     .needs = {"lesson 03", "lesson 09"},
     .reads = {"src/constraints/softness.hpp", "src/solvers/iterative/sequential_impulse.cpp"},
     .question =
         "A weight of 1 kg stands on a spring of 2 Hz with damping ratio ½. It starts at rest, 200 mm too "
         "low. As a force the spring would begin with k\u00a0·\u00a00.2\u00a0m\u00a0=\u00a031.6\u00a0N. As a "
         "soft row, does it push harder than that in its first step of 0.02\u00a0s, or less? With how many "
         "newtons?",
     .spoilers = {"26.4", "less than the force", "30.5"},
     .wrong =
         {{{31.5},
           {31.7},
           "That is the force at the start of the step. A soft row takes the force at "
           "its end, when the spring has given way."},
          {{31.8},
           {200},
           "The weight moves up within the step. Then the spring is less pressed, and its damper resists."},
          {{27.7}, {31.4}, "Less, yes. How much less follows from the end of the step."},
          {{21.4},
           {21.8},
           "Gravity takes nothing from the spring's push. It moves the weight by itself, and (22) has it in "
           "j·v."},
          {{0},
           {25.2},
           "Less, yes, but not by so much. How far up is the weight at the end of the step, and how fast?"}},
     .hints = {"A row is solved for the velocity that the step ends with. Where is the weight then?",
               "λ = −k (c + Δt v') − d v', and v' = Δt (λ / m − g): two equations for λ and v'.",
               "k = 157.9 N/m and d = 12.57 N s/m: λ (1 + Δt (d + Δt k)) = 31.58 + 3.14."},
     .parameters = {{"frequency", 2, 1, 100, "Hz", "of the spring without its damper"},
                    {"damping", 0.5, 0.1, 2, "", "ratio; 1 is the fastest return without overshoot"},
                    {"dt", 0.02, 0.005, 0.05, "s", "time step"},
                    {"mass", 1, 0.01, 100, "kg", "of each weight"},
                    {"pressed", 0.2, 0, 0.3, "m", "how far the spring is pressed together at the start"}},
     .cover = 1,
     .next = "bash lessons/run 14   (one row on any number of bodies)"});

}  // namespace cairn
