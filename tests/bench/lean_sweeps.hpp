// Copies of the sweep of sequential impulses from which features were taken out: what would be compiled if a
// feature did not exist.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/solvers/solver.hpp>

namespace cairn::bench {

/// Bits: what a copy goes without.
namespace left_out {
inline constexpr unsigned nothing = 0;
inline constexpr unsigned extra_bodies = 1;    // rows on more than two bodies
inline constexpr unsigned softness = 2;        // gamma times the impulse
inline constexpr unsigned relaxation = 4;      // omega
inline constexpr unsigned order = 8;           // a list of rows that says whose turn it is
inline constexpr unsigned second_normal = 16;  // friction on the sum of two normal impulses
inline constexpr unsigned everything = 31;
}  // namespace left_out

/// SequentialImpulse without observers, rules for stopping and variants, and without what `without` says.
/// Gives the same bits for every problem that does not use what is left out.
template <unsigned without>
class LeanSweeps final : public Solver<double> {
 public:
  explicit LeanSweeps(const SolverSettings& settings) : settings_(settings) {}

  std::string name() const override { return "SI without " + std::to_string(without); }
  SolveReport solve(VelocityProblem<double>& problem, SolveObserver<double>* = nullptr) override {
    effective_mass_.resize(problem.rows.size());
    for (int i = 0; i < problem.row_count(); ++i) {
      const double inverse = inverse_effective_mass(problem, problem.rows[i]);
      effective_mass_[i] = inverse > 0 ? 1 / inverse : 0;
      apply(problem, problem.rows[i], problem.impulse[i]);
    }
    if constexpr (has(left_out::order)) {
      order_.resize(problem.rows.size());
      std::iota(order_.begin(), order_.end(), 0);
    }
    SolveReport report;
    while (report.iterations < settings_.iterations) {
      ++report.iterations;
      report.largest_change = sweep(problem);
    }
    return report;
  }

 private:
  static constexpr bool has(unsigned feature) { return (without & feature) == 0; }

  static double velocity_of(const VelocityProblem<double>& problem, const ConstraintRow<double>& row) {
    if constexpr (has(left_out::extra_bodies)) return row_velocity(problem, row);
    return row.jacobian_a.dot(problem.velocity[row.a]) + row.jacobian_b.dot(problem.velocity[row.b]);
  }

  static void apply(VelocityProblem<double>& problem, const ConstraintRow<double>& row, double p) {
    if constexpr (has(left_out::extra_bodies)) return apply_impulse(problem, row, p);
    const BodyId a = row.a;
    const BodyId b = row.b;
    problem.velocity[a] += problem.inverse_mass[a].cwiseProduct(row.jacobian_a) * p;
    problem.velocity[b] += problem.inverse_mass[b].cwiseProduct(row.jacobian_b) * p;
  }

  static double clamp(const Bounds<double>& bounds, double x, const PerRow<double>& impulse) {
    if constexpr (has(left_out::second_normal)) return bounds.clamp(x, impulse);
    if (!bounds.is_friction()) return std::max(std::min(x, bounds.upper), bounds.lower);
    const double load = std::max(impulse[bounds.normal_row], 0.0);
    const double limit = bounds.friction * load;
    return std::max(std::min(x, limit), -limit);
  }

  double sweep(VelocityProblem<double>& problem) {
    const double omega = settings_.relaxation;
    double largest_change = 0;
    for (int turn = 0; turn < problem.row_count(); ++turn) {
      int i = turn;
      if constexpr (has(left_out::order)) i = order_[turn];
      const ConstraintRow<double>& row = problem.rows[i];
      double& accumulated = problem.impulse[i];
      double error = row.bias - velocity_of(problem, row);
      if constexpr (has(left_out::softness)) error -= row.softness * accumulated;
      double corrective = error * effective_mass_[i];
      if constexpr (has(left_out::relaxation)) corrective *= omega;
      const double old = accumulated;
      accumulated = clamp(row.bounds, old + corrective, problem.impulse);
      apply(problem, row, accumulated - old);
      largest_change = std::max(largest_change, std::abs(accumulated - old));
    }
    return largest_change;
  }

  SolverSettings settings_;
  PerRow<double> effective_mass_;
  List<int> order_;
};

}  // namespace cairn::bench
