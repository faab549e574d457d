// What lesson 09 is: its title, its equations, its question, its parameters.
#include "lessons/card.hpp"

namespace cairn {

LessonInfo card() {
  return {
      .number = 9,
      .name = "warm_start",
      .title = "Warm start",
      .idea =
          "A tower that stood a moment ago still stands, and its contacts push as hard as before. Begin with "
          "the impulses of the last step: then the sweeps of all steps work on one answer.",
      .paper = "paper 2.3 (last paragraph), 3.2, Algorithm 1",
      .equations = {"lines 2-6   λ ← λ of the last step, if that row was there; else 0",
                    "(21)        v ← v + M⁻¹ jᵀ λ Δt             that guess acts before the first sweep",
                    "(22)        λ_corrective = (ζ − j·v) / (j M⁻¹ jᵀ Δt)   then sweeps as before"},
      .needs = {"lesson 05", "lesson 06"},
      .reads = {"src/world/world.cpp", "src/constraints/row.hpp"},
      .question =
          "The lowest contact has to carry the whole tower. Beginning from nothing, how many sweeps does one "
          "step need until that contact carries 99 % of it?",
      .spoilers = {"178", "0.9755"},
      .hints = {"A sweep carries weight from box to box. Ten sweeps give the lowest of ten contacts a third "
                "of it.",
                "In the long run a sweep leaves cos²(π/2n) of the error: 0.9755 for ten boxes.",
                "Which power of 0.9755 is about 1/80?"},
      .parameters = {{"boxes", 10, 3, 20, "", "boxes of 1 kg in the tower", Parameter::Kind::whole},
                     {"sweeps", 10, 1, 50, "", "sweeps in each step", Parameter::Kind::whole},
                     {"steps", 120, 60, 300, "", "steps of each run", Parameter::Kind::whole},
                     {"dt", 0.02, 0.005, 0.03, "s", "time step"}},
      .cover = 1,
      .next = "bash lessons/run 10   (what the two solvers keep, and what they need)"};
}

}  // namespace cairn
