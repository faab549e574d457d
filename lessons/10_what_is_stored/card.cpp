// What lesson 10 is: its title, its equations, its question, its parameters.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson10(
    {.number = 10,
     .name = "what_is_stored",
     .title = "What is stored",
     .idea = "PGS stores how every row acts on every other; SI stores one number for each row. Count what is "
             "really there before you optimise.",
     .paper = "paper 2.3, 4.4, eq (30)",
     .equations = {"(15)  A = J M⁻¹ Jᵀ                              m × m numbers for m rows",
                   "(22)  1 / (j M⁻¹ jᵀ)                            one number for each row"},
     .needs = {"lesson 03", "lesson 05"},
     .reads = {"src/solvers/non_zeros.hpp", "src/solvers/iterative/sparse_projected_gauss_seidel.hpp",
               "src/solvers/body_rows.hpp"},
     .question =
         "Boxes in a pyramid give two rows of A for each overlap, 800 rows in all. Row 401 belongs to an "
         "overlap inside the pyramid. How many of its 800 entries are not zero?",
     .spoilers = {"786", "98.4"},
     .unasked = {"sweeps"},
     .wrong = {{{1}, {7}, "Each overlap on one of the two boxes meets this one, and has two rows."},
               {{8}, {8}, "So many rows act on one box. A row has two boxes."},
               {{12}, {12}, "Six other overlaps meet this one. Its own has two rows, too."},
               {{16}, {16}, "8 + 8 counts the two rows of the same overlap twice."},
               {{20}, {800}, "Rows that share no body that can move do not act on each other."}},
     .hints = {"A_ij is not zero where rows i and j share a body that can move.",
               "A row has two boxes. How many rows does a box inside the pyramid have?",
               "8 rows for each box, and the two rows of an overlap are on both boxes."},
     .parameters = {{"base", 20, 11, 22, "", "boxes in the lowest row of the largest pyramid",
                     Parameter::Kind::whole},
                    {"spacing", 1.1, 1.05, 1.8, "m", "between the centres of a row of boxes of 1 m"},
                    {"sweeps", 10, 1, 50, "", "of each solver, where answers are compared",
                     Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 11   (the bounds of a row depend on another row)"});

}  // namespace cairn
