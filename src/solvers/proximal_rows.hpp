// Floor 4. Rows made a little soft around the impulses of the moment: what Newton's method solves.
#pragma once

#include <vector>

#include "constraints/row.hpp"
#include "solvers/system_matrix.hpp"

namespace cairn {

/// One number of a sparse matrix.
struct MatrixEntry {
  int row = 0;       // from 0
  int column = 0;    // from 0
  double value = 0;  // added to what stands there
};

/// A problem in sqrt(J), as in exact_rows.hpp, but row by row and with its equalities: x_i = impulse_i
/// sqrt(A_ii) and u = M^(1/2) (v - v_before), 3 n numbers, so that u = G^T x and w = G u + c x + s. Every row
/// of G has at most the length 1.
///
/// Around a centre x', with rows softer by epsilon,
///   x_i(u) = clamp(x'_i - (w'_i + (G du)_i) / (epsilon + c_i)),   du = u - G^T x',
/// says of every velocity which impulses it calls for, friction after the normal impulses that limit it. So
/// impulses can be eliminated, however many depend on each other: what is left is to find du with
///   F(du) = du - G^T (x(du) - x') = 0.
/// F is piecewise linear but for discs; without friction it is the gradient of a strongly convex function.
class ProximalRows {
 public:
  /// Keeps what it needs; the problem's impulses are not looked at.
  explicit ProximalRows(const VelocityProblem<long double>& problem);

  /// Takes x' from impulses [N s], brought inside their bounds.
  void center_at(const std::vector<long double>& impulse);
  /// Takes x' from the last evaluation.
  void center_at_last() { center_at(impulses()); }
  /// How soft the rows are from now on.
  void soften(long double epsilon) { epsilon_ = epsilon; }

  /// 3 n: the numbers of du.
  Eigen::Index freedoms() const { return freedoms_; }
  /// |x - clamp(x - w)| at the centre: R_E times its scale.
  long double error() const;
  /// F(du).
  const Vector<long double>& evaluate(const Vector<long double>& du);
  /// F of the last evaluation.
  const Vector<long double>& value() const { return value_; }
  /// dF/du at the last evaluation: appended to `entries`, some places twice, for their sum.
  void append_slope(std::vector<MatrixEntry>& entries) const;
  /// x(du) of the last evaluation [N s].
  std::vector<long double> impulses() const;

 private:
  struct Term {
    int column = 0;
    long double value = 0;
  };
  struct Row {
    int first = 0;  // of its terms
    int count = 0;
    long double softness = 0;         // c
    long double constant = 0;         // s
    long double unit = 0;             // impulse = unit * x; 0: the row can do nothing
    Bounds<long double> bounds = {};  // in sqrt(J); those of friction and its disc as they were [N s]
  };
  enum class Mode { free, held, sliding };  // within its bounds, at a fixed one, at one that another row sets

  long double product(const Row& row, const Vector<long double>& u) const;
  long double clamp(std::size_t i, long double wish, const Vector<long double>& x) const;
  /// d clamp / d x_other, at the end that `wish` is beyond.
  long double slope_of_limit(std::size_t i, int other) const;
  void append_product(const Row& row, const Row& column, long double factor,
                      std::vector<MatrixEntry>& entries) const;
  /// Calls visit(i) for all rows, those that limit others first.
  template <typename Visit>
  void for_each_row(const Visit& visit) const {
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (!rows_[i].bounds.is_friction()) visit(i);
    for (std::size_t i = 0; i < rows_.size(); ++i)
      if (rows_[i].bounds.is_friction()) visit(i);
  }

  Eigen::Index freedoms_ = 0;
  long double epsilon_ = 1;
  std::vector<Term> terms_;
  std::vector<Row> rows_;
  Vector<long double> center_;    // x'
  Vector<long double> center_w_;  // w'
  Vector<long double> x_;         // of the last evaluation
  Vector<long double> wish_;      // the same before clamping
  Vector<long double> value_;     // F
};

}  // namespace cairn
