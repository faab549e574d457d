// Exercise 09, graded: rows that stay, change places, come and go, and a shorter step.
#include <cmath>
#include <limits>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise09 {
namespace {

constexpr double guess_rounding = 1e-15;  // two operations on numbers near 1

/// A row of the guess; not a number where there is none.
double at(const List<double>& guess, int row) {
  return row < guess.size() ? guess[row] : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const List<Kept> kept = {{.key = 7, .impulse = 3}, {.key = 4, .impulse = 2}, {.key = 9, .impulse = 1}};
  const double dt = 0.02;
  const List<double> same = answer({7, 4, 9}, kept, dt, dt), other = answer({9, 7, 4}, kept, dt, dt);
  const List<double> changed = answer({5, 4}, kept, dt, dt), shorter = answer({7}, kept, dt / 2, dt);
  grade.number({.what = "rows 7, 4, 9 as before: guess of row 7 (N s)",
                .value = 3,
                .tolerance = guess_rounding,
                .misconceptions = {{0, "A row that was there before begins with what it had."}}},
               at(same, 0));
  grade.number(
      {.what = "in the order 9, 7, 4: guess of row 9 (N s)",
       .value = 1,
       .tolerance = guess_rounding,
       .misconceptions = {{3, "That belongs to row 7: rows are known by their key, not by their place."}}},
      at(other, 0));
  grade.number({.what = "row 5 is new: its guess (N s)",
                .value = 0,
                .tolerance = guess_rounding,
                .misconceptions = {{3, "That belongs to row 7: a new row begins with 0."}}},
               at(changed, 0));
  grade.number({.what = "row 4 behind it: its guess (N s)", .value = 2, .tolerance = guess_rounding},
               at(changed, 1));
  grade.number({.what = "how many guesses for the rows 5 and 4",
                .value = 2,
                .tolerance = 0,
                .misconceptions = {{3, "One for each row of today: what has vanished is forgotten."},
                                   {1, "A new row needs a guess as well: 0."}}},
               changed.size());
  grade.number({.what = "half the step: guess of row 7 (N s)",
                .value = 1.5,
                .tolerance = guess_rounding,
                .misconceptions = {{3, "The force stays, and the impulse is force times dt: half of it."},
                                   {6, "A shorter step needs less, not more."}}},
               at(shorter, 0));
}

Exercise exercise() {
  return {
      .lesson = 9,
      .task = "The first guess of a step: by key, 0 for what is new, and scaled with dt.",
      .file = "lessons/09_warm_start/exercise.cpp",
      .hints =
          {"Where in `kept` is the row of this key, if it is there at all?",
           "A row that is not there begins with 0. One that is there begins with the same force as before.",
           "impulse dt_now / dt_before."},
      .grade = [](Grade& marks) { grade(marks, first_guess); }};
}

}  // namespace cairn::exercise09
