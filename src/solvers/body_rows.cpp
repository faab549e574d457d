// Floor 4. Lists of rows by body, by counting.
#include <cairn/solvers/body_rows.hpp>
#include <cairn/math/list.hpp>

#include <algorithm>
#include <cstddef>

namespace cairn {

template <Scalar Real>
Real coupling(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& first,
              const ConstraintRow<Real>& second, const PerBody<Vec3<Real>>& weight) {
  Real sum = 0;
  for_each_term(problem, first, [&](BodyId body, const Vec3<Real>& jacobian) {
    const Vec3<Real> weighted = weight[body].cwiseProduct(jacobian);
    Real of_body = 0;
    for_each_term(problem, second, [&](BodyId other, const Vec3<Real>& other_jacobian) {
      if (other == body) of_body += dot(weighted, other_jacobian);
    });
    sum += of_body;
  });
  return sum;
}

template <Scalar Real>
void BodyRows::build(const VelocityProblem<Real>& problem, const PerBody<Vec3<Real>>& weight) {
  first_body_.assign(1, 0);
  bodies_.clear();
  first_.assign(weight.size() + 1, 0);
  for (const ConstraintRow<Real>& row : problem.rows) {
    const int begin = bodies_.size();
    for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
      const bool acts = (weight[body].array() * jacobian.array() != Real(0)).any();
      if (!acts || std::find(bodies_.begin() + begin, bodies_.end(), body) != bodies_.end()) return;
      bodies_.push_back(body);
      first_[body.index + 1] += 1;
    });
    first_body_.push_back(bodies_.size());
  }
  for (int body = 1; body < first_.size(); ++body) first_[body] += first_[body - 1];

  // Filled from the last row to the first, each list from its end: first_[body + 1] walks down to where the
  // list begins, and that is where first_[body] has to be.
  rows_.resize(first_.back());
  for (int i = problem.rows.size(); i-- > 0;) {
    for (std::ptrdiff_t k = first_body_[i]; k < first_body_[i + 1]; ++k) {
      rows_[--first_[bodies_[k].index + 1]] = i;
    }
  }
  std::shift_left(first_.begin(), first_.end(), 1);
  first_.back() = rows_.size();
}

void BodyRows::append_neighbours(int i, List<int>& neighbours) const {
  const int old = neighbours.size();
  for (std::ptrdiff_t k = first_body_[i]; k < first_body_[i + 1]; ++k) {
    const int body = bodies_[k].index;
    neighbours.insert(neighbours.end(), rows_.begin() + first_[body], rows_.begin() + first_[body + 1]);
  }
  std::sort(neighbours.begin() + old, neighbours.end());
  neighbours.erase(std::unique(neighbours.begin() + old, neighbours.end()), neighbours.end());
}

std::ptrdiff_t BodyRows::pairs() const {
  std::ptrdiff_t sum = 0;
  for (int body = 0; body + 1 < first_.size(); ++body) {
    const std::ptrdiff_t count = first_[body + 1] - first_[body];
    sum += count * count;
  }
  return sum;
}

std::size_t BodyRows::memory() const {
  return first_body_.bytes() + bodies_.bytes() + first_.bytes() + rows_.bytes();
}

template float coupling(const VelocityProblem<float>&, const ConstraintRow<float>&,
                        const ConstraintRow<float>&, const PerBody<Vec3<float>>&);
template double coupling(const VelocityProblem<double>&, const ConstraintRow<double>&,
                         const ConstraintRow<double>&, const PerBody<Vec3<double>>&);
template long double coupling(const VelocityProblem<long double>&, const ConstraintRow<long double>&,
                              const ConstraintRow<long double>&, const PerBody<Vec3<long double>>&);
template void BodyRows::build(const VelocityProblem<float>&, const PerBody<Vec3<float>>&);
template void BodyRows::build(const VelocityProblem<double>&, const PerBody<Vec3<double>>&);
template void BodyRows::build(const VelocityProblem<long double>&, const PerBody<Vec3<long double>>&);

}  // namespace cairn
