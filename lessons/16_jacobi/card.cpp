// Lesson 16: its card.
#include "lessons/card.hpp"

namespace cairn {

LessonInfo card() {
  return {
      .number = 16,
      .name = "jacobi",
      .title = "Everybody at once",
      .idea =
          "Rows that wait for nobody can all be computed at the same time, and their order means nothing. "
          "But rows that share a body then correct the same error several times over.",
      .paper = "paper 4.4",
      .equations = {"(22)  λᵢ ← λᵢ + ω (ζᵢ − jᵢ·v) / (Dᵢᵢ Δt)    for all rows i, with the same v; then clamp",
                    "(21)  v ← v + M⁻¹ Jᵀ Δλ Δt                 all of it acts, once",
                    "      ω · largest eigenvalue of D⁻¹ A < 2  or it need not converge",
                    "      plain: Dᵢᵢ = Aᵢᵢ, ω = 1; damped: ω < 1; split: each body's part of Aᵢᵢ times its "
                    "number of rows"},
      .needs = {"lesson 06", "lesson 11"},
      .reads = {"src/solvers/iterative/jacobi.hpp", "src/solvers/iterative/jacobi.cpp",
                "src/solvers/row_order.hpp"},
      .question =
          "A box that weighs 60 N stands on three feet (--feet). Each pushes as if it were alone, and all do "
          "so at once. How much do they push together in the first sweep, in newtons?",
      .hints = {"The foot in the middle, alone, has to carry everything.",
                "A foot at the side also turns the box: it stops its own corner with less, 1 / A_ii.",
                "A_ii = 1/6 + r²/1, for three feet with r = −0.25, 0, 0.25 m; each gives 10 / A_ii newtons."},
      .parameters = {{"feet", 3, 2, 8, "", "feet under the box", Parameter::Kind::whole},
                     {"omega", 0.3, 0.1, 1, "", "what the damped form gives of each correction"},
                     {"base", 4, 2, 6, "", "boxes in the pyramid's lowest row", Parameter::Kind::whole}},
      .cover = -2,
      .next = "bash lessons/run 17   (the solvers beside a third one, by somebody else)"};
}

}  // namespace cairn
