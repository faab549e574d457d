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
     .question = "Ten boxes of 1\u00a0kg, ten sweeps from λ\u00a0=\u00a00. SI visits the interfaces from the "
                 "ground up and "
                 "finds 35.24\u00a0N at the ground and 11.08\u00a0N under box 5. Box2D visits them from the "
                 "top down. It, "
                 "too, finds 35.24\u00a0N at the ground. How many newtons does it find under box 5?",
     .spoilers = {"6.26", "0.00005"},
     .unasked = {"steps"},
     .wrong = {{{11}, {11.2}, "That the load at the ground agrees does not mean that the others do."},
               {{50}, {70}, "Ten sweeps are far too few for the weight above: 60 N."},
               {{12},
                {40},
                "From the top down, what the ground gives comes later to a box above, not sooner."}},
     .hints = {"Sweep once by hand, from λ = 0: what does the uppermost interface get, if it is the first?",
               "From the top down, what the ground gives climbs by one contact in each sweep.",
               "The load under box 5 is four sweeps late: it is what SI has there after six sweeps."},
     .parameters = {{"bodies", 10, 1, 20, "", "boxes", Parameter::Kind::whole},
                    {"dt", 0.02, 0.001, 0.05, "s", "time step"},
                    {"gravity", 10, 0.1, 100, "m/s^2", "gravity, downwards"},
                    {"sweeps", 10, 1, 200, "", "sweeps in each step", Parameter::Kind::whole},
                    {"steps", 50, 10, 100, "", "steps of each run", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 18   (what one more digit costs)"});

}  // namespace cairn
