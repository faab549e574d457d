// Lesson 21: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson21(
    {.number = 21,
     .name = "light_chain",
     .title = "A light chain",
     .idea =
         "A chain of light beads holds a small load, and goes to pieces under a large one. The border can "
         "be computed by hand, and says what would help.",
     .paper = "beyond the paper",
     .equations = {"k = f / l                                  a taut rod, pushed sideways",
                   "x(k+1) − 2 x(k) + x(k−1) = −(ω Δt)² x(k)   a swing under semi-implicit Euler"},
     .needs = {"lesson 03", "lesson 13", "lesson 19"},
     .reads = {"src/world/two_solves.cpp", "src/constraints/constraint.hpp"},
     .question =
         "Ten beads of 0.1\u00a0kg on rods of 0.5\u00a0m, one below the other, carry "
         "50\u00a0kg. Under ten sweeps a step (Δt = 0.02\u00a0s) they go to pieces. Which one of these holds "
         "them: (1) 1000 times the sweeps, (2) an exact solver, (3) steps of a quarter, (4) beads of "
         "twice the mass?",
     .spoilers = {"12.21", "12.5", "geometric"},
     .unasked = {"beads"},
     .wrong = {{{1}, {1}, "With 10 000 sweeps the rows are solved, and the chain is lost all the same."},
               {{2}, {2}, "No row has an error left then, and the chain is lost all the same."},
               {{4}, {4}, "Twice the mass holds twice the load. That would be 25 kg here."}},
     .hints = {"Push one bead aside by x. Which way do the two taut rods pull it, and how hard?",
               "A rod that pulls with f and has the length l is a spring sideways, of f / l. Neighbours that "
               "swing "
               "against each other stretch each spring twice: ω² is about 4 f / (l m).",
               "Semi-implicit Euler follows a swing up to ω Δt = 2. So f = l m / Δt²."},
     .parameters = {{"beads", 10, 2, 20, "", "on the chain", Parameter::Kind::whole},
                    {"bead", 0.1, 0.01, 1, "kg", "mass of a bead"},
                    {"load", 50, 0.1, 1e5, "kg", "mass at the lower end, in the pictures"},
                    {"dt", 0.02, 0.005, 0.05, "s", "time step"},
                    {"parts", 4, 1, 20, "", "into which (3) cuts a step", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 22   (what you get if you ask for nothing)"});

}  // namespace cairn
