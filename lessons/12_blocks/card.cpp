// Lesson 12. What the lesson says of itself.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson12(
    {.number = 12,
     .name = "blocks",
     .title = "What belongs together",
     .idea =
         "The rows of one joint act on the same two bodies. Sequential impulses may solve them together, as "
         "a block, and then they cannot work against each other.",
     .paper = "paper 4.3, 4.4, 4.5",
     .equations = {"(22)  Aᵢᵢ Δλᵢ = (ζᵢ − jᵢ·v) / Δt             one row: a number to divide by",
                   "4.3   A_BB Δλ_B = (ζ_B − J_B v) / Δt          one joint: 2 rows of a pin, 3 of a weld",
                   "      A_BB = J_B M⁻¹ J_Bᵀ                     factorized once a step, not once a sweep"},
     .needs = {"lesson 03"},
     .reads = {"src/solvers/iterative/block_sequential_impulse.hpp",
               "tests/solvers/iterative/block_tests.cpp"},
     .question =
         "Beams in a chain, the first welded to a wall. To 1 %, one beam takes 16 sweeps row by row, and 1 "
         "with its weld as a block. Two beams take 110 row by row. How many do they take with a block for "
         "each of their two welds: about 2, about 20, about 60, or all 110?",
     .spoilers = {"61", "55 %", "326", "75 %", "zig-zag"},
     .unasked = {"angle", "inertia", "sweeps"},
     .wrong = {{{1},
                {49},
                "So few would do if most of the conflict were within the welds. Much of it is between them: "
                "what a block corrects at one weld, it spoils at the other."},
               {{73},
                {110},
                "The first weld has rows that disturb each other much, and there a block "
                "helps."}},
     .hints =
         {"A block ends the conflict between the rows of one joint. Are there others, and are there "
          "more of them in a longer chain?",
          "To the other joints a block acts like a single row: it stops its own error and starts one "
          "next door. One weld has no weld next door, and is right after one visit; two have each other.",
          "A little more than half of the 110 sweeps remain."},
     .parameters = {{"dt", 0.02, 0.005, 0.02, "s", "time step"},
                    {"angle", 45, 5, 85, "°", "of the rod above the horizontal"},
                    {"inertia", 1e-6, 1e-7, 1, "kg m^2", "of the bob: how hard it is to turn"},
                    {"sweeps", 5, 1, 20, "", "a step, for the bob", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 13   (a row that gives way)"});

}  // namespace cairn
