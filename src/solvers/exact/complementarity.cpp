// Floor 4. Rows as a linear complementarity problem.
#include <cmath>

#include <cairn/solvers/exact/exact_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// Where the unknowns of one row stand: the second one is -1 for all rows but friction, the last one, of the
/// upper bound or the speed of sliding, for rows with a lower bound alone.
struct RowUnknowns {
  int first = -1;
  int second = -1;
  int last = -1;
};

/// Lists the unknowns of all rows: `row`, `sign` and `shift`.
List<RowUnknowns> list_unknowns(const ExactRows& rows, ComplementarityProblem& problem) {
  List<RowUnknowns> unknowns;
  const auto add = [&](int row, long double sign) {
    problem.row.push_back(row);
    problem.sign.push_back(sign);
    return problem.row.size() - 1;
  };
  problem.shift = Vector<long double>::Zero(rows.bounds.size());
  for (int i = 0; i < rows.bounds.size(); ++i) {
    const ExactBounds& bounds = rows.bounds[i];
    const int row = i;
    RowUnknowns of_row;
    if (bounds.is_friction) {
      of_row.first = add(row, 1);
      of_row.second = add(row, -1);
      of_row.last = add(-1, 0);
    } else {
      const bool from_below = std::isfinite(bounds.lower);
      problem.shift(row) = from_below ? bounds.lower : bounds.upper;
      of_row.first = add(row, from_below ? 1 : -1);
      if (from_below && std::isfinite(bounds.upper)) of_row.last = add(-1, 0);
    }
    unknowns.push_back(of_row);
  }
  return unknowns;
}

/// The row of M that says how much of an upper bound, or of a limit of friction, is left.
void write_room(const ExactRows& rows, const List<RowUnknowns>& unknowns, int i,
                ComplementarityProblem& problem) {
  const ExactBounds& bounds = rows.bounds[i];
  const int last = unknowns[i].last;
  problem.M(last, unknowns[i].first) = -1;
  problem.M(unknowns[i].first, last) = 1;
  if (!bounds.is_friction) {
    problem.q(last) = bounds.upper - bounds.lower;
    return;
  }
  problem.M(last, unknowns[i].second) = -1;
  problem.M(unknowns[i].second, last) = 1;
  const auto load = [&](int normal, long double mu) {
    if (normal == ExactBounds::none) return;
    problem.M(last, unknowns[normal].first) += mu;
    problem.q(last) += mu * problem.shift(normal);
  };
  load(bounds.normal, bounds.mu);
  load(bounds.second, bounds.second_mu);
}

}  // namespace

ComplementarityProblem complementarity_problem(const ExactRows& rows) {
  ComplementarityProblem problem;
  const List<RowUnknowns> unknowns = list_unknowns(rows, problem);
  const auto n = problem.row.size();
  problem.M = Matrix<long double>::Zero(n, n);
  problem.q = Vector<long double>::Zero(n);
  const Vector<long double> w = rows.S * problem.shift + rows.s;
  for (Eigen::Index place_i = 0; place_i < n; ++place_i) {
    const int row_i = problem.row[place_i];
    if (row_i < 0) continue;
    problem.q(place_i) = problem.sign[place_i] * w(row_i);
    for (Eigen::Index place_j = 0; place_j < n; ++place_j) {
      const int row_j = problem.row[place_j];
      if (row_j >= 0) {
        problem.M(place_i, place_j) = problem.sign[place_i] * problem.sign[place_j] * rows.S(row_i, row_j);
      }
    }
  }
  for (int i = 0; i < unknowns.size(); ++i) {
    if (unknowns[i].last >= 0) write_room(rows, unknowns, i, problem);
  }
  return problem;
}

Vector<long double> unknowns_of(const ComplementarityProblem& problem, const Vector<long double>& z) {
  Vector<long double> x = problem.shift;
  for (Eigen::Index place = 0; place < z.size(); ++place) {
    if (problem.row[place] >= 0) x(problem.row[place]) += problem.sign[place] * z(place);
  }
  return x;
}

}  // namespace cairn
