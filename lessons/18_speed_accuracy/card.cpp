// Lesson 18: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson18(
    {.number = 18,
     .name = "speed_accuracy",
     .title = "What does one more digit cost?",
     .idea =
         "Accuracy is bought with sweeps, and after the first few every digit has the same price. The scene "
         "and the solver decide which.",
     .paper = "paper 4.4, eq (22), (28)",
     .equations =
         {"      error after k sweeps ≈ constant × ρᵏ          one digit: ln 10 / −ln ρ sweeps",
          "(28)  Gauss-Seidel, PGS or SI:  ρ = cos²(π/2n)     for a tower of n boxes",
          "      Jacobi, ω = ½:            ρ = cos²(π/4n)",
          "      SOR, Δλ times ω:          ρ = ω − 1            at the best ω = 2 / (1 + sin(π/2n))"},
     .needs = {"lesson 03", "lesson 16"},
     .reads = {"src/solvers/solver.hpp", "lessons/sandbox/CHOOSING.md"},
     .question =
         "Ten boxes: after 178 sweeps of SI 1\u00a0% of the error is left. Now multiply every correction by "
         "1.73 before you give it, and change nothing else. How many sweeps leave 1\u00a0%?",
     .spoilers = {"21 sweeps", "7.3", "829"},
     .wrong = {{{95}, {110}, "That is 178 / 1.73. But what is left multiplies from sweep to sweep."},
               {{170},
                {2000},
                "Too much for one row is not too much for the tower: its neighbours give way."}},
     .hints =
         {"A contact that is right for a moment is not right for long: its neighbours go on changing, all "
          "in the same direction.",
          "SI leaves 0.9755 of the error in a sweep. With the best ω it is ω − 1, however small the error "
          "is.",
          "0.73 to the power of k is 1 %; and some sweeps more, since the first ones leave 0.83 to 0.85."},
     .parameters = {{"bodies", 10, 2, 30, "", "boxes", Parameter::Kind::whole},
                    {"omega", 0, 0, 1.99, "", "relaxation of SOR; 0: the best"}},
     .cover = 1,
     .next = "bash lessons/run 19   (where it breaks, and how you notice)"});

}  // namespace cairn
