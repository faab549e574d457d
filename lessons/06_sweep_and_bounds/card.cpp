// Lesson 06. What --help and --about say, and what may be changed.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson06(
    {.number = 6,
     .name = "sweep_and_bounds",
     .title = "Sweep, and clamp",
     .idea =
         "Guess all λ. Put one row right, then the next, and sweep again: that is Gauss-Seidel. Clamp each "
         "λ to its interval, and it also solves contacts, which can only push: projected Gauss-Seidel.",
     .paper = "paper 2.2, eq (14), (28), and the interval at its end",
     .equations =
         {"(14)  A λ = b                                     all rows together: lesson 05",
          "(28)  λ_i ← (b_i − Σ_{j≠i} A_ij λ_j) / A_ii       one row, with the newest λ of the others",
          "2.2   λ_i ← max(λ_min, min(λ_i, λ_max))           a contact: 0 ≤ λ"},
     .needs = {"lesson 04", "lesson 05"},
     .reads = {"src/solvers/iterative/projected_gauss_seidel.cpp", "src/constraints/row.hpp"},
     .question =
         "A rod of 4 kg and 3 m lies with its left end on one support; the other stands 1\u00a0m from "
         "there. "
         "A\u00a0λ\u00a0=\u00a0b says: the left support pulls with 20\u00a0N, the right one pushes with "
         "60\u00a0N. But the left one cannot pull. How hard does the right one push then, in N?",
     .spoilers = {"30 N", "tips"},
     .unasked = {"dt", "sweeps"},
     .wrong = {{{59}, {61}, "That needs the pull of the left support, which it cannot give."},
               {{39},
                {41},
                "That balances the forces, but not the moments: the rod tips, and falls while "
                "it does."},
               {{61.001}, {1000}, "Without the pull there is less to push against, not more."}},
     .hints = {"Without the pull, does the right support have more to push against, or less?",
               "Only one point of the rod is held. The rest of it may fall.",
               "λ₂ = b₂ / A₂₂, with A₂₂ = 1/4 + 0.5²/3 and b₂ = 10 m/s²."},
     .parameters = {{"dt", 0.02, 0.005, 0.1, "s", "time step"},
                    {"sweeps", 10, 3, 100, "", "sweeps", Parameter::Kind::whole},
                    {"support", 1, 0.5, 3, "m", "from the left end of the rod to the right support"}},
     .cover = 1,
     .next = "bash lessons/run 7   (two stories of the same rows, side by side)"});

}  // namespace cairn
