// Floor 4. Modes of rows, each a system of linear equations.
#include <cairn/solvers/exact/contact_modes.hpp>

#include <algorithm>
#include <cmath>

#include <cairn/constraints/converted.hpp>
#include <cairn/math/deadline.hpp>
#include <cairn/solvers/exact/dictionary.hpp>
#include <cairn/solvers/exact/impulse_family.hpp>
#include <cairn/solvers/residual.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

constexpr long double mode_rounding = 1e-13L;  // of signs and equations, beside the largest number
constexpr long double mode_pivot = 1e-13L;
constexpr long double same_velocity = 1e-9L;  // beside rows.size

enum class RowMode { lower, upper, free, zero, stick, forward, backward };

/// slope x + constant >= 0.
struct Inequality {
  Vector<long double> slope;
  long double constant = 0;
};

class ModeWalk {
 public:
  ModeWalk(const ExactRows& rows, int max_modes)
      : rows_(rows), max_modes_(max_modes), mode_(rows.bounds.size(), RowMode::free) {
    for (const bool friction : {false, true}) {  // the mode of friction depends on that of its normal
      for (int i = 0; i < rows.bounds.size(); ++i) {
        if (rows.bounds[i].is_friction == friction) order_.push_back(i);
      }
    }
  }

  ModeList all() {
    count_only_ = true;
    walk(0);
    if (list_.modes > max_modes_) return {};
    count_only_ = false;
    list_ = {.complete = true};
    walk(0);
    return list_;
  }

 private:
  void walk(int depth) {
    if (list_.modes > max_modes_) return;
    if (depth == order_.size()) {
      ++list_.modes;
      if (!count_only_) try_mode();
      return;
    }
    const int row = order_[depth];
    for (const RowMode mode : modes_of(rows_.bounds[row])) {
      mode_[row] = mode;
      walk(depth + 1);
    }
  }

  bool is_open(int row) const {
    if (row == ExactBounds::none) return true;
    return mode_[row] == RowMode::lower && rows_.bounds[row].lower == 0;
  }

  List<RowMode> modes_of(const ExactBounds& bounds) const {
    if (bounds.is_friction) {
      const bool open = is_open(bounds.normal) && is_open(bounds.second);
      if (open || bounds.mu + bounds.second_mu == 0) return {RowMode::zero};
      return {RowMode::stick, RowMode::forward, RowMode::backward};
    }
    if (!(bounds.lower < bounds.upper)) return {RowMode::zero};
    List<RowMode> modes;
    if (std::isfinite(bounds.lower)) modes.push_back(RowMode::lower);
    modes.push_back(RowMode::free);
    if (std::isfinite(bounds.upper)) modes.push_back(RowMode::upper);
    return modes;
  }

  /// side * x_i at most its limit by friction; an equation where friction is exhausted.
  Inequality room(Eigen::Index i, long double side) const {
    const ExactBounds& bounds = rows_.bounds[i];
    Inequality room = {Vector<long double>::Zero(rows_.s.size()), 0};
    room.slope(i) = -side;
    if (bounds.normal != ExactBounds::none) room.slope(bounds.normal) += bounds.mu;
    if (bounds.second != ExactBounds::none) room.slope(bounds.second) += bounds.second_mu;
    return room;
  }
  Inequality error(Eigen::Index i, long double side) const {
    return {side * rows_.S.row(i).transpose(), side * rows_.s(i)};
  }
  /// side * (x_i - value)
  Inequality beyond(Eigen::Index i, long double side, long double value) const {
    Inequality beyond = {Vector<long double>::Zero(rows_.s.size()), -side * value};
    beyond.slope(i) = side;
    return beyond;
  }

  Inequality equation(Eigen::Index i) const {
    const ExactBounds& bounds = rows_.bounds[i];
    switch (mode_[i]) {
      case RowMode::lower:
        return beyond(i, 1, bounds.lower);
      case RowMode::upper:
        return beyond(i, 1, bounds.upper);
      case RowMode::zero:
        return beyond(i, 1, bounds.is_friction ? 0 : bounds.lower);
      case RowMode::forward:
        return room(i, 1);
      case RowMode::backward:
        return room(i, -1);
      case RowMode::free:
      case RowMode::stick:
        break;
    }
    return error(i, 1);
  }

  void add_inequalities(Eigen::Index i, List<Inequality>& inequalities) const {
    const ExactBounds& bounds = rows_.bounds[i];
    switch (mode_[i]) {
      case RowMode::lower:
      case RowMode::backward:
        inequalities.push_back(error(i, 1));
        break;
      case RowMode::upper:
      case RowMode::forward:
        inequalities.push_back(error(i, -1));
        break;
      case RowMode::free:
        if (std::isfinite(bounds.lower)) inequalities.push_back(beyond(i, 1, bounds.lower));
        if (std::isfinite(bounds.upper)) inequalities.push_back(beyond(i, -1, bounds.upper));
        break;
      case RowMode::stick:
        inequalities.push_back(room(i, 1));
        inequalities.push_back(room(i, -1));
        break;
      case RowMode::zero:
        break;
    }
  }

  void try_mode() {
    Deadline::go_on();
    const Eigen::Index n = rows_.s.size();
    Matrix<long double> K(n, n);
    Vector<long double> rhs(n);
    List<Inequality> inequalities;
    for (Eigen::Index i = 0; i < n; ++i) {
      const Inequality row = equation(i);
      K.row(i) = row.slope.transpose();
      rhs(i) = -row.constant;
      add_inequalities(i, inequalities);
    }
    const LinearSolutions solutions = solve_linear(K, rhs, mode_pivot);
    if (solutions.contradiction > mode_rounding * rows_.size) return;
    const Matrix<long double>& N = solutions.null_space;
    ModeSolution found = {.x = solutions.solution};
    if (N.cols() > 0) {
      FeasiblePoint point = nearest(inequalities, found.x, N, 0);
      if (!point.exists) point = nearest(inequalities, found.x, N, mode_rounding * rows_.size);
      if (!point.exists) return;
      found.x += N * point.y;
      found.in_family = (rows_.effect * N).cwiseAbs().maxCoeff() > mode_pivot;
    }
    long double largest = rows_.size;
    for (Eigen::Index i = 0; i < n; ++i) largest = std::max(largest, std::abs(found.x(i)));
    for (const Inequality& inequality : inequalities) {
      if (inequality.slope.dot(found.x) + inequality.constant < -2 * mode_rounding * largest) return;
    }
    add(found);
  }

  FeasiblePoint nearest(const List<Inequality>& inequalities, const Vector<long double>& x,
                        const Matrix<long double>& N, long double slack) const {
    const int count = inequalities.size();
    Matrix<long double> H(count, N.cols());
    Vector<long double> h(count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const Inequality& inequality = inequalities[k];
      H.row(k) = inequality.slope.transpose() * N;
      h(k) = -inequality.slope.dot(x) - inequality.constant - slack;
    }
    return feasible_point(H, h);
  }

  void add(const ModeSolution& found) {
    for (ModeSolution& known : list_.solutions) {
      const Vector<long double> change = rows_.effect * (found.x - known.x);
      if (change.norm() <= same_velocity * rows_.size) {
        known.in_family = known.in_family || found.in_family;
        return;
      }
    }
    list_.solutions.push_back(found);
  }

  const ExactRows& rows_;
  int max_modes_ = 0;
  List<RowMode> mode_;
  List<int> order_;
  bool count_only_ = true;
  ModeList list_;
};

}  // namespace

ModeList enumerate_modes(const ExactRows& rows, int max_modes) { return ModeWalk(rows, max_modes).all(); }

void set_impulses(VelocityProblem<long double>& problem, const PerRow<long double>& impulse) {
  problem.impulse = impulse;
  for (int i = 0; i < problem.row_count(); ++i) {
    apply_impulse(problem, problem.rows[i], impulse[i]);
  }
}

template <Scalar Real>
ContactSolutions<Real> all_contact_solutions(const VelocityProblem<Real>& problem, int max_modes) {
  VelocityProblem<long double> start = converted<long double>(problem);
  start.impulse.assign(start.rows.size(), 0);
  const ExactReduction reduction = reduce_to_exact_rows(start);
  const long double scale = exact_scale(start);
  const ModeList list = enumerate_modes(reduction.rows, max_modes);
  ContactSolutions<Real> result = {.complete = list.complete, .modes = list.modes};
  for (const ModeSolution& found : list.solutions) {
    VelocityProblem<long double> solved = start;
    set_impulses(solved, impulses_of(reduction, found.x));
    ContactSolution<Real> solution;
    for (const Vec3<long double>& v : solved.velocity) solution.velocity.push_back(v.cast<Real>());
    for (const long double p : solved.impulse) solution.impulse.push_back(static_cast<Real>(p));
    solution.unique_impulse = !reduction.redundant_equalities && has_unique_impulse(reduction.rows, found.x);
    solution.in_family = found.in_family;
    solution.residual = static_cast<Real>(residual(solved, scale).energy);
    result.solutions.push_back(solution);
  }
  return result;
}

template ContactSolutions<float> all_contact_solutions(const VelocityProblem<float>&, int);
template ContactSolutions<double> all_contact_solutions(const VelocityProblem<double>&, int);
template ContactSolutions<long double> all_contact_solutions(const VelocityProblem<long double>&, int);

}  // namespace cairn
