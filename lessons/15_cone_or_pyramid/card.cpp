// Lesson 15. What the lesson says of itself.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson15(
    {.number = 15,
     .name = "cone_or_pyramid",
     .title = "Cone or pyramid",
     .idea = "Seen from above, friction has two axes, and a row for each. Clamp each row, and the limit is a "
             "square; clamp the length of the vector, and it is a circle. They brake a puck differently.",
     .paper = "paper 4.5, the interval of λ in 2.2, eq (22)",
     .equations =
         {"(22)     λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)         one row for each axis",
          "square   |λ_x| ≤ μ λ_n,  |λ_y| ≤ μ λ_n          two clamps: the pyramid, cut across",
          "circle   √(λ_x² + λ_y²) ≤ μ λ_n                one clamp, of the vector: the cone, cut across"},
     .needs = {"lesson 03", "lesson 11"},
     .reads = {"src/constraints/friction_joint.hpp", "src/constraints/row.hpp"},
     .question =
         "A puck of 1\u00a0kg starts at v = (3,\u00a04)\u00a0m/s on a table that presses back with "
         "λ_n\u00a0=\u00a010\u00a0N; μ is 0.5. With the length of its friction clamped to μ λ_n it "
         "stops 2.45\u00a0m from its start, at (1.47,\u00a01.96)\u00a0m. At which place does it stop if "
         "λ_x and λ_y are each clamped to μ λ_n?",
     .spoilers = {"1.79", "0.87", "diamond"},
     .wrong =
         {{{1.4, 1.85},
           {1.55, 2.05},
           "There it stops if the length of λ is clamped. A square allows more towards its corners."},
          {{0.98, 1.3},
           {1.12, 1.49},
           "So it would be if √2 μ λ_n acted against v all the way. But the corner does not point against "
           "v, and one axis comes to rest before the other."},
          {{0.4, 0.7}, {0.5, 0.9}, "A body that brakes steadily goes v²/2a: each axis with a = μ g."},
          {{1.56, 2.06},
           {10, 10},
           "In no direction does the square allow less friction than the circle, so the puck stops sooner."}},
     .hints = {"Does the friction of the square point against v? Draw the corner that it ends in.",
               "No axis knows of the other: think of two pucks on two rails, at 3 and at 4 m/s.",
               "Each stops after v²/2μg, and half a step less: 0.87 m along x, 1.56 m along y."},
     .parameters = {{"dt", 0.02, 0.005, 0.05, "s", "time step"},
                    {"mu", 0.5, 0.1, 1, "", "friction coefficient"},
                    {"vx", 3, 2, 10, "m/s", "speed to the right"},
                    {"vy", 4, 0, 10, "m/s", "speed upwards in the picture"}},
     .cover = 1,
     .next = "bash lessons/run 16   (all rows together: parallel, and dangerous)"});

}  // namespace cairn
