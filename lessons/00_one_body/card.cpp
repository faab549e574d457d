// Lesson 00. What --help and --about say, and what may be changed.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson00(
    {.number = 0,
     .name = "one_body",
     .title = "One body",
     .idea = "A body is three numbers and their rates; a step changes the rates first, then the numbers.",
     .paper = "paper 2.1, eq (1), (2); 2.2, eq (12)",
     .equations = {"(1)   v = (v_x, v_y, ω)", "(2)   M⁻¹ = diag(1/m, 1/m, 1/I)",
                   "(12)  v₂ = v₁ + M⁻¹ f Δt,  here f = m g;  then x₂ = x₁ + v₂ Δt"},
     .reads = {"src/dynamics/body.hpp", "src/dynamics/integrate.cpp", "src/geometry/mass.cpp"},
     .question =
         "A box swings on a spring, twice a second and 1\u00a0m to each side; nothing brakes it. Each step "
         "of 0.02\u00a0s first moves it with its velocity, and then changes the velocity by what the spring "
         "pulls. How large has its swing become after two seconds, in metres to each side?",
     .spoilers = {"21", "1.031"},
     .unasked = {"gravity", "spin", "steps"},
     .wrong =
         {{{18.6},
           {18.8},
           "There the box is after two seconds, and it is still on its way out. The swing is how far out "
           "it gets."},
          {{0},
           {0.89},
           "A step that moves first goes on with the velocity from before the pull. On the way out that "
           "is too fast."},
          {{0.9},
           {1.1},
           "So it would with the two lines in the other order. Here each move takes a velocity that is "
           "out of date."},
          {{1.101}, {8}, "A step changes the swing only a little, but there are 100, and each multiplies."}},
     .hints = {"Pulled 1 m aside and at rest: which way does the first step move the box, and which way "
               "should it?",
               "Draw v/4π against x. The exact motion runs round a circle. Where does a step that goes "
               "straight on end, inside or outside?",
               "Each step multiplies the swing by √(1 + (4π Δt)²), here 1.031."},
     .parameters =
         {{.flag = "dt", .standard = 0.02, .min = 1e-4, .max = 0.2, .unit = "s", .what = "time step"},
          {.flag = "gravity", .standard = 10, .min = 0.1, .max = 100, .unit = "m/s²", .what = "gravity"},
          {.flag = "spin",
           .standard = -1,
           .min = -20,
           .max = 20,
           .unit = "rad/s",
           .what = "how fast the box turns"},
          {.flag = "steps",
           .standard = 60,
           .min = 6,
           .max = 2000,
           .what = "steps",
           .kind = Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 1   (what takes some of this freedom away)"});

}  // namespace cairn
