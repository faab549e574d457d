// Floor 4. Rows that bodies connect.
#include <cairn/solvers/islands.hpp>

#include <algorithm>

#include <cairn/constraints/converted.hpp>

namespace cairn {

namespace {

template <Scalar Real>
bool can_move(const VelocityProblem<Real>& problem, BodyId body) {
  return !problem.inverse_mass[body].isZero(0);
}

/// Whether row `i` is between the bodies of the row before it, as most rows are.
template <Scalar Real>
bool is_like_the_last(const VelocityProblem<Real>& problem, int i) {
  if (i == 0) return false;
  const ConstraintRow<Real>&last = problem.rows[i - 1], &row = problem.rows[i];
  return row.a == last.a && row.b == last.b && row.extra_count == 0 && last.extra_count == 0;
}

}  // namespace

/// That of its bodies that can be moved; below 0: there are none.
template <typename Problem>
BodyId Islands::lowest_of_row(const Problem& problem, int row) {
  BodyId found = {-1};
  for_each_term(problem, problem.rows[row], [&](BodyId body, const auto&) {
    if (found.index < 0 && can_move(problem, body)) found = connected_.lowest(body);
  });
  return found;
}

template <Scalar Real>
void Islands::find(const VelocityProblem<Real>& problem) {
  connected_.begin(problem.body_count());
  for (const int i : problem.rows.indices()) {
    if (is_like_the_last(problem, i)) continue;
    BodyId first = {-1};
    for_each_term(problem, problem.rows[i], [&](BodyId body, const auto&) {
      if (!can_move(problem, body)) return;
      if (first.index < 0) first = body;
      connected_.connect(first, body);
    });
  }
  sort_rows(problem);
  number_.assign(problem.body_count(), -1);
  are_one_ = count() == 1 && rows_.size() == problem.row_count();
  for (const BodyId body : number_.indices())
    are_one_ = are_one_ && (!can_move(problem, body) || connected_.lowest(body) == lowest_[0]);
}

/// Island by island: they are counted first, then put in place.
template <typename Problem>
void Islands::sort_rows(const Problem& problem) {
  next_.assign(problem.body_count(), 0);
  of_row_.clear();
  for (int i = 0; i < problem.row_count(); ++i) {
    of_row_.push_back(is_like_the_last(problem, i) ? of_row_.back() : lowest_of_row(problem, i));
    if (of_row_.back().index >= 0) ++next_[of_row_.back()];
  }
  lowest_.clear();
  first_.clear();
  int rows = 0;
  for (const BodyId body : next_.indices()) {
    const int count = next_[body];
    next_[body] = rows;
    if (count == 0) continue;
    lowest_.push_back(body);
    first_.push_back(rows);
    rows += count;
  }
  rows_.resize(rows);
  for (int i = 0; i < problem.row_count(); ++i) {
    if (of_row_[i].index >= 0) rows_[next_[of_row_[i]]++] = i;
  }
}

template <Scalar Real>
void Islands::copy(int island, const VelocityProblem<Real>& whole, IslandProblem<Real>& result) {
  const int end = island + 1 < count() ? first_[island + 1] : rows_.size();
  result.rows.assign(rows_.begin() + first_[island], rows_.begin() + end);
  result.bodies.clear();
  VelocityProblem<double>& problem = result.problem;
  problem.rows.clear();
  problem.extra_terms.clear();
  problem.inverse_mass.clear();
  const auto number_of = [&](BodyId body) {
    if (number_[body] < 0) {
      number_[body] = result.bodies.size();
      result.bodies.push_back(body);
      problem.inverse_mass.push_back(whole.inverse_mass[body].template cast<double>());
    }
    return BodyId{number_[body]};
  };
  const auto place_of_row = [&](int row) {
    if (row == Bounds<double>::none) return row;
    return static_cast<int>(std::lower_bound(result.rows.begin(), result.rows.end(), row) -
                            result.rows.begin());
  };
  for (const int i : result.rows) {
    ConstraintRow<double> row = converted<double>(whole.rows[i]);
    row.a = number_of(row.a);
    row.b = number_of(row.b);
    row.first_extra = problem.extra_terms.size();
    for_each_extra_term(whole, whole.rows[i], [&](BodyId body, const Vec3<Real>& jacobian) {
      problem.extra_terms.push_back({number_of(body), jacobian.template cast<double>()});
    });
    row.bounds.normal_row = place_of_row(row.bounds.normal_row);
    row.bounds.second_normal_row = place_of_row(row.bounds.second_normal_row);
    problem.rows.push_back(row);
  }
  for (const BodyId body : result.bodies) number_[body] = -1;
  problem.impulse.resize(result.rows.size());
  problem.velocity.resize(result.bodies.size());
  problem.dt = static_cast<double>(whole.dt);
  problem.number.renew();
  result.take_again(whole);
}

template <Scalar Real>
void IslandProblem<Real>::take_again(const VelocityProblem<Real>& whole) {
  for (int i = 0; i < rows.size(); ++i) {
    problem.rows[i].bias = static_cast<double>(whole.rows[rows[i]].bias);
    problem.rows[i].softness = static_cast<double>(whole.rows[rows[i]].softness);
    problem.impulse[i] = static_cast<double>(whole.impulse[rows[i]]);
  }
  for (int i = 0; i < bodies.size(); ++i)
    problem.velocity[BodyId{i}] = whole.velocity[bodies[i]].template cast<double>();
}

template <Scalar Real>
void IslandProblem<Real>::give(VelocityProblem<Real>& whole) const {
  for (int i = 0; i < rows.size(); ++i) whole.impulse[rows[i]] = static_cast<Real>(problem.impulse[i]);
  for (int i = 0; i < bodies.size(); ++i) {
    const BodyId body = bodies[i];
    if (can_move(whole, body)) whole.velocity[body] = problem.velocity[BodyId{i}].template cast<Real>();
  }
}

template <Scalar Real>
std::size_t IslandProblem<Real>::memory() const {
  return rows.bytes() + bodies.bytes() + problem.rows.bytes() + problem.extra_terms.bytes() +
         problem.inverse_mass.bytes() + problem.velocity.bytes() + problem.impulse.bytes();
}

template struct IslandProblem<float>;
template struct IslandProblem<double>;
template void Islands::find(const VelocityProblem<float>&);
template void Islands::find(const VelocityProblem<double>&);
template void Islands::copy(int, const VelocityProblem<float>&, IslandProblem<float>&);
template void Islands::copy(int, const VelocityProblem<double>&, IslandProblem<double>&);

}  // namespace cairn
