// Exercise 19, graded: sweeps counted on two boxes.
#include <cmath>
#include <string>

#include "exercise.hpp"

namespace cairn::exercise19 {
namespace {

/// Gauss-Seidel on the two rows, with g = 1: how many sweeps until the load
/// on the ground lacks at most this share.
int counted(double above, double below, double share) {
  double low = 0;                             // the load on the ground, over g dt
  double speed_below = -1, speed_above = -1;  // over g dt: both boxes begin to fall
  const double weight = above + below;
  int sweeps = 0;
  do {
    const double p = -speed_below * below;  // (22) at the ground
    low += p;
    speed_below += p / below;
    const double q = (speed_below - speed_above) / (1 / below + 1 / above);  // and between the boxes
    speed_below -= q / below;
    speed_above += q / above;
    ++sweeps;
  } while (1 - low / weight > share * (1 + 1e-9) && sweeps < 100000);
  return sweeps;
}

ExpectedNumber expected(double above, double below, double share) {
  const double ratio = above / below;
  const double exact = std::log(share) / std::log(ratio / (1 + ratio));
  const auto text = [](double number) { return std::to_string(number).substr(0, 5); };
  ExpectedNumber number{.what = text(above) + " kg on " + text(below) + " kg, to " + text(share) + ": sweeps",
                        .value = static_cast<double>(counted(above, below, share)),
                        .tolerance = 0};
  number.misconceptions = {
      {std::floor(exact), "One too few: round up."},
      {std::ceil(std::log(share) / std::log(1 / (1 + ratio))), "Mind which box is above: R = above / below."},
      {std::ceil(2 * exact), "That is Jacobi, whose rate is the square root: Gauss-Seidel is twice as fast."},
      {std::ceil(exact / std::log(10.0)),
       "Mind the logarithms: rate^k = share, so k = log(share) / log(rate)."},
      {std::ceil(4.6 * ratio),
       "4.6 R is about right for 1 % and a large R; this asks for the exact number."}};
  if (ratio > 1) {
    number.misconceptions.push_back({std::ceil(std::log(share) / std::log(1 - 1 / ratio)),
                                     "A sweep leaves R / (1 + R), not 1 - 1 / R: the light box falls too."});
  }
  return number;
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  grade.number(expected(500, 1, 0.01), answer(500, 1, 0.01));
  grade.number(expected(30, 2, 0.01), answer(30, 2, 0.01));
  grade.number(expected(1, 4, 0.001), answer(1, 4, 0.001));
  grade.number(expected(70, 1, 0.5), answer(70, 1, 0.5));
}

Exercise exercise() {
  return {
      .lesson = 19,
      .task = "How many sweeps a heavy box on a light one takes, from their masses.",
      .file = "lessons/19_extremes/exercise.cpp",
      .hints = {"After k sweeps the error is (R / (1 + R))^k of what it was. For which k is that the share?",
                "Take logarithms: k log(R / (1 + R)) = log(share).",
                "ceil(log(share) / log(above / (above + below)))."},
      .grade = [](Grade& marks) { grade(marks, sweeps_needed); }};
}

}  // namespace cairn::exercise19
