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
     .question = "Three boxes of 1\u00a0kg fall at 0.2\u00a0m/s, because gravity has acted for one step of "
                 "0.02\u00a0s. In the end their contacts carry 30, 20 and 10\u00a0N, from the ground up. "
                 "Of "
                 "A\u00a0λ\u00a0=\u00a0b, b has a number for each contact: (ζ\u00a0−\u00a0j·v)/Δt, with "
                 "ζ\u00a0=\u00a00. "
                 "What are these numbers, from the ground up, in m/s²?",
     .spoilers = {"b₂ and b₃", "10, 0, 0", "do not approach", "Only the lowest box"},
     .wrong = {{{30, 20, 10},
                {30, 20, 10},
                "These are the forces. b says how fast bodies approach each other without "
                "them."},
               {{10, 10, 10},
                {10, 10, 10},
                "All boxes fall equally fast, but a row looks at the difference between its two "
                "bodies."},
               {{-10, 0, 0},
                {-10, 0, 0},
                "The sign is wrong: b has −j·v, and j·v is negative where bodies approach "
                "each other."}},
     .hints = {"b looks at the two bodies of a contact, not at one.",
               "b = ζ/Δt − j·v₁/Δt, and −j·v₁ says how fast the two approach each other.",
               "Both boxes fall at g Δt. How fast do they approach each other?"},
     .parameters = {{"boxes", 3, 2, 5, "", "boxes in the stack", Parameter::Kind::whole},
                    {"dt", 0.02, 0.005, 0.1, "s", "time step"},
                    {"top", 1, 0.01, 100, "kg", "mass of the uppermost box; the others have 1 kg"},
                    {"sunk", 0, 0, 0.02, "m", "how deep the lowest box is inside the ground, β = 0.2"}},
     .cover = 1,
     .next = "bash lessons/run 6   (guess, fix one row, repeat; and rows that must not pull)"});

}  // namespace cairn
