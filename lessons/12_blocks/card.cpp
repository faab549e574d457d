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
         "Beams in a chain, the first welded to a wall. With the three rows of each weld as a block, one "
         "beam takes 6 % of the sweeps that it takes row by row, two beams 55 %, three beams 75 %. Which "
         "share do ten beams take: about 10, 50, 75 or 97 %?",
     .spoilers = {"41751", "no second beam", "zig-zag"},
     .unasked = {"angle", "inertia", "sweeps"},
     .wrong = {{{0},
                {30},
                "So little would be left if most of the coupling were within the welds. Every beam more adds "
                "coupling between welds, where a block does not help."},
               {{30},
                {70},
                "Three beams leave more already, and every further weld is coupled with its neighbours."},
               {{70},
                {91},
                "That is about what three beams leave. The share has grown with every beam: what should end "
                "that?"}},
     .hints =
         {"A block ends the conflict between the rows of one joint. Are there others, and are there "
          "more of them in a longer chain?",
          "To the other joints a block acts like a single row: it stops its own error and starts one "
          "next door. One weld has no weld next door, and is right after one visit; ten have nine pairs.",
          "What is left grows with every beam: 6, 55, 75 %. It cannot grow above 100."},
     .parameters = {{"dt", 0.02, 0.005, 0.02, "s", "time step"},
                    {"angle", 45, 5, 85, "°", "of the rod above the horizontal"},
                    {"inertia", 1e-6, 1e-7, 1, "kg m^2", "of the bob: how hard it is to turn"},
                    {"sweeps", 5, 1, 20, "", "a step, for the bob", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 13   (a row that gives way)"});

}  // namespace cairn
