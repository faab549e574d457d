// Lesson 17: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson17(
    {.number = 17,
     .name = "tower",
     .title = "Three solvers, one tower",
     .idea = "PGS, SI, and a third program written elsewhere solve the same tower, with too few sweeps. All "
             "of them get it wrong. The question is how.",
     .paper = "paper 4.5, with Box2D 2.4.1",
     .equations = {"(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)          SI and Box2D",
                   "(28)  η_i ← (b_i − Σ_{j≠i} A_ij η_j) / A_ii    PGS"},
     .needs = {"lesson 03", "lesson 07"},
     .reads = {"src/reference/box2d_world.hpp", "tests/reference/tower_tests.cpp"},
     .question =
         "In step 5 SI finds 133.51\u00a0N at the ground, instead of 100\u00a0N. Box2D differs from SI in "
         "three "
         "ways: (1) it computes in single precision; (2) it solves both points of an interface together; (3) "
         "it visits the interfaces from the top down, if the boxes are created from the ground up. Which of "
         "these must be removed before all loads agree to 0.001\u00a0N?",
     .spoilers = {"0.00005", "fingerprint"},
     .wrong = {{{1}, {1}, "Single precision changes the loads by less than 0.0001 N."},
               {{2}, {2}, "These boxes cannot turn, so the two points of an interface demand the same."}},
     .hints = {"Single precision has about 7 digits, of which 100 N has three before the point.",
               "The boxes cannot turn. What do the two points of an interface ask for?",
               "Sweep once by hand, from λ = 0: what does the uppermost interface get, if it is the first?"},
     .parameters = {{"bodies", 10, 1, 20, "", "boxes", Parameter::Kind::whole},
                    {"dt", 0.02, 0.001, 0.05, "s", "time step"},
                    {"gravity", 10, 0.1, 100, "m/s^2", "gravity, downwards"},
                    {"sweeps", 10, 1, 200, "", "sweeps in each step", Parameter::Kind::whole},
                    {"steps", 50, 10, 100, "", "steps of each run", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 18   (what one more digit costs)"});

}  // namespace cairn
