// Copies of the sweep of sequential impulses from which features were taken out: what would be compiled if a
// feature did not exist.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "solvers/solver.hpp"

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
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
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
    return row.jacobian_a.dot(problem.velocity[static_cast<std::size_t>(row.a.index)]) +
           row.jacobian_b.dot(problem.velocity[static_cast<std::size_t>(row.b.index)]);
  }

  static void apply(VelocityProblem<double>& problem, const ConstraintRow<double>& row, double p) {
    if constexpr (has(left_out::extra_bodies)) return apply_impulse(problem, row, p);
    const auto a = static_cast<std::size_t>(row.a.index);
    const auto b = static_cast<std::size_t>(row.b.index);
    problem.velocity[a] += problem.inverse_mass[a].cwiseProduct(row.jacobian_a) * p;
    problem.velocity[b] += problem.inverse_mass[b].cwiseProduct(row.jacobian_b) * p;
  }

  static double clamp(const Bounds<double>& bounds, double x, const std::vector<double>& impulse) {
    if constexpr (has(left_out::second_normal)) return bounds.clamp(x, impulse);
    if (!bounds.is_friction()) return std::max(std::min(x, bounds.upper), bounds.lower);
    const double load = std::max(impulse[static_cast<std::size_t>(bounds.normal_row)], 0.0);
    const double limit = bounds.friction * load;
    return std::max(std::min(x, limit), -limit);
  }

  double sweep(VelocityProblem<double>& problem) {
    const double omega = settings_.relaxation;
    double largest_change = 0;
    for (std::size_t turn = 0; turn < problem.rows.size(); ++turn) {
      std::size_t i = turn;
      if constexpr (has(left_out::order)) i = static_cast<std::size_t>(order_[turn]);
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
  std::vector<double> effective_mass_;
  std::vector<int> order_;
};

}  // namespace cairn::bench
