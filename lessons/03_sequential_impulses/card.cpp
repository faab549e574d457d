// What lesson 03 is: its title, its equations, its question, its parameters.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson03(
    {.number = 3,
     .name = "sequential_impulses",
     .title = "Sequential impulses",
     .idea =
         "The contacts of a stack share boxes, so each push disturbs other contacts. Visit them one by one, "
         "push just hard enough, immediately, and go round again.",
     .paper = "paper 3.2, eq (19)-(23), Algorithm 1",
     .equations = {"(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)     the force that this row needs [N]",
                   "(23)  p = jᵀ λ Δt                        the impulse it gives [N s]",
                   "(21)  v ← v + M⁻¹ p                      to its two bodies, immediately"},
     .needs = {"lesson 02"},
     .reads = {"src/solvers/iterative/sequential_impulse.cpp", "src/constraints/row.hpp"},
     .question =
         "Three boxes of 1\u00a0kg fall at 0.2\u00a0m/s. From the ground up, each contact in turn pushes "
         "just "
         "so hard that its own two boxes stop approaching each other. After one such sweep, how fast does "
         "the uppermost box still fall, in m/s?",
     .spoilers = {"0.15 m/s", "stops box 1"},
     .unasked = {"sweeps", "seed"},
     .wrong =
         {{{0},
           {0.019},
           "Then one sweep would be enough. But the last push leaves boxes 2 and 3 equally fast, and box 2 "
           "was falling."},
          {{0.02},
           {0.06},
           "When its contact is visited, box 3 still falls at 0.2 m/s: no push before has reached it."},
          {{0.09},
           {0.11},
           "So fast falls box 2 before the last push. That push makes boxes 2 and 3 equally fast."},
          {{0.199}, {0.21}, "Box 2 is slower by then, so the last contact has an error, and pushes."}},
     .hints = {"A push has two ends: it slows the upper box and speeds up the lower one, as much.",
               "Row 1 stops box 1. Row 2 finds 0.2 m/s between two boxes of 1 kg; both fall at 0.1 m/s then.",
               "Row 3 makes boxes 2 and 3 equally fast: the mean of 0.1 and 0.2 m/s."},
     .parameters = {{"bodies", 3, 1, 10, "", "boxes", Parameter::Kind::whole},
                    {"dt", 0.02, 0.0001, 1, "s", "time step"},
                    {"gravity", 10, 0.01, 1000, "m/s^2", "gravity, downwards"},
                    {"sweeps", 10, 1, 100, "", "sweeps", Parameter::Kind::whole},
                    {"seed", 1, 0, 1e9, "", "of --order shuffle", Parameter::Kind::whole}},
     .choices = {{"order", {"up", "down", "shuffle"}, "in which rows are visited"}},
     .cover = 1,
     .next = "bash lessons/run 4   (what a contact does that has pushed too hard)"});

}  // namespace cairn
