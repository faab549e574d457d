// Floor 4. Units, equalities and bounds of an exact problem.
#include <cairn/solvers/exact/exact_rows.hpp>

#include <algorithm>
#include <cmath>

#include <cairn/math/check.hpp>
#include <cairn/solvers/body_rows.hpp>
#include <cairn/solvers/exact/dictionary.hpp>
#include <cairn/solvers/residual.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

// With ones on the diagonal of A, a pivot is the squared sine of the angle between a row and those before
// it. Rows that depend on each other but for rounding in double are 1e-16 apart: far below this.
constexpr long double dependent_pivot = 1e-14L;
// Beside the largest |s_i|: biases that differ by no more agree.
constexpr long double bias_rounding = 1e-12L;

/// A of (15) in sqrt(J): only pairs of rows that share a body are visited.
Matrix<long double> scaled_matrix(const VelocityProblem<long double>& problem,
                                  const PerRow<long double>& unit) {
  const int m = problem.row_count();
  Matrix<long double> A = Matrix<long double>::Zero(m, m);
  BodyRows body_rows;
  body_rows.build(problem, problem.inverse_mass);
  List<int> neighbours;
  for (int row_i = 0; row_i < m; ++row_i) {
    neighbours.clear();
    body_rows.append_neighbours(row_i, neighbours);
    for (const int row_j : neighbours) {
      if (row_j > row_i) continue;
      const long double entry =
          coupling(problem, problem.rows[row_i], problem.rows[row_j], problem.inverse_mass);
      A(row_i, row_j) = A(row_j, row_i) = unit[row_i] * entry * unit[row_j];
    }
    if (unit[row_i] > 0) A(row_i, row_i) = 1;  // softness included
  }
  return A;
}

PerRow<long double> units_of(const VelocityProblem<long double>& problem) {
  PerRow<long double> unit;
  for (const ConstraintRow<long double>& row : problem.rows) {
    const long double inverse = inverse_effective_mass(problem, row);
    unit.push_back(inverse > 0 ? 1 / std::sqrt(inverse) : 0.0L);
  }
  return unit;
}

/// Bounds of row i in sqrt(J), with the other rows counted as `place` says.
ExactBounds scaled_bounds(const VelocityProblem<long double>& problem, int i, const PerRow<long double>& unit,
                          const List<int>& place) {
  const Bounds<long double>& bounds = problem.rows[i].bounds;
  ExactBounds result;
  if (!bounds.is_friction()) {
    result.lower = bounds.lower / unit[i];
    result.upper = bounds.upper / unit[i];
    return result;
  }
  require(!(bounds.disc > 0), "ReferenceSolver", "bounds", "linear: two rows that share a disc are not",
          static_cast<double>(bounds.disc));
  require(bounds.friction >= 0 && std::isfinite(bounds.friction), "ReferenceSolver", "friction",
          "a finite number >= 0", static_cast<double>(bounds.friction));
  result.is_friction = true;
  const auto load = [&](int row, int& normal, long double& mu) {
    if (row == Bounds<long double>::none || !(unit[row] > 0)) return;
    const Bounds<long double>& other = problem.rows[row].bounds;
    require(!other.is_friction() && other.lower >= 0, "ReferenceSolver", "normal_row",
            "a row of impulses >= 0", row);
    normal = place[row];
    mu = bounds.friction * unit[row] / unit[i];
  };
  load(bounds.normal_row, result.normal, result.mu);
  load(bounds.second_normal_row, result.second, result.second_mu);
  return result;
}

/// w = A x + r, solved for x_i at w_i = 0 for as many equalities as are independent: moves those from
/// `dependent` to `solved`.
Dictionary solved_equalities(const Matrix<long double>& A, const Vector<long double>& r, List<int>& dependent,
                             List<int>& solved) {
  const int m = static_cast<int>(r.size());
  Dictionary table(m, m);
  for (int i = 0; i < m; ++i) {
    for (int j = 0; j < m; ++j) table.row(i)[j] = A(i, j);
    table.set_constant(i, r(i));
  }
  while (!dependent.empty()) {
    const auto best = std::max_element(dependent.begin(), dependent.end(),
                                       [&](int i, int j) { return table.row(i)[i] < table.row(j)[j]; });
    if (!(table.row(*best)[*best] > dependent_pivot)) break;
    table.exchange(*best, *best);
    solved.push_back(*best);
    dependent.erase(best);
  }
  return table;
}

/// Takes from the r of equalities what no impulses can fulfil: its part in the null space of their matrix,
/// which `table` has as a column for every dependent row.
Vector<long double> fulfillable(const Dictionary& table, const Vector<long double>& r,
                                const List<int>& dependent, const List<int>& solved) {
  const int count = dependent.size();
  Matrix<long double> N = Matrix<long double>::Zero(r.size(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const int d = dependent[k];
    N(d, k) = 1;
    for (const int i : solved) N(i, k) = table.row(i)[d];
  }
  const Matrix<long double> gram = N.transpose() * N;
  const Vector<long double> share = N.transpose() * r;
  return r - N * solve_linear(gram, share, 0).solution;
}

void keep_rows(const Dictionary& table, ExactReduction& reduction) {
  const auto kept = reduction.kept.size();
  const auto solved = reduction.eliminated.size();
  const auto copy = [&](const List<int>& places, Matrix<long double>& matrix, Vector<long double>& constant) {
    for (int i = 0; i < places.size(); ++i) {
      const auto row = i;
      for (Eigen::Index j = 0; j < kept; ++j) {
        matrix(row, j) = table.row(places[i])[reduction.kept[j]];
      }
      constant(row) = table.constant(places[i]);
    }
  };
  reduction.rows.S.resize(kept, kept);
  reduction.rows.s.resize(kept);
  reduction.T.resize(solved, kept);
  reduction.t.resize(solved);
  copy(reduction.kept, reduction.rows.S, reduction.rows.s);
  copy(reduction.eliminated, reduction.T, reduction.t);
}

/// M^(1/2) M^-1 J^T in these units, with the impulses of the equalities that follow.
Matrix<long double> effect_of(const VelocityProblem<long double>& problem, const ExactReduction& reduction) {
  const auto kept = reduction.kept.size();
  Matrix<long double> effect = Matrix<long double>::Zero(3 * problem.body_count(), kept);
  if (kept == 0) return effect;  // Eigen would take a row of nothing at an address beside null
  const auto add = [&](int row, const auto& share) {
    for_each_term(problem, problem.rows[row], [&](BodyId body, const Vec3<long double>& jacobian) {
      const Vec3<long double>& inverse = problem.inverse_mass[body];
      for (int axis = 0; axis < 3; ++axis) {
        const long double change = std::sqrt(inverse(axis)) * jacobian(axis) * reduction.unit[row];
        if (change != 0) effect.row(3 * body.index + axis) += change * share;
      }
    });
  };
  const Matrix<long double> one = Matrix<long double>::Identity(kept, kept);
  for (Eigen::Index k = 0; k < kept; ++k) add(reduction.kept[k], one.row(k));
  for (Eigen::Index k = 0; k < reduction.T.rows(); ++k) {
    add(reduction.eliminated[k], reduction.T.row(k));
  }
  return effect;
}

}  // namespace

long double ExactBounds::limit(const Vector<long double>& x) const {
  long double sum = 0;
  if (normal != none) sum += mu * std::max(x(normal), 0.0L);
  if (second != none) sum += second_mu * std::max(x(second), 0.0L);
  return sum;
}

long double ExactBounds::clamp(long double value, const Vector<long double>& x) const {
  if (!is_friction) return std::max(std::min(value, upper), lower);
  const long double largest = limit(x);
  return std::max(std::min(value, largest), -largest);
}

template <Scalar Real>
Real exact_scale(const VelocityProblem<Real>& problem) {
  Real sum = 0;
  for (const ConstraintRow<Real>& row : problem.rows) {
    const Real inverse = inverse_effective_mass(problem, row), w = row_velocity(problem, row) - row.bias;
    if (inverse > 0) sum += w * w / inverse;
  }
  return std::max(residual_scale(problem), Real(1e-3) * std::sqrt(sum));
}

template double exact_scale(const VelocityProblem<double>&);
template long double exact_scale(const VelocityProblem<long double>&);

ExactReduction reduce_to_exact_rows(const VelocityProblem<long double>& problem) {
  ExactReduction reduction;
  reduction.unit = units_of(problem);
  const int m = problem.rows.size();
  Vector<long double> r = Vector<long double>::Zero(m);
  List<int> dependent, place(m, 0);
  for (int i = 0; i < m; ++i) {
    if (!(reduction.unit[i] > 0)) continue;
    const ConstraintRow<long double>& row = problem.rows[i];
    r(i) = reduction.unit[i] * (row_velocity(problem, row) - row.bias);
    place[i] = reduction.kept.size();
    (row.bounds.is_equality() ? dependent : reduction.kept).push_back(i);
  }
  reduction.rows.size = m > 0 ? r.cwiseAbs().maxCoeff() : 0;
  const Matrix<long double> A = scaled_matrix(problem, reduction.unit);
  const List<int> equalities = dependent;
  Dictionary table = solved_equalities(A, r, dependent, reduction.eliminated);
  for (const int d : dependent) {
    const long double left = std::abs(table.constant(d));
    if (left > bias_rounding * reduction.rows.size) reduction.contradictory_equalities = true;
  }
  reduction.redundant_equalities = !dependent.empty();
  if (!dependent.empty()) {
    Vector<long double> of_equalities = Vector<long double>::Zero(r.size());
    for (const int i : equalities) of_equalities(i) = r(i);
    const Vector<long double> agreed = fulfillable(table, of_equalities, dependent, reduction.eliminated);
    for (const int i : equalities) r(i) = agreed(i);
    dependent = equalities;
    reduction.eliminated.clear();
    table = solved_equalities(A, r, dependent, reduction.eliminated);
  }
  for (const int i : reduction.kept) {
    reduction.rows.bounds.push_back(scaled_bounds(problem, i, reduction.unit, place));
  }
  keep_rows(table, reduction);
  reduction.rows.effect = effect_of(problem, reduction);
  return reduction;
}

PerRow<long double> impulses_of(const ExactReduction& reduction, const Vector<long double>& x) {
  PerRow<long double> impulse(reduction.unit.size(), 0);
  const auto set = [&](const List<int>& places, const Vector<long double>& values) {
    for (int k = 0; k < places.size(); ++k) {
      const auto row = places[k];
      impulse[row] = reduction.unit[row] * values(k);
    }
  };
  set(reduction.kept, x);
  set(reduction.eliminated, reduction.T * x + reduction.t);
  return impulse;
}

Vector<long double> natural_error(const ExactRows& rows, const Vector<long double>& x) {
  Vector<long double> error = rows.S * x + rows.s;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    error(i) = x(i) - rows.bounds[i].clamp(x(i) - error(i), x);
  }
  return error;
}

}  // namespace cairn
