// What lesson 08 is: its title, its equations, its question, its parameters.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson08(
    {.number = 8,
     .name = "warm_start",
     .title = "Warm start",
     .idea =
         "A tower that stood a moment ago still stands, and its contacts push as hard as before. Begin with "
         "the impulses of the last step: then the sweeps of all steps work on one answer.",
     .paper = "paper 2.3 (last paragraph), 3.2, Algorithm 1",
     .equations = {"lines 2-6   λ ← λ of the last step, if that row was there; else 0",
                   "(21)        v ← v + M⁻¹ jᵀ λ Δt             that guess acts before the first sweep",
                   "(22)        λ_corrective = (ζ − j·v) / (j M⁻¹ jᵀ Δt)   then sweeps as before"},
     .needs = {"lesson 03", "lesson 04"},
     .reads = {"src/world/world.cpp", "src/constraints/row.hpp"},
     .question =
         "A tower of 10 boxes does 50 sweeps in each step, always from zero. In 300 steps its top sinks "
         "by 559\u00a0mm. Now each step begins with the impulses of the last one, and does one sweep. How "
         "deep is the top after 300 steps: about 5000, 560, 180 or 20\u00a0mm?",
     .spoilers = {"184", "322", "0.9755"},
     .unasked = {"boxes", "sweeps", "steps", "dt"},  // the question has their numbers
     .wrong =
         {{{0},
           {155},
           "In the end the impulses are right, and the tower stands. But what happens until they have "
           "grown?"},
          {{220},
           {1000},
           "That makes one warm sweep worth fifty cold ones. But the cold tower sinks on for ever; does "
           "the warm one?"},
          {{1001},
           {100000},
           "So it would be if each step began from zero. But a sweep goes on where the last one ended: 300 "
           "sweeps work on one answer."}},
     .hints = {"Warm or cold, a sweep leaves the same share of an error. What differs is the error it finds.",
               "Cold, each of the 300 steps begins with an error of 100 % and throws its 50 sweeps away.",
               "Warm, the load takes about ten steps to reach 100 N. How far does a box fall in so long?"},
     .parameters = {{"boxes", 10, 3, 20, "", "boxes of 1 kg in the tower", Parameter::Kind::whole},
                    {"sweeps", 10, 1, 50, "", "sweeps in each step", Parameter::Kind::whole},
                    {"steps", 120, 60, 300, "", "steps of each run", Parameter::Kind::whole},
                    {"dt", 0.02, 0.005, 0.03, "s", "time step"}},
     .cover = 1,
     .next = "bash lessons/run 9   (what becomes of errors in positions)"});

}  // namespace cairn
