// Exercise 08, answered.

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise08 {

double row_update(int i, const List<List<double>>& a, const List<double>& change,
                  const List<double>& impulse) {
  double missing = change[i];  // what the other rows leave to be done
  for (int k = 0; k < impulse.size(); ++k) {
    if (k != i) missing -= a[i][k] * impulse[k];
  }
  return missing / a[i][i];
}

}  // namespace cairn::exercise08
