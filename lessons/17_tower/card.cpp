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
     .question = "Ten boxes of 1\u00a0kg, ten sweeps a step. In step\u00a05 SI finds 133.51\u00a0N at the "
                 "ground, where 100\u00a0N would be right. Box2D has another author, other data and single "
                 "precision. By how many newtons does it differ from these 133.51\u00a0N: by about 30, 3 or "
                 "0.3, or by less than 0.001?",
     .spoilers = {"6.26", "0.00005"},
     .unasked = {"steps"},
     .wrong = {{{30}, {40}, "Then Box2D would be right, with ten sweeps. Ten are too few for anybody."},
               {{0.05},
                {30},
                "Both visit the same rows, in the same order, as often. What is left to differ?"}},
     .hints = {"What does a load depend on, if the rows, their order and the number of sweeps are given?",
               "Only on how the sums are rounded.",
               "Single precision keeps 24 bits, some seven digits, of 133.51\u00a0N."},
     .parameters = {{"bodies", 10, 1, 20, "", "boxes", Parameter::Kind::whole},
                    {"dt", 0.02, 0.001, 0.05, "s", "time step"},
                    {"gravity", 10, 0.1, 100, "m/s^2", "gravity, downwards"},
                    {"sweeps", 10, 1, 200, "", "sweeps in each step", Parameter::Kind::whole},
                    {"steps", 50, 10, 100, "", "steps of each run", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 18   (what one more digit costs)"});

}  // namespace cairn
