// What lesson 07 is: its title, its equations, its question, its parameters.
#include "lessons/kit/card.hpp"

namespace cairn {

const LessonCard lesson07(
    {.number = 7,
     .name = "pgs_and_si",
     .title = "PGS and SI",
     .idea = "PGS solves A λ = b and looks at no velocity; SI looks at velocities and builds no A. What does "
             "each of them know that the other does not?",
     .paper = "paper 4.1, eq (24)-(29)",
     .equations = {"(26)  v = v̄ + M⁻¹ Jᵀ η Δt                          what SI keeps up to date",
                   "(27)  η_i ← η_i + (ζ − j·v) / (j M⁻¹ jᵀ Δt)        one update of SI",
                   "(28)  η_i ← (b_i − Σ_{j≠i} A_ij η_j) / A_ii        one update of PGS",
                   "(29)  insert A = J M⁻¹ Jᵀ, b = (ζ − J v̄)/Δt and (26) into (28): (27) is left"},
     .needs = {"lesson 03", "lesson 06"},
     .reads = {"src/solvers/iterative/projected_gauss_seidel.cpp",
               "src/solvers/iterative/sequential_impulse.cpp"},
     .question =
         "PGS and SI begin with λ\u00a0=\u00a00 and visit the same 20 random rows in the same order. After "
         "ten sweeps, how many times as large is the largest error of PGS as that of SI? (3: PGS is "
         "three times as far off; below 1: SI is farther off.)",
     .spoilers = {"69 %", "one algorithm"},
     .unasked = {"sweeps", "seed"},
     .wrong = {{{1.1},
                {1000},
                "SI reads the newest velocities, but PGS reads the newest λ. What changed those velocities?"},
               {{0}, {0.9}, "SI reads two bodies only. But which rows have pushed these two?"}},
     .hints = {"Both make one λ right, row after row. What does each of them look at for that?",
               "By (26) the velocities of SI hold all λ that have been given so far.",
               "J_i v = J_i v̄ + A_i η Δt: with that (27) becomes (28)."},
     .parameters = {{"dt", 0.02, 0.0001, 1, "s", "time step"},
                    {"sweeps", 50, 2, 1000, "", "sweeps", Parameter::Kind::whole},
                    {"seed", 1, 0, 1e9, "", "of the random problem", Parameter::Kind::whole}},
     .cover = 1,
     .next = "bash lessons/run 8   (yesterday's answer is today's first guess)"});

}  // namespace cairn
