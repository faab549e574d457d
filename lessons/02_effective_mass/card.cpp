// Lesson 02. What --help and --about say, and what may be changed.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson02(
    {.number = 2,
     .name = "effective_mass",
     .title = "How heavy is a corner?",
     .idea = "How hard must one push be to give one point of a body the right velocity? One number of the "
             "row and "
             "its bodies answers that: the effective mass.",
     .paper = "paper 3.1, eq (16)-(23)",
     .equations = {"(19)  v₂ = v₁ + M⁻¹ p_c        what an impulse does: M⁻¹ of (17), v of (16), p_c of (18)",
                   "(20)  0 = ζ − j·v₂             what it has to achieve; here ζ = 0",
                   "(21)  p_c = jᵀ λ Δt            where it may act: along j",
                   "(22)  λ = (ζ − j·v₁) / (j M⁻¹ jᵀ Δt)   and so p_c = jᵀ (ζ − j·v₁) / (j M⁻¹ jᵀ), eq (23)"},
     .needs = {"lesson 01"},
     .reads = {"src/constraints/row.hpp", "src/solvers/iterative/sequential_impulse.cpp"},
     .question =
         "A unit box of 6\u00a0kg (I\u00a0=\u00a01\u00a0kg\u00a0m²) falls at 1\u00a0m/s on a fixed peg. "
         "Below its centre, the peg stops it "
         "with 6\u00a0N\u00a0s. Below its corner, does it take more or less to stop the point above the "
         "peg, and how many N\u00a0s? The rest of the box may go on.",
     .spoilers = {"2.4 N s", "2.4 kg", "less than half"},
     .unasked = {"dt"},
     .wrong = {{{6},
                {6},
                "That is the push below the centre. Off the centre a push also turns the box, "
                "so the point gives way more easily."},
               {{6.001},
                {1000},
                "More would be needed if something kept the box from turning. But it turns, "
                "and the point gives way more easily."}},
     .hints = {"Only the point above the peg has to stop. The rest of the box may go on.",
               "j = (0, 1, x) for a push upwards at x, and a unit box of 6 kg has I = 1 kg m².",
               "j M⁻¹ jᵀ = 1/6 + 0.5²/1 = 5/12 per kg."},
     .parameters = {{"mass", 6, 0.01, 1000, "kg", "mass of the box"},
                    {"speed", 1, 0.01, 10, "m/s", "how fast it falls"},
                    {"x", 0.5, 0.01, 0.5, "m", "the last place of the peg, right of the centre"},
                    {"dt", 0.02, 0.0001, 0.1, "s", "time step"}},
     .cover = 1,
     .next = "bash lessons/run 3   (the boxes of a stack, one push after the other)"});

}  // namespace cairn
