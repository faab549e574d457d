// Floor 4. Lists of rows by body, by counting.
#include "solvers/body_rows.hpp"

#include <algorithm>
#include <cstddef>

namespace cairn {

template <Scalar Real>
Real coupling(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& first,
              const ConstraintRow<Real>& second, const std::vector<Vec3<Real>>& weight) {
  Real sum = 0;
  for_each_term(problem, first, [&](BodyId body, const Vec3<Real>& jacobian) {
    const Vec3<Real> weighted = weight[static_cast<std::size_t>(body.index)].cwiseProduct(jacobian);
    Real of_body = 0;
    for_each_term(problem, second, [&](BodyId other, const Vec3<Real>& other_jacobian) {
      if (other == body) of_body += weighted.dot(other_jacobian);
    });
    sum += of_body;
  });
  return sum;
}

template <Scalar Real>
void BodyRows::build(const VelocityProblem<Real>& problem, const std::vector<Vec3<Real>>& weight) {
  first_body_.assign(1, 0);
  bodies_.clear();
  first_.assign(weight.size() + 1, 0);
  for (const ConstraintRow<Real>& row : problem.rows) {
    const auto begin = static_cast<std::ptrdiff_t>(bodies_.size());
    for_each_term(problem, row, [&](BodyId id, const Vec3<Real>& jacobian) {
      const auto body = static_cast<std::size_t>(id.index);
      const bool acts = (weight[body].array() * jacobian.array() != Real(0)).any();
      if (!acts || std::find(bodies_.begin() + begin, bodies_.end(), id.index) != bodies_.end()) return;
      bodies_.push_back(id.index);
      first_[body + 1] += 1;
    });
    first_body_.push_back(bodies_.size());
  }
  for (std::size_t body = 1; body < first_.size(); ++body) first_[body] += first_[body - 1];

  // Filled from the last row to the first, each list from its end: first_[body + 1] walks down to where the
  // list begins, and that is where first_[body] has to be.
  rows_.resize(first_.back());
  for (std::size_t i = problem.rows.size(); i-- > 0;) {
    for (std::size_t k = first_body_[i]; k < first_body_[i + 1]; ++k) {
      rows_[--first_[static_cast<std::size_t>(bodies_[k]) + 1]] = static_cast<int>(i);
    }
  }
  std::shift_left(first_.begin(), first_.end(), 1);
  first_.back() = rows_.size();
}

void BodyRows::append_neighbours(int i, std::vector<int>& neighbours) const {
  const auto old = static_cast<std::ptrdiff_t>(neighbours.size());
  for (std::size_t k = first_body_[static_cast<std::size_t>(i)];
       k < first_body_[static_cast<std::size_t>(i) + 1]; ++k) {
    const auto body = static_cast<std::size_t>(bodies_[k]);
    neighbours.insert(neighbours.end(), rows_.begin() + static_cast<std::ptrdiff_t>(first_[body]),
                      rows_.begin() + static_cast<std::ptrdiff_t>(first_[body + 1]));
  }
  std::sort(neighbours.begin() + old, neighbours.end());
  neighbours.erase(std::unique(neighbours.begin() + old, neighbours.end()), neighbours.end());
}

std::size_t BodyRows::pairs() const {
  std::size_t sum = 0;
  for (std::size_t body = 0; body + 1 < first_.size(); ++body) {
    const std::size_t count = first_[body + 1] - first_[body];
    sum += count * count;
  }
  return sum;
}

std::size_t BodyRows::memory() const {
  return (first_body_.size() + first_.size()) * sizeof(std::size_t) +
         (bodies_.size() + rows_.size()) * sizeof(int);
}

template float coupling(const VelocityProblem<float>&, const ConstraintRow<float>&,
                        const ConstraintRow<float>&, const std::vector<Vec3<float>>&);
template double coupling(const VelocityProblem<double>&, const ConstraintRow<double>&,
                         const ConstraintRow<double>&, const std::vector<Vec3<double>>&);
template long double coupling(const VelocityProblem<long double>&, const ConstraintRow<long double>&,
                              const ConstraintRow<long double>&, const std::vector<Vec3<long double>>&);
template void BodyRows::build(const VelocityProblem<float>&, const std::vector<Vec3<float>>&);
template void BodyRows::build(const VelocityProblem<double>&, const std::vector<Vec3<double>>&);
template void BodyRows::build(const VelocityProblem<long double>&, const std::vector<Vec3<long double>>&);

}  // namespace cairn
