// Exercise 08. Write a row update of PGS. Then: bash lessons/run check 8
// Equation (28) without bounds, in impulses: row i of A, the change of velocity that row i asks for (b dt),
// and all impulses as they are now. Return the new impulse of row i.
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise08 {

double row_update(int i, const List<List<double>>& a, const List<double>& change,
                  const List<double>& impulse) {
  (void)i, (void)a, (void)change, (void)impulse;
  return std::nan("");  // <- your code
}

}  // namespace cairn::exercise08
