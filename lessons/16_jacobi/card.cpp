// Lesson 16: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson16(
    {.number = 16,
     .name = "jacobi",
     .title = "Nobody waits",
     .idea =
         "If no row waits for another, all of them can be computed at the same time, and their order means "
         "nothing. But rows that share a body do not know of each other.",
     .paper = "paper 4.4",
     .equations = {"(22)  λᵢ ← λᵢ + ω (ζᵢ − jᵢ·v) / (Dᵢᵢ Δt)    for all rows i, at the same v; then clamp",
                   "(21)  v ← v + M⁻¹ Jᵀ Δλ Δt                 all of them act, once",
                   "      ω · largest eigenvalue of D⁻¹ A < 2  or it may not converge",
                   "      plain: Dᵢᵢ = Aᵢᵢ, ω = 1; damped: ω < 1; split: each body's part of Aᵢᵢ times its "
                   "number of rows"},
     .needs = {"lesson 03", "lesson 11"},
     .reads = {"src/solvers/iterative/jacobi.hpp", "src/solvers/iterative/jacobi.cpp",
               "src/solvers/row_order.hpp"},
     .question =
         "A box of 6\u00a0kg (60\u00a0N) with an inertia of 1\u00a0kg\u00a0m² is set down at rest on three "
         "feet: one under its middle, one 0.25\u00a0m to either side. Gravity has acted for one step. Each "
         "foot "
         "pushes as if it were alone, and all push together. What is the sum of their pushes after the first "
         "sweep, and after the second?",
     .spoilers = {"147.3", "0.291", "27/11"},
     .unasked = {"omega", "base"},
     .wrong = {{{59, 0}, {61, 400}, "So much they push if each knows of the others. Here none does."},
               {{179, 0},
                {181, 400},
                "Only the middle foot takes the whole weight. A push off the middle also "
                "turns the box, so it takes less."},
               {{146, 20},
                {149, 400},
                "After the first sweep the box goes up. What does each foot ask for then?"}},
     .hints = {"The foot in the middle, alone, stops the whole fall: 60 N.",
               "A foot at the side also turns the box, so it stops its own point with less.",
               "A_ii = 1/6 + r²/1, for three feet with r = −0.25, 0, 0.25 m; each gives 10 / A_ii newtons. "
               "Then the box "
               "goes up, and a contact cannot pull."},
     .parameters = {{"feet", 3, 2, 8, "", "feet under the box", Parameter::Kind::whole},
                    {"omega", 0.3, 0.1, 1, "", "share of each correction that damped Jacobi gives"},
                    {"base", 4, 2, 6, "", "boxes in the pyramid's lowest row", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 17   (two solvers of Cairn beside one by somebody else)"});

}  // namespace cairn
