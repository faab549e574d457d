// Exercise 16, graded: boxes on one to nine feet, with Jacobi in plain loops.
#include <algorithm>
#include <cmath>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise16 {
namespace {

// A box of 6 kg (I = 1 kg m^2) that comes down at 1 m/s on feet spread over its width: m v = 6 N s in all.
constexpr double inverse_mass = 1.0 / 6, inverse_inertia = 1, fall = 1, whole_push = 6;
constexpr int most_sweeps = 400;
constexpr double settled =
    1e-6;  // [N s]; the slowest mode, the tilt, has the rate 1 - 6 (mean of x^2) or less

double place_of(int foot, int feet) { return feet == 1 ? 0 : -0.5 + 1.0 * foot / (feet - 1); }

/// The sum of all impulses after each of the sweeps of Jacobi with clamping.
List<double> pushes(int feet, double omega) {
  List<double> impulse(feet, 0), sums;
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    double up = -fall, turn = 0;
    for (int i = 0; i < feet; ++i) {
      up += inverse_mass * impulse[i];
      turn += inverse_inertia * place_of(i, feet) * impulse[i];
    }
    double sum = 0;
    for (int i = 0; i < feet; ++i) {
      const double x = place_of(i, feet);
      double& own = impulse[i];
      own = std::max(own - omega * (up + x * turn) / (inverse_mass + x * x * inverse_inertia), 0.0);
      sum += own;
    }
    sums.push_back(sum);
  }
  return sums;
}

/// The first sweep from which on the sum stays right; most_sweeps: never.
int sweeps_to_settle(const List<double>& sums) {
  int first = sums.size();
  while (first > 0 && std::abs(sums[first - 1] - whole_push) <= settled) --first;
  return first;
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  grade.number({.what = "one foot: omega",
                .value = 1,
                .tolerance = 1e-12,
                .misconceptions = {{0.5, "One contact has nobody to disturb: nothing need be held back."}}},
               answer(1));
  for (const int feet : {2, 3, 5, 9}) {
    const double got = pushes(feet, answer(feet)).back();
    grade.number(
        {.what = std::to_string(feet) + " feet, after 400 sweeps: sum of impulses (N s)",
         .value = whole_push,
         .tolerance = settled,
         .misconceptions =
             {{pushes(feet, 1).back(),
               "Together the feet take back more than twice what is wrong: that is far too much."},
              {pushes(feet, 0.5).back(), "Half of the error each is still too much for so many feet."},
              {pushes(feet, 0.001).back(), "Far too careful: it takes for ever."}}},
        got);
  }
  const int needed = sweeps_to_settle(pushes(9, answer(9))), usual = sweeps_to_settle(pushes(9, 1.0 / 9));
  const double pace = needed == most_sweeps ? -1 : needed <= 2 * usual ? 1 : 0;
  grade.number({.what = "nine feet: 1 if it takes at most twice the sweeps of 1 over the number of rows",
                .value = 1,
                .tolerance = 0,
                .misconceptions = {{0, "It settles, but a larger omega would do."},
                                   {-1, "It does not settle, or far too slowly."}}},
               pace);
}

Exercise exercise() {
  return {.lesson = 16,
          .task = "The damping with which Jacobi settles for any number of contacts under a box.",
          .file = "lessons/16_jacobi/exercise.cpp",
          .hints = {"What do k equal contacts do if each of them corrects the whole error at once?",
                    "k times too much. What share of it may each of them correct?",
                    "1 / k: the sum of all corrections is then never more than the largest of them."},
          .grade = [](Grade& marks) { grade(marks, damping); }};
}

}  // namespace cairn::exercise16
