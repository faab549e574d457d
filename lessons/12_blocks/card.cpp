// Lesson 12. What the lesson says of itself.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson12(
    {.number = 12,
     .name = "blocks",
     .title = "What belongs together",
     .idea =
         "Sequential impulses may solve the rows of a joint together, as a block. That saves what these rows "
         "couple, and nothing of what couples one joint with another.",
     .paper = "paper 4.3, 4.4, 4.5",
     .equations = {"(22)  Aᵢᵢ Δλᵢ = (ζᵢ − jᵢ·v) / Δt             one row: a number to divide by",
                   "4.3   A_BB Δλ_B = (ζ_B − J_B v) / Δt          one joint: 2 rows of a pin, 3 of a weld",
                   "      A_BB = J_B M⁻¹ J_Bᵀ                     factorized once a step, not once a sweep"},
     .needs = {"lesson 03"},
     .reads = {"src/solvers/iterative/block_sequential_impulse.hpp",
               "tests/solvers/iterative/block_tests.cpp"},
     .question =
         "Beams in a chain, the first welded to a wall. One beam takes 16 sweeps row by row, and 1 with the "
         "three rows of its weld as a block: 6 %. Ten beams take 42967 sweeps row by row. Which share is "
         "left with their ten welds as blocks: about 1, 6, 50 or 97 %?",
     .spoilers = {"41751", "55 %", "no second beam", "zig-zag"},
     .unasked = {"angle", "inertia", "sweeps"},
     .wrong =
         {{{0},
           {3},
           "Less would be left if the rows inside a weld were the harder to settle, the longer the chain "
           "is. But there are always three. What grows with the chain?"},
          {{3},
           {30},
           "Each weld is right after one visit, as that of one beam is. But the next weld makes it "
           "wrong again, and its block does not know."},
          {{30},
           {91},
           "A block does end a part of the coupling. How much of what ten beams couple is inside the "
           "welds, and how much between one weld and the next?"}},
     .hints =
         {"A block ends the conflict between the rows of one joint. Are there others, and are there "
          "more of them in a longer chain?",
          "To the other joints a block acts like a single row: it stops its own error and starts one "
          "next door. One weld has no weld next door, and is right after one visit; ten have nine pairs.",
          "Look at a weld in the middle: do its own three rows spoil each other, or does the next weld spoil "
          "them?"},
     .parameters = {{"dt", 0.02, 0.005, 0.02, "s", "time step"},
                    {"angle", 45, 5, 85, "°", "of the rod above the horizontal"},
                    {"inertia", 1e-6, 1e-7, 1, "kg m^2", "of the bob: how hard it is to turn"},
                    {"sweeps", 5, 1, 20, "", "a step, for the bob", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 13   (a row that gives way)"});

}  // namespace cairn
