// Lesson 20: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson20(
    {.number = 20,
     .name = "only_what_the_scene_needs",
     .title = "Only what the scene needs",
     .idea =
         "The cost of a row update is fixed. You can choose how many there are: each island of a scene needs "
         "sweeps of its own, and one that rests needs none.",
     .paper = "paper 4.4",
     .equations = {"      cost of a step = Σ over islands (rows × sweeps)",
                   "      while not satisfied ...                Algorithm 1: until R_E ≤ the tolerance"},
     .needs = {"lesson 08", "lesson 11", "lesson 16", "lesson 18"},
     .reads = {"src/world/plan.hpp", "src/world/sleeping.hpp", "src/solvers/stopping.hpp"},
     .question =
         "Pyramid, tower and chain have 100, 40 and 10 rows. Each step takes 50 sweeps, or ends as "
         "soon as all errors are down to a thousandth: that leaves 89\u00a0% of the row updates. If each "
         "of the three ends by itself, the pyramid takes nine sweeps on average, and the chain 33. How many "
         "per cent are left?",
     .spoilers = {"40 %", "3030"},
     .wrong = {{{85},
                {100},
                "The tower keeps only itself waiting now: the pyramid, with most of the rows, "
                "ends much sooner."},
               {{47.3},
                {84.9},
                "Only the tower takes nearly all of its sweeps, and it has 40 of the 150 rows."},
               {{0}, {33.2}, "The tower still takes nearly all of its sweeps, and the others take some."}},
     .hints =
         {"A step for all together takes 89\u00a0% of 50 sweeps. Which of the three does everybody wait for?",
          "Rows times sweeps, for each of the three; all of them have 7500 with 50 sweeps.",
          "Add rows × sweeps of the three, and divide by 150 × 50."},
     .parameters = {{"sweeps", 50, 1, 200, "", "in every step, at most", Parameter::Kind::whole},
                    {"tolerance", 0.001, 1e-6, 0.3, "", "R_E at which a step may end sooner"},
                    {"bodies", 10, 1, 15, "", "boxes in the tower", Parameter::Kind::whole},
                    {"links", 5, 1, 8, "", "of the chain", Parameter::Kind::whole},
                    {"steps", 140, 20, 300, "", "of each run", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 21   (light beads under a heavy load)"});

}  // namespace cairn
