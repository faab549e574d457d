// Lesson 05. What --help and --about say, and what may be changed.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson05(
    {.number = 5,
     .name = "big_matrices",
     .title = "Big matrices",
     .idea = "Stack the velocities of all bodies into v and all rows into J: the rows demand J v = ζ. The "
             "forces that make this true solve A λ = b, one equation for each row, all together.",
     .paper = "paper 2.1, 2.2, eq (1)-(15)",
     .equations =
         {"(11)  J v₂ = ζ                         what the step has to achieve",
          "(12)  v₂ = v₁ + M⁻¹ Jᵀ λ Δt            forces along the rows of J, each with a strength λ",
          "(14)  A λ = b                          (12) put into (11)",
          "(15)  A = J M⁻¹ Jᵀ,  b = ζ/Δt − J v₁/Δt"},
     .needs = {"lesson 03"},
     .reads = {"src/solvers/system_matrix.hpp", "src/solvers/system_matrix.cpp"},
     .question = "Three boxes of 1\u00a0kg stand on each other, and A\u00a0λ\u00a0=\u00a0b says that "
                 "their contacts carry 30, 20 and 10\u00a0N, from the ground up. With a box of "
                 "100\u00a0kg in place of the third it says 1020, 1010 and 1000\u00a0N. b has one number for "
                 "each contact. "
                 "How many of the three does the heavy box change?",
     .spoilers = {"None", "do not approach", "Only the lowest box", "10, 0, 0"},
     .unasked = {"top"},
     .wrong = {{{3},
                {3},
                "So it would if b held the weights. But b = (ζ − J v₁)/Δt: there is no mass in it."},
               {{1},
                {1},
                "You may think of the row of the heavy box. But a row looks at velocities, and the heavy box "
                "falls as fast as the light one."},
               {{2}, {2}, "A has the masses of both boxes of a row. b has only their velocities."}},
     .hints =
         {"Put (12) into (11): b is what stands beside A λ. Which of its letters would know that the box is "
          "heavy?",
          "−j·v₁ says how fast the two bodies of a contact approach each other, before any contact "
          "pushes.",
          "A box of 100 kg falls at g Δt, as one of 1 kg does. How fast do boxes 2 and 3 approach each "
          "other?"},
     .parameters = {{"boxes", 3, 2, 5, "", "boxes in the stack", Parameter::Kind::whole},
                    {"dt", 0.02, 0.005, 0.1, "s", "time step"},
                    {"top", 1, 0.01, 100, "kg", "mass of the uppermost box; the others have 1 kg"}},
     .cover = 1,
     .next = "bash lessons/run 6   (guess, fix one row, repeat; and rows that must not pull)"});

}  // namespace cairn
