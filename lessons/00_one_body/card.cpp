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
         "A box is thrown at 4 m/s to the right and 6 m/s upwards. Each step of 0.02 s first adds gravity, "
         "10 "
         "m/s², to its velocity and then moves it with the new velocity. After 60 steps the exact parabola "
         "is "
         "back at its starting height. Is the simulated box above it or below, and by how many metres "
         "(negative: "
         "below)?",
     .spoilers = {"0.12", "g Δt t"},
     .wrong = {{{-0.001},
                {0.001},
                "The steps do not follow the parabola: each moves with the velocity of its "
                "own end."},
               {{0.11}, {0.13}, "That is what comes out if each step moves with the old velocity first."}},
     .hints =
         {"Which velocity does a step use: the one at its beginning or the one at its end?",
          "While the box slows down on its way up, the velocity at the end of a step is the smaller one.",
          "In each step the velocity used is g Δt / 2 smaller than the mean one; that adds up for t "
          "seconds."},
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
