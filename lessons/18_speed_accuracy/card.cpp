// Lesson 18: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson18(
    {.number = 18,
     .name = "speed_accuracy",
     .title = "What does one more digit cost?",
     .idea = "Accuracy is bought with sweeps. What a digit costs depends on the scene and on the solver, and "
             "least on the machine.",
     .paper = "paper 4.4, eq (22), (28)",
     .equations =
         {"      error after k sweeps ≈ constant × ρᵏ          one digit: ln 10 / −ln ρ sweeps",
          "(28)  Gauss-Seidel, PGS or SI:  ρ = cos²(π/2n)     for a tower of n boxes",
          "      Jacobi, half steps:       ρ = cos²(π/4n)",
          "      SOR, Δλ times ω:          ρ = ω − 1            at the best ω = 2 / (1 + sin(π/2n))"},
     .needs = {"lesson 03", "lesson 16"},
     .reads = {"src/solvers/solver.hpp", "lessons/sandbox/CHOOSING.md"},
     .question =
         "Ten boxes: after 85 sweeps of SI 10\u00a0% of the error is left, after 178 sweeps 1\u00a0%. How "
         "many sweeps leave a billionth, 10⁻⁹?",
     .spoilers = {"829", "0.9755", "same share"},
     .unasked = {"omega", "sweeps"},
     .wrong = {{{760},
                {775},
                "The first digit is the cheapest: it also takes away errors that vanish "
                "quickly."},
               {{1590}, {1610}, "178 sweeps gave two digits, not one."}},
     .hints = {"What did the second digit cost? And what is different about the third?",
               "In the end each sweep leaves cos²(π/2n) of the error, however small it is.",
               "One digit for 85 sweeps, and eight more at the price of the second."},
     .parameters = {{"bodies", 10, 2, 30, "", "boxes", Parameter::Kind::whole},
                    {"omega", 0, 0, 1.99, "", "relaxation of SOR; 0: the best"},
                    {"sweeps", 10, 1, 100, "", "sweeps in each step of the warm run",
                     Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 19   (where it breaks, and how you notice)"});

}  // namespace cairn
