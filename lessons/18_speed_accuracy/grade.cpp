// Exercise 18, graded: Young's formula, and sweeps counted with plain loops.
#include <algorithm>
#include <cmath>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise18 {
namespace {

constexpr double root_rounding = 1e-12;  // of a root of 1 - cos^2, which loses four digits at the most

/// The largest error of a tower's loads, as a share of the largest load, after so many sweeps of SOR.
double error_after(int boxes, double omega, int sweeps) {
  List<double> load(boxes, 0);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < boxes; ++i) {
      const double below = i > 0 ? load[i - 1] : 0, above = i + 1 < boxes ? load[i + 1] : 0;
      const double wanted = i == 0 ? 1 + above : (below + above) / 2;
      load[i] = std::max(0.0, load[i] + omega * (wanted - load[i]));
    }
  }
  double worst = 0;
  for (int i = 0; i < boxes; ++i) worst = std::max(worst, std::abs(load[i] - (boxes - i)));
  return worst / boxes;
}

ExpectedNumber expected(int boxes) {
  const double pi = std::acos(-1.0), jacobi = std::cos(pi / (2.0 * boxes));
  return {.what = std::to_string(boxes) + " boxes: omega",
          .value = 2 / (1 + std::sin(pi / (2.0 * boxes))),
          .tolerance = root_rounding,
          .misconceptions = {
              {1, "That is Gauss-Seidel: nothing is relaxed."},
              {2 / (1 + std::sqrt(1 - jacobi)), "The square of Jacobi's rate belongs under the root."},
              {2 / (1 + std::sqrt(1 - std::pow(jacobi, 4))),
               "Jacobi's rate, not that of Gauss-Seidel, is squared under the root."},
              {2 / (1 + std::sin(pi / boxes)), "The angle is pi / (2 n)."},
              {2, "At 2 no error ever shrinks."}}};
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  for (const int boxes : {2, 10, 40}) grade.number(expected(boxes), answer(boxes));
  const double omega = answer(20);
  const double own = error_after(20, omega, 80);
  const bool is_best = own <= error_after(20, omega - 0.05, 80) && own <= error_after(20, omega + 0.05, 80);
  grade.number({.what = "20 boxes, 80 sweeps: 1 if omega - 0.05 and omega + 0.05 are worse",
                .value = 1,
                .tolerance = 0,
                .misconceptions = {{0, "A neighbour does better: it is not the best yet."}}},
               is_best ? 1 : 0);
}

Exercise exercise() {
  return {
      .lesson = 18,
      .task = "The over-relaxation with which a tower takes the fewest sweeps.",
      .file = "lessons/18_speed_accuracy/exercise.cpp",
      .hints =
          {"The mean of rho and 1 is cos^2 of an angle, and 2 cos^2(x) - 1 = cos(2 x). Which rho is that?",
           "rho is Jacobi's rate, cos(pi / (2 n)).",
           "sqrt(1 - cos^2) = sin: omega = 2 / (1 + sin(pi / (2 n)))."},
      .grade = [](Grade& marks) { grade(marks, best_relaxation); }};
}

}  // namespace cairn::exercise18
