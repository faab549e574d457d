// Lesson 19: its card.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson19(
    {.number = 19,
     .name = "extremes",
     .title = "Heavy on light",
     .idea = "Two boxes, one upon the other: how many sweeps they take depends on which of them is heavy. A "
             "formula says how many, before anything moves.",
     .paper = "paper 4.5, eq (14), (22)",
     .equations = {"(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)         two boxes, R = mass above / mass below:",
                   "      error after k sweeps = (R / (1 + R))ᵏ  about 4.6 R sweeps to 1 %"},
     .needs = {"lesson 03", "lesson 06", "lesson 09"},
     .reads = {"src/study/extremes/extreme.hpp"},
     .question =
         "A box of 1\u00a0kg carries one of 100\u00a0kg. A sweep visits the ground first. How many sweeps "
         "until the load on the ground is right to 1\u00a0%? And with the light box above?",
     .spoilers = {"463", "99 %"},
     .unasked = {"sweeps"},
     .wrong = {{{1, 400},
                {2, 500},
                "It is the other way round: think of what one sweep can pass on from the light box."},
               {{2, 0}, {300, 1000}, "Each sweep takes only one part in 101 of the error away."}},
     .hints = {"Which boxes does the ground see in the first sweep? Only the light one.",
               "One sweep leaves R / (1 + R) of the error: here 100 / 101.",
               "(100 / 101)ᵏ ≤ 1 / 100: take logarithms."},
     .parameters = {{"ratio", 100, 2, 5000, "", "mass of the heavy box over that of the light one"},
                    {"sweeps", 10, 1, 200, "", "sweeps of SI in every step", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 20   (only what the scene needs)"});

}  // namespace cairn
