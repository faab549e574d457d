// Lesson 21: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson21(
    {.number = 21,
     .name = "light_chain",
     .title = "A light chain",
     .idea = "A chain of light beads holds a small load, and goes to pieces under a large one. Whether the "
             "rows are "
             "solved well or badly is not what decides.",
     .paper = "beyond the paper",
     .equations = {"k = f / l                                  a taut rod, pushed sideways",
                   "x(k+1) − 2 x(k) + x(k−1) = −(ω Δt)² x(k)   a swing under semi-implicit Euler"},
     .needs = {"lesson 03", "lesson 13", "lesson 19"},
     .reads = {"src/world/two_solves.cpp", "src/constraints/constraint.hpp"},
     .question = "Ten beads of 0.1\u00a0kg hang on rods of 0.5\u00a0m, one below the other, at Δt = "
                 "0.02\u00a0s. Every step is solved exactly. The load at the lower end grows. From how many "
                 "kilograms on does the chain go to pieces?",
     .spoilers = {"12.2", "12.5", "geometric"},
     .hints = {"Push one bead aside by x. Which way do the two taut rods pull it, and how hard?",
               "A rod that pulls with f and has the length l is a spring sideways, of f / l. Neighbours that "
               "swing "
               "against each other stretch each spring twice: ω² is about 4 f / (l m).",
               "Semi-implicit Euler follows a swing up to ω Δt = 2. So f = l m / Δt²."},
     .parameters = {{"beads", 10, 2, 20, "", "on the chain", Parameter::Kind::whole},
                    {"bead", 0.1, 0.01, 1, "kg", "mass of a bead"},
                    {"load", 50, 0.1, 1e5, "kg", "mass at the lower end, in the pictures"},
                    {"dt", 0.02, 0.005, 0.05, "s", "time step"}},
     .cover = 1,
     .next = "bash lessons/run 22   (what you get if you ask for nothing)"});

}  // namespace cairn
