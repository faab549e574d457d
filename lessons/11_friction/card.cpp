// Lesson 11. What the lesson says of itself.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson11(
    {.number = 11,
     .name = "friction",
     .title = "Friction",
     .idea =
         "Friction is a row like any other, but its bounds depend on what the normal row beside it gives.",
     .paper = "paper 2.2, \"interval of valid values\"; 4.4, contact and friction",
     .equations = {"j_n·v ≥ 0,  λ_n ≥ 0            normal row: the contact may push, never pull",
                   "j_t·v = 0,  |λ_t| ≤ μ λ_n      tangent row: Coulomb's law as bounds"},
     .needs = {"lesson 03"},
     .reads = {"src/constraints/contact.cpp", "src/constraints/row.hpp",
               "src/solvers/iterative/sequential_impulse.cpp"},
     .question =
         "A square block of 1\u00a0kg with μ\u00a0=\u00a00.5 slides down a slope of 30°. Friction is at "
         "its limit, 4.33\u00a0N at both corners together. How many newtons of it act at the lower corner?",
     .spoilers = {"3.25", "6.50", "1.08", "three times"},
     .unasked = {"mu-rough", "mass"},
     .wrong = {{{1}, {1.2}, "So much acts at the upper corner. Onto which one does friction turn the block?"},
               {{6.3}, {6.7}, "That is the load of the lower corner. Its friction is μ times that."},
               {{4.2}, {4.5}, "Then the upper corner would carry nothing, and it does."},
               {{2.1},
                {2.2},
                "Friction goes with the normal force, and that is not the same at both "
                "corners."}},
     .hints =
         {"Each corner may give μ times its own load. Do both carry the same?",
          "Friction pulls uphill, at the block's lower side. Around the centre of mass, which way does it "
          "turn the block?",
          "All arms are 1/2 m, so λ_n of the lower corner less that of the upper one is the friction, "
          "4.33 N. Their sum is m g cos α = 8.66 N."},
     .parameters = {{"angle", 30, 5, 35, "°", "angle of the slope"},
                    {"mu", 0.5, 0.05, 0.8, "", "friction of the slippery block"},
                    {"mu-rough", 0.6, 0.05, 0.8, "", "friction of the rough one"},
                    {"mass", 2, 0.001, 1000, "kg", "mass of the rough one's twin"},
                    {"gravity", 10, 1, 20, "m/s²", "gravity"},
                    {"dt", 0.02, 0.001, 0.05, "s", "time step"},
                    {"sweeps", 50, 1, 1000, "", "sweeps per step", Parameter::Kind::whole},
                    {"steps", 100, 40, 400, "", "steps", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 12   (rows that belong together, solved together)"});

}  // namespace cairn
