// Lesson 09. What --help and --about say, and what may be changed.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson09(
    {.number = 9,
     .name = "drift_and_baumgarte",
     .title = "Drift and Baumgarte",
     .idea =
         "A row asks for velocities and does not know where the bodies are, so errors in positions stay. β "
         "makes it ask for a velocity that removes a share of the error in every step.",
     .paper = "paper 2.1, 3.1, eq (4), (7), (20)-(22)",
     .equations = {"(4)   dc/dt = −(β / Δt) c             a share β of the error c goes in each step",
                   "(7)   ζ = −β c / Δt                   the velocity j·v that a row asks for",
                   "(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)   the force that gives it; for a contact λ ≥ 0"},
     .needs = {"lesson 02", "lesson 04"},
     .reads = {"src/constraints/stabilization.hpp", "src/constraints/stabilization.cpp"},
     .question =
         "A ball of 1\u00a0kg at rest begins 100\u00a0mm inside the ground. β\u00a0=\u00a01 removes the "
         "whole error in one step of 0.02\u00a0s. Gravity is 10\u00a0m/s², and nothing "
         "bounces. How high above the ground does the lowest point of that ball come, in metres (0: it "
         "stays "
         "on the ground)?",
     .spoilers = {"1.2 m", "5 m/s"},
     .wrong = {{{-0.01},
                {0.01},
                "Nothing bounces, but nothing takes away the speed that removes the error, "
                "either."},
               {{0.09},
                {0.11},
                "That is the error. The ball leaves with the speed that removes it in one "
                "step, 5 m/s."}},
     .hints = {"To be out within one step of Δt, how fast does it have to move?",
               "v = depth / Δt. Gravity is the only thing that slows it down afterwards.",
               "About v² / (2 g), and a little less, because time passes in steps."},
     .parameters = {{"dt", 0.02, 0.01, 0.05, "s", "time step"},
                    {"beta", 0.2, 0.05, 1, "", "the share β of an error that a step removes"},
                    {"depth", 0.1, 0.01, 0.2, "m", "how deep the ball begins inside the ground"}},
     .cover = 1,
     .next = "bash lessons/run 10   (what the two solvers keep, and what they need)"});

}  // namespace cairn
