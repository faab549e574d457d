// Floor 4. Proximal steps, each by a damped semismooth Newton's method on sparse factors.
#include <cairn/solvers/exact/newton.hpp>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>

#include <cairn/math/deadline.hpp>
#include <cairn/solvers/iterative/accelerated_projected_gauss_seidel.hpp>
#include <cairn/solvers/exact/contact_modes.hpp>
#include <cairn/solvers/exact/exact_rows.hpp>
#include <cairn/solvers/exact/newton_steps.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

// Softness, of rows with ones on the diagonal.
constexpr long double first_softness = 1e-2L;
constexpr long double largest_softness = 10;
constexpr long double least_softness = 1e-12L;  // factors in double still make steps that repair themselves
constexpr long double least_factor = 2.5L;      // from one softness to the next
constexpr long double largest_factor = 10;
constexpr int steps_of_newton = 30;  // for one problem: most take less than ten
constexpr int idle_steps = 100;  // proximal ones that do not lower the least R_E: rows contradict each other
constexpr int failures_in_a_row = 20;  // before a restart
// Beside the error of the rows that are not soft: what is left of F comes back as their error.
constexpr long double share_of_error = 1e-2L;
// R_E near what roundings allow: one failure more, and it is left at that.
constexpr long double rounding_residual = 1e-13L;

class NewtonIteration {
 public:
  NewtonIteration(VelocityProblem<long double>& problem, const NewtonSettings& settings)
      : problem_(problem), settings_(settings), scale_(exact_scale(problem)), best_(problem.impulse) {
    rows_.begin(problem);
  }

  NewtonResult run() {
    restart_at(problem_.impulse);
    int sweeps = settings_.sweeps;
    for (result_.restarts = 0;; ++result_.restarts) {
      if (sweeps > 0) restart_at(swept(sweeps));
      approach();
      const bool is_done = result_.residual <= std::max<long double>(settings_.tolerance, rounding_residual);
      if (is_done || result_.restarts == settings_.restarts || is_used_up()) break;
      sweeps *= 4;
    }
    set_impulses(problem_, best_);
    result_.converged = result_.residual <= settings_.tolerance;
    return result_;
  }

 private:
  bool is_used_up() const { return result_.iterations >= settings_.iterations; }

  /// The best impulses so far after some sweeps.
  PerRow<long double> swept(int sweeps) const {
    VelocityProblem<long double> copy = problem_;
    copy.impulse = best_;
    AcceleratedProjectedGaussSeidel<long double>({.iterations = sweeps}).solve(copy);
    return copy.impulse;
  }

  void restart_at(const PerRow<long double>& impulse) {
    center_.go_to(rows_, impulse);
    note_center(impulse);
  }

  /// Keeps the centre's impulses if none have been better.
  void note_center(const PerRow<long double>& impulse) {
    const long double error = center_.error();
    residual_ = error == 0 ? 0 : error / scale_;
    if (!has_best_ || residual_ < result_.residual) {
      result_.residual = residual_;
      best_ = impulse;
      has_best_ = true;
    }
  }

  /// Proximal steps from the centre, until R_E is small or nothing helps.
  void approach() {
    long double softness = first_softness, factor = largest_factor;
    int failures = 0, idle = 0;
    while (residual_ > settings_.tolerance && !is_used_up() && idle < idle_steps) {
      const long double least = result_.residual;
      map_.soften(softness);
      if (solve_softened()) {
        center_.go_to(rows_, map_.x(), map_.response());
        PerRow<long double> impulses;
        rows_.copy_impulses(map_.x(), impulses);
        note_center(impulses);
        softness = std::max(softness / factor, least_softness);
        factor = std::min(factor * 1.5L, largest_factor);
        failures = 0;
        idle = result_.residual < least * (1 - 1e-6L) ? 0 : idle + 1;
        continue;
      }
      softness = std::min(softness * factor, largest_softness);
      factor = std::max(std::sqrt(factor), least_factor);
      if (++failures == failures_in_a_row || result_.residual <= rounding_residual) break;
    }
  }

  /// Seeks du with F(du) = 0 around the centre; the last evaluation is the answer.
  bool solve_softened() {
    return steps_.solve(at_, share_of_error * residual_ * scale_, steps_of_newton, [this] {
      if (is_used_up() || !factorize()) return false;
      ++result_.iterations;
      const Vector<double> value = map_.value().cast<double>();
      const Vector<double> solved = factors_.solve(value);
      const Vector<long double> change = solved.cast<long double>();
      return change.allFinite() && steps_.shorten(at_, change, 1.0L / 2048);
    });
  }

  bool factorize() {
    Deadline::go_on();
    entries_.clear();
    const int freedoms = static_cast<int>(rows_.freedoms());
    for (int k = 0; k < freedoms; ++k) entries_.emplace_back(k, k, 1);
    map_.for_each_slope(rows_, [this](const auto& left, const auto& right, long double factor) {
      for (const auto& l : left) {
        for (int row = 0; row < 3; ++row) {
          for (const auto& r : right) {
            for (int column = 0; column < 3; ++column) {
              if (l.value(row) == 0 || r.value(column) == 0) continue;
              entries_.emplace_back(3 * l.body + row, 3 * r.body + column,
                                    static_cast<double>(factor * l.value(row) * r.value(column)));
            }
          }
        }
      }
    });
    Eigen::SparseMatrix<double> matrix(freedoms, freedoms);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    factors_.compute(matrix);
    return factors_.info() == Eigen::Success;
  }

  VelocityProblem<long double>& problem_;
  NewtonSettings settings_;
  long double scale_ = 0;
  ScaledRows<long double> rows_;
  ProximalCenter<long double> center_;
  ProximalMap<long double> map_;
  NewtonSteps<long double> steps_;
  const NewtonSteps<long double>::Place at_{rows_, center_, map_};
  long double residual_ = 0;  // R_E at the centre
  PerRow<long double> best_;
  bool has_best_ = false;
  NewtonResult result_;
  List<Eigen::Triplet<double>> entries_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> factors_;
};

}  // namespace

NewtonResult newton(VelocityProblem<long double>& problem, const NewtonSettings& settings) {
  if (problem.rows.empty()) return {.converged = true};
  return NewtonIteration(problem, settings).run();
}

}  // namespace cairn
