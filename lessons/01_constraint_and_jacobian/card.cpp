// Lesson 01. What --help and --about say, and what may be changed.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson01(
    {.number = 1,
     .name = "constraint_and_jacobian",
     .title = "Where, and which way",
     .idea =
         "A constraint is a number c that must be 0. Its derivative j says how fast a velocity changes c, "
         "and "
         "in which direction the constraint pushes or pulls.",
     .paper = "paper 2.1, eq (3)-(5), (9), (10)",
     .equations = {"(3)   c(x, y, θ) = |p| − length = 0        p: the anchor on the box",
                   "(4)   dc/dt = 0                            with β = 0: c must not change",
                   "(5)   dc/dt = j·v,  j = (u_x, u_y, r × u) u = p / |p|, r: from the centre to p",
                   "(10)  f = jᵀ λ                             (9): f has a force and a torque"},
     .needs = {"lesson 00"},
     .reads = {"src/constraints/distance_joint.cpp", "src/constraints/constraint.hpp",
               "tests/constraints/jacobian_tests.cpp"},
     .question =
         "A box hangs on a rod of 5\u00a0m from (0,\u00a00) to (3,\u00a0−4)\u00a0m, the middle of its left "
         "side. How fast does each of these velocities (v_x,\u00a0v_y,\u00a0ω) make the rod longer, in m/s? "
         "1:\u00a0(0.8,\u00a00.6,\u00a00), 2:\u00a0(0.6,\u00a0−0.8,\u00a00.5), "
         "3:\u00a0(1,\u00a00.5,\u00a0−0.5).",
     .spoilers = {"0, 1.2 and 0", "the first and the third", "0.6 − 0.4 − 0.2"},
     .unasked = {"lambda", "seed"},
     .wrong = {{{0, 0.99, 0.199},
                {0, 1.01, 0.201},
                "You left the turning out: a turning box moves the end of its arm."},
               {{0, 0.79, 0.399},
                {0, 0.81, 0.401},
                "A box that turns counterclockwise moves its left side down, not up."}},
     .hints = {"Only what the anchor does along the rod makes it longer. Across the rod it may move.",
               "The rod points along u = (0.6, −0.8). When the box turns, the anchor moves too: up for a "
               "negative ω, because it is left of the centre.",
               "j = (0.6, −0.8, 0.4), and the third is 0.6 − 0.4 − 0.2."},
     .parameters = {{"x", 3, 1, 6, "m", "anchor, to the right of the pivot"},
                    {"y", -4, -6, -1, "m", "anchor, above the pivot"},
                    {"turn", 0, -180, 180, "°", "of the box about its anchor"},
                    {"vx", 1, -10, 10, "m/s", "velocity of the box"},
                    {"vy", 2, -10, 10, "m/s", "velocity of the box"},
                    {"omega", 0.5, -5, 5, "rad/s", "how fast it turns"},
                    {"lambda", -10, -1000, 1000, "N", "strength of the rod; negative: it pulls"},
                    {"seed", 1, 0, 1e6, "", "of the random poses", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 2   (how large λ has to be)"});

}  // namespace cairn
