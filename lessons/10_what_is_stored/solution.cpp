// Exercise 10, answered.

#include "exercise.hpp"

namespace cairn::exercise10 {

int entries(const std::vector<RowBodies>& rows, const std::vector<double>& inverse_mass) {
  const auto moves = [&inverse_mass](int body) { return inverse_mass[static_cast<std::size_t>(body)] > 0; };
  const auto has = [](const RowBodies& row, int body) { return row.a == body || row.b == body; };
  int count = 0;
  for (const RowBodies& i : rows) {
    for (const RowBodies& j : rows) {
      if ((moves(i.a) && has(j, i.a)) || (moves(i.b) && has(j, i.b))) ++count;
    }
  }
  return count;
}

}  // namespace cairn::exercise10
