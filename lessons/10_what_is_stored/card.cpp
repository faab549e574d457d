// What lesson 10 is: its title, its equations, its question, its parameters.
#include "lessons/card.hpp"

namespace cairn {

LessonInfo card() {
  return {
      .number = 10,
      .name = "what_is_stored",
      .title = "What is stored",
      .idea =
          "PGS stores how every row acts on every other, SI one number a row. Nearly all of those entries "
          "are zero, and PGS without the zeros works as hard as SI in a sweep. Count before you optimise.",
      .paper = "paper 2.3, 4.4, eq (30)",
      .equations = {"(15)  A = J M⁻¹ Jᵀ                              m × m numbers for m rows",
                    "(30)  non-zero elements in A = Σ Σ δ(J_i · J_j)   as printed, without M⁻¹",
                    "(22)  1 / (j M⁻¹ jᵀ)                            one number a row"},
      .needs = {"lesson 04", "lesson 06"},
      .reads = {"src/solvers/non_zeros.hpp", "src/solvers/iterative/sparse_projected_gauss_seidel.hpp",
                "src/solvers/body_rows.hpp"},
      .question =
          "Boxes in a pyramid, two rows for each overlap. How many times more numbers does a full A hold for "
          "the largest of them than SI, which keeps one for each row?",
      .hints = {"A has a row and a column for every contact row.", "m² numbers here, m there.",
                "The lowest boxes have two rows each on the ground; every other box has four below it."},
      .parameters = {{"base", 20, 11, 22, "", "boxes in the lowest row of the largest pyramid",
                      Parameter::Kind::whole},
                     {"spacing", 1.1, 1.05, 1.8, "m", "between the centres of a row of boxes of 1 m"},
                     {"sweeps", 10, 1, 50, "", "of each solver, where answers are compared",
                      Parameter::Kind::whole}},
      .cover = 21,
      .next = "bash lessons/run 11   (a row whose bounds lean on another row)"};
}

}  // namespace cairn
