// Exercise 08, answered.

#include "exercise.hpp"

namespace cairn::exercise08 {

double row_update(int i, const std::vector<std::vector<double>>& a, const std::vector<double>& change,
                  const std::vector<double>& impulse) {
  const auto row = static_cast<std::size_t>(i);
  double missing = change[row];  // what the other rows leave to be done
  for (std::size_t k = 0; k < impulse.size(); ++k) {
    if (k != row) missing -= a[row][k] * impulse[k];
  }
  return missing / a[row][row];
}

}  // namespace cairn::exercise08
