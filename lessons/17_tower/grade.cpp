// Exercise 17, graded: sweeps counted on the slowest error of stacks.
#include <cmath>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise17 {
namespace {

/// Gauss-Seidel on A lambda = 0 of so many boxes, from the slowest error: how many sweeps until it has shrunk
/// so far.
int counted(int boxes, double share) {
  const double pi = std::acos(-1.0), root = std::cos(pi / (2.0 * boxes));
  List<double> error(boxes);
  // A = tridiag(-1, 2, -1) with A_00 = 1. Jacobi's slowest error is cos(i pi / (2 n)) with the rate `root`,
  // and that of Gauss-Seidel is the same times root^i, with the rate root^2 (D. M. Young, 1954).
  for (int i = 0; i < boxes; ++i) error[i] = std::pow(root, i) * std::cos(i * pi / (2.0 * boxes));
  const double start = error[0];
  int sweeps = 0;
  while (std::abs(error[0]) > share * start * (1 + 1e-9) && sweeps < 100000) {
    for (int i = 0; i < boxes; ++i) {
      const double below = i > 0 ? error[i - 1] : 0, above = i + 1 < boxes ? error[i + 1] : 0;
      error[i] = i == 0 ? above : (below + above) / 2;
    }
    ++sweeps;
  }
  return sweeps;
}

ExpectedNumber expected(int boxes, double share) {
  const double pi = std::acos(-1.0), root = std::cos(pi / (2.0 * boxes));
  const double right = counted(boxes, share);
  return {.what = std::to_string(boxes) + " boxes, to " + std::to_string(share).substr(0, 5) + ": sweeps",
          .value = right,
          .tolerance = 0,
          .misconceptions = {{std::ceil(std::log(share) / std::log(root)),
                              "That is Jacobi: Gauss-Seidel squares the cosine."},
                             {std::floor(std::log(share) / std::log(root * root)), "One too few: round up."},
                             {std::ceil(std::log(1 / share)), "Where is the height of the tower?"},
                             {std::ceil(std::log10(1 / share) / (1 - root * root)),
                              "Mind the logarithms: rate^k = share, so k = log(share) / log(rate)."}}};
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  for (const int boxes : {3, 10, 20}) grade.number(expected(boxes, 0.01), answer(boxes, 0.01));
  grade.number(expected(10, 0.5), answer(10, 0.5));
}

Exercise exercise() {
  return {.lesson = 17,
          .task = "How many sweeps the slowest error of a tower takes, from its rate.",
          .file = "lessons/17_tower/exercise.cpp",
          .hints = {"After k sweeps the error is rate^k times what it was. For which k is that the share?",
                    "Take logarithms: k log(rate) = log(share).",
                    "ceil(log(share) / log(rate)) with rate = cos^2(pi / (2 n))."},
          .grade = [](Grade& marks) { grade(marks, sweeps_needed); }};
}

}  // namespace cairn::exercise17
