// What lesson 04 is: its title, its equations, its question, its parameters.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson04(
    {.number = 4,
     .name = "second_visit",
     .title = "The second visit",
     .idea = "A contact must not pull, so something has to be clamped at 0: each push, or the sum of all "
             "pushes? Only one of the two lets a box stand.",
     .paper = "paper 3.2, second paragraph",
     .equations =
         {"(22)  p_corr = (ζ − j·v) / (j M⁻¹ jᵀ)          the correction of this visit [N s]; here ζ = 0",
          "3.2   p ← max(0, p + p_corr)                  clamps the sum",
          "      p ← p + max(0, p_corr)                  clamps each push"},
     .needs = {"lesson 03"},
     .reads = {"src/solvers/iterative/sequential_impulse.cpp",
               "src/solvers/iterative/sequential_impulse.hpp"},
     .question =
         "A box of 6\u00a0kg lands at 10\u00a0m/s on feet at ±0.25\u00a0m. First the left foot stops itself "
         "with 43.64\u00a0N\u00a0s, then the right one with 23.80\u00a0N\u00a0s. Now the left foot moves at "
         "+2.48\u00a0m/s. A contact must not pull. How much has the left foot given in all after its second "
         "visit, in N\u00a0s?",
     .spoilers = {"10.82", "32.82"},
     .unasked = {"foot", "speed", "sweeps"},  // the question has their numbers
     .wrong = {{{10.5}, {11.1}, "So much it takes back. How much has it given in all?"},
               {{29}, {31}, "There both feet end, after many visits. This one is the second."},
               {{54}, {55}, "That foot moves up, so it has given too much: it takes something back."},
               {{43.5}, {43.8}, "That forbids it to take anything back. Only the sum has to stay above 0."}},
     .hints = {"Was the first push of the left foot too small, right, or too large?",
               "43.64 N s have changed the speed of that foot by 10 m/s. How much changes it by 2.48 m/s?",
               "p_corr = −43.64 × 0.248 N s. Within one step both pushes of the foot act as one: their sum."},
     .parameters = {{"foot", 0.25, 0.05, 0.5, "m", "from the middle of the box to each foot"},
                    {"speed", 10, 0.5, 50, "m/s", "how fast it lands"},
                    {"sweeps", 10, 2, 100, "", "sweeps", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 5   (which equation did the sweeps solve?)"});

}  // namespace cairn
