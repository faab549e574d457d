// Exercise 10, answered.

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise10 {

int entries(const List<RowBodies>& rows, const List<double>& inverse_mass) {
  const auto moves = [&inverse_mass](int body) { return inverse_mass[body] > 0; };
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
