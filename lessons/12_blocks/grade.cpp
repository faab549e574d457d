// Exercise 12, graded: the rod of the lesson at 45 degrees, and a block whose rows nearly say the same.
#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise12 {
namespace {

constexpr double block_rounding = 1e-15;  // a few operations on numbers near 1

}  // namespace

void grade(Grade& grade, Answer answer) {
  // The rod: K = (2.5 -1.5; -1.5 2.5), gravity has given its pin (0, -0.2) m/s, so (0, 0.2) is asked for.
  const FixedList<double, 2> rod = answer(2.5, -1.5, 2.5, {0, 0.2});
  grade.number({.what = "rod at 45 degrees: impulse along x (N s)",
                .value = 0.075,
                .tolerance = block_rounding,
                .misconceptions = {{0, "Each row for itself: the other row's impulse comes in by k12."},
                                   {-0.075, "The sign of k12 in the inverse."},
                                   {0.3, "The determinant: divide by k11 k22 - k12 k12."}}},
               rod[0]);
  grade.number({.what = "rod at 45 degrees: impulse along y (N s)",
                .value = 0.125,
                .tolerance = block_rounding,
                .misconceptions = {{0.08, "Each row for itself: the other row's impulse comes in by k12."},
                                   {0.5, "The determinant: divide by k11 k22 - k12 k12."},
                                   {-0.125, "The sign: K x is the change that is asked for."}}},
               rod[1]);
  // With k11 and k22 that differ: x = (1, -2) by construction.
  const FixedList<double, 2> other = answer(4, 1, 2, {4 - 2, 1 - 4});
  grade.number({.what = "K = (4 1; 1 2), change (2, -3): first impulse (N s)",
                .value = 1,
                .tolerance = 4 * block_rounding,
                .misconceptions = {{11.0 / 7, "k11 and k22 change places in the inverse."}}},
               other[0]);
  grade.number({.what = "K = (4 1; 1 2), change (2, -3): second impulse (N s)",
                .value = -2,
                .tolerance = 4 * block_rounding,
                .misconceptions = {{-8.0 / 7, "k11 and k22 change places in the inverse."}}},
               other[1]);
}

Exercise exercise() {
  return {.lesson = 12,
          .task = "Both impulses of a pin at once: a 2 x 2 system.",
          .file = "lessons/12_blocks/exercise.cpp",
          .hints = {"Two equations: k11 x + k12 y = change_x and k12 x + k22 y = change_y.",
                    "The inverse of K is (k22 -k12; -k12 k11) over k11 k22 - k12 k12.",
                    "x = (k22 change_x - k12 change_y) / det, y = (k11 change_y - k12 change_x) / det."},
          .grade = [](Grade& marks) { grade(marks, solve_block); }};
}

}  // namespace cairn::exercise12
