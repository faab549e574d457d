// Lesson 17: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson17(
    {.number = 17,
     .name = "tower",
     .title = "Three solvers, one tower",
     .idea = "PGS, SI, and a third program written elsewhere solve the same tower, with too few sweeps. All "
             "of them get it wrong, and their wrong numbers are a fingerprint of the algorithm.",
     .paper = "paper 4.5, with Box2D 2.4.1",
     .equations = {"(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)          SI and Box2D",
                   "(28)  η_i ← (b_i − Σ_{j≠i} A_ij η_j) / A_ii    PGS"},
     .needs = {"lesson 03", "lesson 07"},
     .reads = {"src/reference/box2d_world.hpp", "tests/reference/tower_tests.cpp"},
     .question =
         "Ten boxes, ten sweeps. In step\u00a05 SI, from the ground up, finds 133.51\u00a0N at the "
         "ground and 85.83\u00a0N under box\u00a05. A stranger's program finds 133.51\u00a0N and "
         "88.52\u00a0N. Where does this difference come from: (1) it rounds to single precision, (2) it "
         "solves A λ\u00a0=\u00a0b, as PGS does, (3) it visits the contacts from the top down, (4) it makes "
         "eleven "
         "sweeps?",
     .spoilers = {"four sweeps late", "0.00005"},
     .unasked = {"steps"},
     .wrong = {{{1},
                {1},
                "It does round, but single precision keeps seven digits: that changes no load by more than "
                "0.00005\u00a0N."},
               {{2},
                {2},
                "PGS and SI do the same, term by term (lesson 07): they differ by less than 10⁻¹³\u00a0N."},
               {{4}, {4}, "An eleventh sweep changes the load at the ground, too, to 134.34\u00a0N."}},
     .hints = {"Seven digits of 133.51\u00a0N: how large can a rounding be?",
               "Who is next to the ground has found the same. What is different for a box in the middle?",
               "How many sweeps does it take until box 5 hears of the ground, in either order?"},
     .parameters = {{"bodies", 10, 1, 20, "", "boxes", Parameter::Kind::whole},
                    {"dt", 0.02, 0.001, 0.05, "s", "time step"},
                    {"gravity", 10, 0.1, 100, "m/s^2", "gravity, downwards"},
                    {"sweeps", 10, 1, 200, "", "sweeps in each step", Parameter::Kind::whole},
                    {"steps", 50, 10, 100, "", "steps of each run", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 18   (what one more digit costs)"});

}  // namespace cairn
