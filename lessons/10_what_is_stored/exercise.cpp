// Exercise 10. Count the entries of A, and look at no pair of rows that does not meet.
// Then: bash lessons/run check 10
#include "lessons/kit/exercise.hpp"

namespace cairn::exercise10 {

/// The two bodies of a row.
struct RowBodies {
  int a = 0;
  int b = 0;
};

/// The rows of a scene, in any order: rows.size() of them, rows[i]. Counts how often one is looked at.
class Rows {
 public:
  explicit Rows(const List<RowBodies>& rows) : rows_(rows) {}
  Rows(const Rows&) = delete;
  Rows& operator=(const Rows&) = delete;

  int size() const { return rows_.size(); }
  const RowBodies& operator[](int row) const {
    ++looks_;
    return rows_[row];
  }
  long looks() const { return looks_; }

 private:
  List<RowBodies> rows_;
  mutable long looks_ = 0;
};

// How many entries has A = J M⁻¹ Jᵀ between rows that share a body which can move? Count the diagonal and
// both halves. inverse_mass [1/kg] is 0 for a body that cannot move; every row has one that can.
int entries(const Rows& rows, const List<double>& inverse_mass) {
  int count = 0;
  // Your code begins here: about twelve lines. From rows to bodies first, then from bodies to rows.

  // Your code ends here.
  return count;
}

}  // namespace cairn::exercise10
