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
         "Beams in a chain, the first welded to a wall. To 1 %, one beam takes 16 sweeps row by row and 1 "
         "with its weld as a block; two take 110 and 61. Three take 435 row by row. How many of these remain "
         "with blocks: (1) few, as for one beam; (2) half, as for two; (3) three quarters; (4) nearly all?",
     .spoilers = {"326", "75 %", "three in four", "zig-zag"},
     .unasked = {"angle", "inertia", "sweeps"},
     .wrong = {{{1},
                {1},
                "That would be so if most of the conflict were within the welds. It is "
                "between them."},
               {{2}, {2}, "The second beam adds a place where two welds meet, and so does the third."},
               {{4},
                {4},
                "The first weld has rows that disturb each other much, and there a block "
                "helps."}},
     .hints = {"A block ends the conflict between the rows of one joint. Are there others, and are there "
               "more of them in a longer chain?",
               "To the other joints a block acts like a single row: it stops its own error and starts one "
               "next door. One weld has no weld next door, and keeps 6 % of its sweeps; two keep 55 %.",
               "Three in four of the sweeps remain."},
     .parameters = {{"dt", 0.02, 0.005, 0.02, "s", "time step"},
                    {"angle", 45, 5, 85, "°", "of the rod above the horizontal"},
                    {"inertia", 1e-6, 1e-7, 1, "kg m^2", "of the bob: how hard it is to turn"},
                    {"sweeps", 5, 1, 20, "", "a step, for the bob", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 13   (a row that gives way)"});

}  // namespace cairn
