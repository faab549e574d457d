// Exercise 09: every row finds its own.
#pragma once

#include "lessons/exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise09 {

/// A row's impulse, as it was kept from the last step.
struct Kept {
  int key = 0;         // names the row from step to step
  double impulse = 0;  // [N s]
};

/// The impulses [N s] to begin a step with, one for each of `keys`, in their order: what a row of that key
/// had in the last step, and 0 for a row that is new. A step of another length needs another impulse for the
/// same force: `dt_now` and `dt_before` [s] say how long the steps are.
List<double> first_guess(const List<int>& keys, const List<Kept>& kept, double dt_now, double dt_before);

using Answer = List<double> (*)(const List<int>&, const List<Kept>&, double, double);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise09
