// What lesson 08 is: its title, its equations, its question, its parameters.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson08(
    {.number = 8,
     .name = "same_thing_twice",
     .title = "The same thing twice",
     .idea =
         "PGS solves A λ = b and looks at no velocity; SI looks at velocities and builds no A. They are one "
         "algorithm in two forms.",
     .paper = "paper 4.1, eq (24)-(29)",
     .equations = {"(26)  v = v̄ + M⁻¹ Jᵀ η Δt                          what SI keeps up to date",
                   "(27)  η_i ← η_i + (ζ − j·v) / (j M⁻¹ jᵀ Δt)        one update of SI",
                   "(28)  η_i ← (b_i − Σ_{j≠i} A_ij η_j) / A_ii        one update of PGS",
                   "(29)  insert A = J M⁻¹ Jᵀ, b = (ζ − J v̄)/Δt and (26) into (28): (27) is left"},
     .needs = {"lesson 05", "lesson 06"},
     .reads = {"src/solvers/iterative/projected_gauss_seidel.cpp",
               "src/solvers/iterative/sequential_impulse.cpp"},
     .question =
         "PGS and SI do the same additions in another order, in float: each one is rounded, by up to 6 "
         "parts in 10\u2078. After 50 sweeps of 20 rows, in how many digits do their largest impulses "
         "still agree?",
     .spoilers = {"5.8", "5.5 · 10⁻⁵", "About six"},
     .unasked = {"seed"},
     .hints =
         {"(a + b) + c and a + (b + c) are the same number, but not the same float.",
          "Each of the 1000 updates rounds about three times. If all 3000 errors added up, they would be "
          "2 parts in 10\u2074, and 3.7 digits would be left. Do they?",
          "Errors go up and down, and a sweep pulls both towards the same answer, whatever was rounded "
          "before: little more than one digit of 7.2 is lost."},
     .parameters = {{"dt", 0.02, 0.0001, 1, "s", "time step"},
                    {"sweeps", 50, 2, 1000, "", "sweeps", Parameter::Kind::whole},
                    {"seed", 1, 0, 1e9, "", "of the random problem", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 9   (yesterday's answer is today's first guess)"});

}  // namespace cairn
