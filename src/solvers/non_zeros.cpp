// Floor 4. Counting row by row over the rows that share a body: no A is formed.
#include <cairn/solvers/non_zeros.hpp>

#include <cairn/solvers/body_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// Pairs of rows with J_i W J_j^T != 0.
template <Scalar Real>
std::ptrdiff_t count_non_zero_couplings(const VelocityProblem<Real>& problem,
                                        const PerBody<Vec3<Real>>& weight) {
  BodyRows body_rows;
  body_rows.build(problem, weight);
  List<int> neighbours;
  std::ptrdiff_t count = 0;
  for (int i = 0; i < problem.row_count(); ++i) {
    neighbours.clear();
    body_rows.append_neighbours(i, neighbours);
    for (const int j : neighbours) {
      count += coupling(problem, problem.rows[i], problem.rows[j], weight) != Real(0);
    }
  }
  return count;
}

}  // namespace

template <Scalar Real>
std::ptrdiff_t non_zeros_as_printed(const VelocityProblem<Real>& problem) {
  const PerBody<Vec3<Real>> ones(problem.inverse_mass.size(), Vec3<Real>::Ones());
  return count_non_zero_couplings(problem, ones);
}

template <Scalar Real>
std::ptrdiff_t non_zeros(const VelocityProblem<Real>& problem) {
  return count_non_zero_couplings(problem, problem.inverse_mass);
}

template <Scalar Real>
std::ptrdiff_t coupled_pairs(const VelocityProblem<Real>& problem) {
  BodyRows body_rows;
  body_rows.build(problem, problem.inverse_mass);
  List<int> neighbours;
  std::ptrdiff_t count = 0;
  for (int i = 0; i < problem.row_count(); ++i) {
    neighbours.clear();
    body_rows.append_neighbours(i, neighbours);
    count += neighbours.size();
  }
  return count;
}

template std::ptrdiff_t non_zeros_as_printed(const VelocityProblem<float>&);
template std::ptrdiff_t non_zeros_as_printed(const VelocityProblem<double>&);
template std::ptrdiff_t non_zeros_as_printed(const VelocityProblem<long double>&);
template std::ptrdiff_t non_zeros(const VelocityProblem<float>&);
template std::ptrdiff_t non_zeros(const VelocityProblem<double>&);
template std::ptrdiff_t non_zeros(const VelocityProblem<long double>&);
template std::ptrdiff_t coupled_pairs(const VelocityProblem<float>&);
template std::ptrdiff_t coupled_pairs(const VelocityProblem<double>&);
template std::ptrdiff_t coupled_pairs(const VelocityProblem<long double>&);

}  // namespace cairn
