// Lesson 14. What the lesson says of itself.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson14(
    {.number = 14,
     .name = "pulley",
     .title = "A rope on three bodies",
     .idea = "A row of J has a block for every body that it touches. A rope over wheels touches three bodies "
             "in one row. This lesson writes that joint itself, and gives it to seven solvers.",
     .paper = "paper 4.2, 4.3",
     .equations =
         {"(5)   dc/dt = j·v,  j = (0, r₁, 0,  0, r₂, 0,  0, r₃, 0)     one row, three bodies",
          "(22)  λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)                          with three terms in each sum"},
     .needs = {"lesson 03"},
     .reads = {"src/constraints/constraint.hpp", "src/constraints/row.hpp"},
     .question = "Masses of 1, 2 and 3 kg hang on one rope over wheels. The rope is one row on three bodies, "
                 "and its λ is "
                 "the pull. Seven solvers get this row, each with a single sweep: SI, five kinds of PGS, and "
                 "Jacobi's "
                 "method. How many of the seven find the right λ?",
     .spoilers = {"All seven", "12 N", "heaviest falls", "6 m/s²"},
     .unasked = {"dt", "m1", "m2", "m3", "lift"},
     .wrong =
         {{{0}, {0}, "There is one row: a sweep visits it once, and satisfies it."},
          {{1},
           {1},
           "So says the paper, of PGS with room for two bodies in a row. That is a matter of storage: give "
           "it room for a third."},
          {{2}, {6}, "What should the others lack? They all solve (22), or A λ = b, for one row."}},
     .hints = {"What does a solver do with a row? It needs j·v and j M⁻¹ jᵀ, or A and b.",
               "j·v and j M⁻¹ jᵀ are sums over the bodies of the row. What changes with a third body?",
               "The rope alone gives one equation for one λ: A is a single number, 1/1 + 4/2 + 1/3."},
     .parameters = {{"dt", 0.02, 0.001, 0.1, "s", "time step"},
                    {"m1", 1, 0.01, 100, "kg", "mass on the left, on one part of the rope"},
                    {"m2", 2, 0.01, 100, "kg", "mass in the middle, on two parts"},
                    {"m3", 3, 0.01, 100, "kg", "mass on the right, on one part"},
                    {"lift", 3, 0, 20, "m/s", "how fast the third mass is thrown up; 0: not at all"}},
     .cover = 1,
     .next = "bash lessons/run 15   (two rows of friction that share one limit)"});

}  // namespace cairn
