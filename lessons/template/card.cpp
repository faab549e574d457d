// What lesson NN is: its title, its equations, its question, its parameters.
#include "lessons/card.hpp"

namespace cairn {

LessonInfo card() {
  return {.number = NN,
          .name = "NAME",
          .title = "TITLE",
          .idea = "One sentence: what the reader knows afterwards.",
          .paper = "paper 3.2, eq (22)",
          .equations = {"(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)"},
          .needs = {"lesson 02"},
          .reads = {"src/solvers/iterative/sequential_impulse.cpp"},
          .question = "Which impulse stops the ball (N s)?",
          .spoilers = {"6 N s", "m v"},
          .hints = {"What changes when an impulse acts?", "An impulse of 1 N s changes 1 kg by 1 m/s.",
                    "The ball of 2 kg has to change by 3 m/s."},
          .parameters = {{"mass", 2, 0.01, 1000, "kg", "of the ball"},
                         {"speed", 3, 0.01, 100, "m/s", "of the ball, downwards"}},
          .cover = 1,
          .next = "bash lessons/run list   (what else there is)"};
}

}  // namespace cairn
