// Floor 4. Directions in which impulses can change without any effect.
#include <cairn/solvers/exact/impulse_family.hpp>

#include <cmath>

#include <cairn/solvers/exact/dictionary.hpp>
#include <cairn/solvers/exact/lemke.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

constexpr long double family_rounding = 1e-11L;  // beside rows.size: of w and of distances to bounds
constexpr long double family_pivot = 1e-13L;     // of rows of S with ones on the diagonal

/// Conditions on a change dx: what must be 0, and what must not fall.
struct Conditions {
  List<Vector<long double>> zero;
  List<Vector<long double>> not_falling;
};

Matrix<long double> matrix_of(const List<Vector<long double>>& rows, Eigen::Index columns) {
  Matrix<long double> matrix(rows.size(), columns);
  for (int i = 0; i < rows.size(); ++i) {
    matrix.row(i) = rows[i].transpose();
  }
  return matrix;
}

/// How the room changes between x_i and the end of its interval: the upper one for side 1, else -1.
Vector<long double> change_of_room(const ExactRows& rows, Eigen::Index i, long double side) {
  const ExactBounds& bounds = rows.bounds[i];
  Vector<long double> change = Vector<long double>::Zero(rows.s.size());
  change(i) = -side;
  if (bounds.normal != ExactBounds::none) change(bounds.normal) += bounds.mu;
  if (bounds.second != ExactBounds::none) change(bounds.second) += bounds.second_mu;
  return change;
}

void add_conditions(const ExactRows& rows, const Vector<long double>& x, Eigen::Index i, long double w,
                    Conditions& conditions) {
  const ExactBounds& bounds = rows.bounds[i];
  const long double small = family_rounding * rows.size;
  const long double limit = bounds.is_friction ? bounds.limit(x) : 0;
  const long double to_upper = (bounds.is_friction ? limit : bounds.upper) - x(i);
  const long double to_lower = x(i) + (bounds.is_friction ? limit : -bounds.lower);
  for (const long double side : {1.0L, -1.0L}) {
    const bool is_held = side * w < -small;  // w < 0 keeps x at its upper end
    const bool is_at_end = (side > 0 ? to_upper : to_lower) <= small;
    if (is_held) {
      conditions.zero.push_back(change_of_room(rows, i, side));
    } else if (is_at_end) {
      conditions.not_falling.push_back(change_of_room(rows, i, side));
    }
  }
}

/// Whether some y other than 0 has G y >= 0.
bool has_direction(const Matrix<long double>& G) {
  const Vector<long double> none = Vector<long double>::Zero(G.rows());
  if (solve_linear(G, none, family_pivot).rank < G.cols()) return true;
  // Now G y >= 0 and sum G y = 0 mean y = 0: so some y has sum G y = 1, or there is none.
  Matrix<long double> H(G.rows() + 1, G.cols());
  H.topRows(G.rows()) = G;
  H.row(G.rows()) = G.colwise().sum();
  Vector<long double> h = Vector<long double>::Zero(G.rows() + 1);
  h(G.rows()) = 1;
  return feasible_point(H, h).exists;
}

}  // namespace

FeasiblePoint feasible_point(const Matrix<long double>& H, const Vector<long double>& h) {
  const Matrix<long double> gram = H * H.transpose();
  const LemkeResult result = lemke(gram, -h);
  FeasiblePoint point;
  point.exists = result.status == LemkeStatus::solved;
  if (point.exists) point.y = H.transpose() * result.z;
  return point;
}

bool has_unique_impulse(const ExactRows& rows, const Vector<long double>& x) {
  const Eigen::Index n = x.size();
  if (n == 0) return true;
  Conditions conditions;
  const Vector<long double> w = rows.S * x + rows.s;
  for (Eigen::Index i = 0; i < n; ++i) {
    conditions.zero.push_back(rows.S.row(i).transpose());
    add_conditions(rows, x, i, w(i), conditions);
  }
  const Matrix<long double> zero = matrix_of(conditions.zero, n);
  const Vector<long double> none = Vector<long double>::Zero(zero.rows());
  const Matrix<long double> N = solve_linear(zero, none, family_pivot).null_space;
  if (N.cols() == 0) return true;
  if (conditions.not_falling.empty()) return false;
  return !has_direction(matrix_of(conditions.not_falling, n) * N);
}

}  // namespace cairn
