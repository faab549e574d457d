// Floor 4. Newton's method, island by island.
#include <cairn/solvers/exact/newton_solver.hpp>

#include <algorithm>
#include <limits>

namespace cairn {

template <Scalar Real>
NewtonSolver<Real>::NewtonSolver(const SolverSettings& settings) : settings_(settings) {
  check(settings, "NewtonSolver");
}

template <Scalar Real>
SolveReport NewtonSolver<Real>::solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) {
  if (observer != nullptr) observer->before_solve(problem);
  const bool again = problem.number.value() != 0 && problem.number.value() == solved_;
  solved_ = 0;  // until it is done
  if (!again) split(problem);
  std::int64_t rows = 0, systems = 0, sweeps = 0;
  SolveReport report{.converged = true, .stop = Stop::tolerance, .residual = 0.0};
  for (Part& part : parts_) {
    if (again && !is_whole(part)) part.island.take_again(problem);
    const SolveReport solved = solve_part(part, problem);
    const std::int64_t count = is_whole(part) ? problem.row_count() : part.island.rows.size();
    rows += count;
    systems += count * solved.iterations;
    sweeps += count * solved.extra_sweeps;
    // What is no number is the worst.
    if (!(*solved.residual <= *report.residual) && *report.residual == *report.residual)
      report.residual = solved.residual;
    if (!solved.converged) {
      report.converged = false;
      report.stop = Stop::sweeps;
    }
  }
  solved_ = problem.number.value();
  if (rows > 0) {
    report.iterations = static_cast<int>((systems + rows - 1) / rows);
    report.extra_sweeps = static_cast<int>((sweeps + rows - 1) / rows);
  }
  if (observer != nullptr) observer->after_sweep(report.iterations, problem);
  return report;
}

template <Scalar Real>
SolveReport NewtonSolver<Real>::solve_part(Part& part, VelocityProblem<Real>& problem) {
  if constexpr (std::is_same_v<Real, double>)
    if (is_whole(part)) return part.solver->solve(problem);
  const SolveReport report = part.solver->solve(part.island.problem);
  part.island.give(problem);
  return report;
}

/// Islands of before keep their solvers. Whatever throws on the way, each part has one.
template <Scalar Real>
void NewtonSolver<Real>::split(const VelocityProblem<Real>& problem) {
  islands_.find(problem);
  parts_.swap(before_);
  parts_.clear();
  auto old = before_.begin();
  for (int i = 0; i < islands_.count(); ++i) {
    const BodyId lowest = islands_.lowest_body(i);
    while (old != before_.end() && old->lowest < lowest) ++old;
    if (old != before_.end() && old->lowest == lowest) {
      parts_.push_back(std::move(*old++));
    } else {
      constexpr double epsilon = std::numeric_limits<Real>::epsilon();
      parts_.push_back({lowest, {}, std::make_unique<IslandNewton>(settings_, epsilon)});
    }
    IslandProblem<Real>& island = parts_.back().island;
    if (std::is_same_v<Real, double> && islands_.are_one()) {
      island.rows.clear();
    } else {
      islands_.copy(i, problem, island);
    }
  }
  before_.clear();
}

template <Scalar Real>
std::size_t NewtonSolver<Real>::memory() const {
  std::size_t bytes = 0;
  for (const Part& part : parts_) bytes += part.solver->memory() + part.island.memory();
  return bytes;
}

template class NewtonSolver<float>;
template class NewtonSolver<double>;

}  // namespace cairn
