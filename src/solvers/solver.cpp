// Floor 4. Refuses settings and problems that no solver can work with.
#include <cairn/solvers/solver.hpp>

#include <cmath>

#include <cairn/math/check.hpp>

namespace cairn {

void check(const SolverSettings& settings, const std::string& solver) {
  require(settings.iterations >= 0, solver, "iterations", ">= 0", settings.iterations);
  require(settings.tolerance >= 0 && std::isfinite(settings.tolerance), solver, "tolerance",
          "a finite number >= 0", settings.tolerance);
  require(settings.relaxation > 0 && settings.relaxation < 2, solver, "relaxation", "> 0 and < 2",
          settings.relaxation);
  require(settings.time_budget >= 0 && std::isfinite(settings.time_budget), solver, "time_budget",
          "a finite number >= 0 s", settings.time_budget);
  require(settings.patience >= 0, solver, "patience", ">= 0", settings.patience);
}

template <Scalar Real>
void check_blocks(const VelocityProblem<Real>& problem, std::string_view solver) {
  int next = 0;
  for (const RowBlock& block : problem.blocks) {
    require(block.first == next && block.count >= 0, solver, "block",
            "the rows after those of the block before it", block.first);
    next += block.count;
  }
  require(next == problem.row_count(), solver, "rows in blocks", "all of the problem's rows", next);
}

template void check_blocks(const VelocityProblem<float>&, std::string_view);
template void check_blocks(const VelocityProblem<double>&, std::string_view);

}  // namespace cairn
