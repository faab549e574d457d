// Floor 4. Linear relations between two sets of variables, of which any two can change places.
#pragma once

#include <cstddef>

#include <cairn/solvers/system_matrix.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// x = T y + t, in long double: each of the basic variables x as a function of the other ones, y. Pivoting
/// methods walk from one such table to the next (A. W. Tucker, 1960).
class Dictionary {
 public:
  /// All zeros.
  Dictionary(int rows, int columns);

  /// Basic variables.
  int rows() const { return rows_; }
  /// The other variables.
  int columns() const { return columns_; }
  /// Row i of T, and t_i behind it.
  long double* row(int i) { return values_.data() + i * stride(); }
  /// The same to look at.
  const long double* row(int i) const { return values_.data() + i * stride(); }
  /// t_i.
  long double constant(int i) const { return row(i)[columns_]; }
  /// Makes `value` of t_i.
  void set_constant(int i, long double value) { row(i)[columns_] = value; }

  /// x_i and y_j change places. T_ij must not be 0. O(rows columns).
  void exchange(int i, int j);

 private:
  int stride() const { return columns_ + 1; }

  int rows_ = 0;
  int columns_ = 0;
  List<long double> values_;
};

/// All solutions of M x = rhs: the sums of one of them and of the columns of null_space.
struct LinearSolutions {
  int rank = 0;                    // of M
  Vector<long double> solution;    // one solution, or the nearest to one
  Matrix<long double> null_space;  // its columns make M x = 0
  long double contradiction = 0;   // the largest error of any equation at `solution`
};

/// Gauss-Jordan elimination with complete pivoting: pivots up to `threshold` are zeros. O(rows columns rank).
LinearSolutions solve_linear(const Matrix<long double>& M, const Vector<long double>& rhs,
                             long double threshold);

}  // namespace cairn
