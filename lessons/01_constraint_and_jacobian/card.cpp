// Lesson 01. What --help and --about say, and what may be changed.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson01(
    {.number = 1,
     .name = "constraint_and_jacobian",
     .title = "Where, and which way",
     .idea =
         "A constraint is a number c that must be 0. Its derivative j says how fast a velocity changes c, "
         "and in which direction the constraint pushes or pulls.",
     .paper = "paper 2.1, eq (3)-(5), (9), (10)",
     .equations = {"(3)   c(x, y, θ) = |p| − length = 0        p: the anchor on the box",
                   "(4)   dc/dt = 0                            with β = 0: c must not change",
                   "(5)   dc/dt = j·v,  j = (u_x, u_y, r × u) u = p / |p|, r: from the centre to p",
                   "(10)  f = jᵀ λ                             (9): f has a force and a torque"},
     .needs = {"lesson 00"},
     .reads = {"src/constraints/distance_joint.cpp", "src/constraints/constraint.hpp",
               "tests/constraints/jacobian_tests.cpp"},
     .question =
         "A rod of 5\u00a0m goes from (0,\u00a00) to (3,\u00a0−4)\u00a0m, the middle of the left side of a "
         "box. The box moves at 1\u00a0m/s to the right and 0.5\u00a0m/s up, and turns at "
         "−0.5\u00a0rad/s, that is clockwise. How fast does the rod get longer, in m/s?",
     .spoilers = {"neither longer nor shorter", "0.6 − 0.4 − 0.2"},
     .unasked = {"lambda"},
     .wrong = {{{0.19}, {0.21}, "You left the turning out: a turning box moves the end of its arm."},
               {{0.39}, {0.41}, "A box that turns clockwise moves its left side up, not down."},
               {{-0.21}, {-0.19}, "So much takes the turning. The box moves along the rod as well."},
               {{0.59}, {0.61}, "That is the motion to the right alone. The box also moves up, and turns."},
               {{0.95}, {1.05}, "So fast the box moves to the right. Only motion along the rod counts."},
               {{1.1}, {1.2}, "So fast goes the centre. Only motion along the rod makes the rod longer."}},
     .hints = {"Only what the anchor does along the rod makes it longer. Across the rod it may move.",
               "The rod points along u = (0.6, −0.8). When the box turns, the anchor moves too: up for a "
               "negative ω, because it is left of the centre.",
               "j = (0.6, −0.8, 0.4), and the sum is 0.6 − 0.4 − 0.2."},
     .parameters = {{"x", 3, 1, 6, "m", "anchor, to the right of the pivot"},
                    {"y", -4, -6, -1, "m", "anchor, above the pivot"},
                    {"turn", 0, -180, 180, "°", "of the box about its anchor"},
                    {"vx", 1, -10, 10, "m/s", "velocity of the box"},
                    {"vy", 0.5, -10, 10, "m/s", "velocity of the box"},
                    {"omega", -0.5, -5, 5, "rad/s", "how fast it turns"},
                    {"lambda", -10, -1000, 1000, "N", "strength of the rod; negative: it pulls"}},
     .cover = 1,
     .next = "bash lessons/run 2   (how large λ has to be)"});

}  // namespace cairn
