// Lesson 14. What the lesson says of itself.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson14(
    {.number = 14,
     .name = "pulley",
     .title = "A rope on three bodies",
     .idea = "A row of J has a block for every body that it touches. A rope over wheels touches three bodies "
             "in one row. This lesson writes that joint itself, and gives it to seven solvers.",
     .paper = "paper 4.2, 4.3",
     .equations =
         {"(5)   dc/dt = j·v,  j = (0, r₁, 0,  0, r₂, 0,  0, r₃, 0)     one row, three bodies",
          "(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)                          with three terms in each sum"},
     .needs = {"lesson 03"},
     .reads = {"src/constraints/constraint.hpp", "src/constraints/row.hpp"},
     .question = "Masses of 1, 2 and 3 kg hang on one rope over wheels, and are let go. The rope is one row, "
                 "and its λ is the pull in each part. A solver with room for only two bodies in a row leaves "
                 "the third mass out, and finds λ = 10\u00a0N. What does the row find that has all three "
                 "masses?",
     .spoilers = {"12 N", "heaviest falls", "6 m/s²"},
     .unasked = {"dt", "lift"},
     .wrong = {{{9.9}, {10.1}, "That is the row without the third mass. It pulls at the rope, too."},
               {{14.9},
                {15.1},
                "So it would be if four parts shared the 60 N alike. But a light mass gives way more than a "
                "heavy one."},
               {{15.2},
                {25},
                "The 2 kg hang on two parts of the rope, so there are four that pull. And light masses give "
                "way."},
               {{25.1},
                {60},
                "So hard it would pull if the 3 kg stood still. The light masses rise, so the 3 kg fall."}},
     .hints =
         {"What does (22) need of a row? j·v and j M⁻¹ jᵀ.",
          "Both are sums over the bodies of the row, with j = 1, 2 and 1 here. The third mass adds a term "
          "to each.",
          "The rope alone gives one equation for one λ: A is a single number, 1/1 + 4/2 + 1/3."},
     .parameters = {{"dt", 0.02, 0.001, 0.1, "s", "time step"},
                    {"m1", 1, 0.01, 100, "kg", "mass on the left, on one part of the rope"},
                    {"m2", 2, 0.01, 100, "kg", "mass in the middle, on two parts"},
                    {"m3", 3, 0.01, 100, "kg", "mass on the right, on one part"},
                    {"lift", 3, 0, 20, "m/s", "how fast the third mass is thrown up; 0: not at all"}},
     .cover = 1,
     .next = "bash lessons/run 15   (two rows of friction that share one limit)"});

}  // namespace cairn
