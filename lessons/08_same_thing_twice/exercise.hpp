// Exercise 08: a row update of PGS.
#pragma once

#include "lessons/exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise08 {

/// The new impulse eta_i [N s] of row i: equation (28), without bounds. `a` [1/kg] is A, row by row, `change`
/// [m/s] the change of velocity that every row asks for (b dt), `impulse` [N s] all impulses as they are now.
double row_update(int i, const List<List<double>>& a, const List<double>& change,
                  const List<double>& impulse);

using Answer = double (*)(int, const List<List<double>>&, const List<double>&, const List<double>&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise08
