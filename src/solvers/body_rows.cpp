// Floor 4. Lists of rows by body, by counting.
#include "solvers/body_rows.hpp"

#include <algorithm>
#include <iterator>

namespace cairn {

namespace {

template <Scalar Real>
bool acts_on(BodyId body, const Vec3<Real>& jacobian, const std::vector<Vec3<Real>>& weight) {
  return (weight[static_cast<std::size_t>(body.index)].array() * jacobian.array() != Real(0)).any();
}

template <Scalar Real>
Real side_coupling(BodyId body, const Vec3<Real>& jacobian, const ConstraintRow<Real>& other,
                   const std::vector<Vec3<Real>>& weight) {
  const Vec3<Real> weighted = weight[static_cast<std::size_t>(body.index)].cwiseProduct(jacobian);
  Real sum = 0;
  if (other.a == body) sum += weighted.dot(other.jacobian_a);
  if (other.b == body) sum += weighted.dot(other.jacobian_b);
  return sum;
}

}  // namespace

template <Scalar Real>
Real coupling(const ConstraintRow<Real>& first, const ConstraintRow<Real>& second,
              const std::vector<Vec3<Real>>& weight) {
  return side_coupling(first.a, first.jacobian_a, second, weight) +
         side_coupling(first.b, first.jacobian_b, second, weight);
}

template <Scalar Real>
void BodyRows::build(const std::vector<ConstraintRow<Real>>& rows, const std::vector<Vec3<Real>>& weight) {
  bodies_.assign(rows.size(), {});
  first_.assign(weight.size() + 1, 0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ConstraintRow<Real>& row = rows[i];
    if (acts_on(row.a, row.jacobian_a, weight)) bodies_[i].a = row.a.index;
    if (acts_on(row.b, row.jacobian_b, weight) && bodies_[i].a != row.b.index) bodies_[i].b = row.b.index;
    for (const int body : {bodies_[i].a, bodies_[i].b}) {
      if (body >= 0) first_[static_cast<std::size_t>(body) + 1] += 1;
    }
  }
  for (std::size_t body = 1; body < first_.size(); ++body) first_[body] += first_[body - 1];

  // Filled from the last row to the first, each list from its end: first_[body + 1] walks down to where the
  // list begins, and that is where first_[body] has to be.
  rows_.resize(first_.back());
  for (std::size_t i = rows.size(); i-- > 0;) {
    for (const int body : {bodies_[i].a, bodies_[i].b}) {
      if (body >= 0) rows_[--first_[static_cast<std::size_t>(body) + 1]] = static_cast<int>(i);
    }
  }
  std::shift_left(first_.begin(), first_.end(), 1);
  first_.back() = rows_.size();
}

void BodyRows::append_neighbours(int i, std::vector<int>& neighbours) const {
  const Pair& bodies = bodies_[static_cast<std::size_t>(i)];
  const std::span<const int> on_a = rows_of(bodies.a);
  const std::span<const int> on_b = rows_of(bodies.b);
  std::set_union(on_a.begin(), on_a.end(), on_b.begin(), on_b.end(), std::back_inserter(neighbours));
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
  return bodies_.size() * sizeof(Pair) + first_.size() * sizeof(std::size_t) + rows_.size() * sizeof(int);
}

std::span<const int> BodyRows::rows_of(int body) const {
  if (body < 0) return {};
  const auto index = static_cast<std::size_t>(body);
  return std::span<const int>(rows_).subspan(first_[index], first_[index + 1] - first_[index]);
}

template float coupling(const ConstraintRow<float>&, const ConstraintRow<float>&,
                        const std::vector<Vec3<float>>&);
template double coupling(const ConstraintRow<double>&, const ConstraintRow<double>&,
                         const std::vector<Vec3<double>>&);
template long double coupling(const ConstraintRow<long double>&, const ConstraintRow<long double>&,
                              const std::vector<Vec3<long double>>&);
template void BodyRows::build(const std::vector<ConstraintRow<float>>&, const std::vector<Vec3<float>>&);
template void BodyRows::build(const std::vector<ConstraintRow<double>>&, const std::vector<Vec3<double>>&);
template void BodyRows::build(const std::vector<ConstraintRow<long double>>&,
                              const std::vector<Vec3<long double>>&);

}  // namespace cairn
