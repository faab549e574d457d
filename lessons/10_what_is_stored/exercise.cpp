// Exercise 10. Count the entries of A. Then: bash lessons/run check 10
#include "lessons/kit/exercise.hpp"

namespace cairn::exercise10 {

/// The two bodies of a row.
struct RowBodies {
  int a = 0;
  int b = 0;
};

// How many entries has A = J M⁻¹ Jᵀ between rows that share a body which can move? Count the diagonal and
// both halves. inverse_mass [1/kg] is 0 for a body that cannot move; every row has one that can.
int entries(const List<RowBodies>& rows, const List<double>& inverse_mass) {
  int count = 0;
  // Your code begins here: about eight lines.

  // Your code ends here.
  return count;
}

}  // namespace cairn::exercise10
