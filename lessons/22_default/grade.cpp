// Exercise 22, graded: the stack and the rod of lessons 03 and 06, a box that is lifted, and rows without an
// answer.
#include "exercise.cpp"

namespace cairn::exercise22 {
namespace {

struct Solved {
  List<double> lambda;
  int systems = 0;
};

Solved counted(const Matrix& A, const List<double>& b) {
  systems = 0;
  const List<double> lambda = all_at_once(A, b);
  return {lambda, systems};
}

/// Boxes of 2, 0.5 and 2 kg: each contact carries what stands on it. Returns the systems that it took.
int grade_stack(Grade& grade) {
  const auto [lambda, count] = counted({{0.5, -0.5, 0}, {-0.5, 2.5, -2}, {0, -2, 2.5}}, {10, 0, 0});
  grade.number({.what = "a stack of 2, 0.5 and 2 kg: λ_1 (N)",
                .value = 45,
                .misconceptions = {{0, "Solve the rows that push: drop what pulls, λ < 0."}}},
               lambda[0]);
  grade.number({.what = "the same: systems",
                .value = 1,
                .misconceptions = {{4, "Begin with the guess that all push: here it is right."},
                                   {20, "Stop as soon as no guess was wrong."}}},
               count);
  return count;
}

/// The rod of lesson 06: all rows at once say (-20, 60).
void grade_rod(Grade& grade, bool can_stop) {
  const auto [lambda, count] = counted({{1, 0.5}, {0.5, 1.0 / 3}}, {10, 10});
  grade.number({.what = "the rod of lesson 06: λ_1 (N)", .value = 0}, lambda[0]);
  grade.number({.what = "the rod of lesson 06: λ_2 (N)",
                .value = 30,
                .misconceptions = {{60, "λ_1 would pull: drop it, and solve again without it."}}},
               lambda[1]);
  grade.number({.what = "the rod of lesson 06: systems",
                .value = 2,
                .misconceptions = {{20, can_stop ? "A row with w > 0 opens, and needs no push." : ""}}},
               count);
}

/// A box of 0.5 kg is lifted with 40 N off one of 2 kg. The first guess gives (-15, -35): both are dropped,
/// and the lower box sinks.
void grade_lift(Grade& grade) {
  const auto [lambda, count] = counted({{0.5, -0.5}, {-0.5, 2.5}}, {10, -80});
  grade.number({.what = "0.5 kg lifted off 2 kg by 40 N: λ_1 (N)",
                .value = 20,
                .misconceptions = {{0, count == 2 ? "Add the rows that sink: w = A λ - b < 0."
                                                  : "The sign of b: w = A λ - b."}}},
               lambda[0]);
  grade.number({.what = "0.5 kg lifted off 2 kg by 40 N: λ_2 (N)", .value = 0}, lambda[1]);
}

/// Rows for which there is no answer: w_1 = -λ_1 - 2 λ_2 - 1 is below 0 for all λ >= 0. In every second
/// system, the 20th too, λ_1 is -1.
void grade_endless(Grade& grade) {
  const auto [lambda, count] = counted({{-1, -2}, {0, 1}}, {1, -1});
  grade.number({.what = "rows without an answer: systems",
                .value = 20,
                .misconceptions = {{21, "At most 20 systems."}, {19, "At most 20 systems, and 20 too."}}},
               count);
  grade.number({.what = "rows without an answer: λ_1 that is kept (N)",
                .value = 0,
                .misconceptions = {{-1, "The last guess may be wrong: keep 0 for every λ that pulls."}}},
               lambda[0]);
}

void grade(Grade& grade) {
  const bool can_stop = grade_stack(grade) == 1;
  grade_rod(grade, can_stop);
  grade_lift(grade);
  grade_endless(grade);
}

}  // namespace

Exercise exercise() {
  return {.lesson = 22,
          .task = "All rows at once: guess which contacts push, solve, and correct the guess.",
          .file = "lessons/22_default/exercise.cpp",
          .hints = {"solved(A, b, pushes) does the linear system; yours is the loop that corrects pushes.",
                    "Row i was guessed wrong if it pushes and λ_i < 0, or does not push and w_i < 0.",
                    "w_i = -b_i + Σ A_ij λ_j, over all j. Turn wrong guesses round; stop where none is."},
          .grade = grade};
}

}  // namespace cairn::exercise22
