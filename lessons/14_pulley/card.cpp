// Lesson 14. What the lesson says of itself.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson14(
    {.number = 14,
     .name = "pulley",
     .title = "A rope on three bodies",
     .idea = "A row of J has a block for every body that it touches. A rope over wheels touches three bodies "
             "in one row. This lesson writes that joint itself, and every solver takes it unchanged.",
     .paper = "paper 4.2, 4.3",
     .equations =
         {"(5)   dc/dt = j·v,  j = (0, r₁, 0,  0, r₂, 0,  0, r₃, 0)     one row, three bodies",
          "(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)                          with three terms in each sum"},
     .needs = {"lesson 03"},
     .reads = {"src/constraints/constraint.hpp", "src/constraints/row.hpp"},
     .question =
         "Masses of 1, 2 and 3 kg hang on one rope over wheels without mass or friction, the 2 kg on two "
         "parts of it. Shared alike, their 60\u00a0N are 15\u00a0N for each of the four parts. All are let "
         "go. With how many newtons does each part of the rope pull?",
     .spoilers = {"12 N", "heaviest falls", "6 m/s²"},
     .unasked = {"lift"},
     .wrong = {{{15}, {15}, "So it would be if all masses hung still. They do not."},
               {{0},
                {11.4},
                "Then the heavy mass would fall faster than the two light ones rise, and the rope would get "
                "longer."},
               {{15.1},
                {60},
                "Then the two light masses would rise faster than the heavy one can fall. A light mass gives "
                "way easily: its 1/m is large."}},
     .hints = {"What the rope gives on one side it takes on the others: y₁ + 2 y₂ + y₃ stays as it is.",
               "λ follows from (22) with j·v = −4 g Δt: each part of the rope counts.",
               "j M⁻¹ jᵀ = 1/1 + 4/2 + 1/3."},
     .parameters = {{"dt", 0.02, 0.001, 0.1, "s", "time step"},
                    {"m1", 1, 0.01, 100, "kg", "mass on the left, on one part of the rope"},
                    {"m2", 2, 0.01, 100, "kg", "mass in the middle, on two parts"},
                    {"m3", 3, 0.01, 100, "kg", "mass on the right, on one part"},
                    {"lift", 3, 0, 20, "m/s", "how fast the third mass is thrown up; 0: not at all"}},
     .cover = 1,
     .next = "bash lessons/run 15   (two rows of friction that share one limit)"});

}  // namespace cairn
