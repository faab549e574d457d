// Exercise 08: a row update of PGS.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise08 {

/// The new impulse eta_i [N s] of row i: equation (28), without bounds. `a` [1/kg] is A, row by row, `change`
/// [m/s] the change of velocity that every row asks for (b dt), `impulse` [N s] all impulses as they are now.
double row_update(int i, const std::vector<std::vector<double>>& a, const std::vector<double>& change,
                  const std::vector<double>& impulse);

using Answer = double (*)(int, const std::vector<std::vector<double>>&, const std::vector<double>&,
                          const std::vector<double>&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise08
