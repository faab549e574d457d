// Floor 10. Performance profiles: how often a solver is how close to the best.
#pragma once

#include <cstddef>
#include <string>

#include "study/work_precision.hpp"
#include "math/list.hpp"

namespace cairn {

/// Of one solver over a set of problems: its work over the least work of any solver, problem by problem.
struct PerformanceProfile {
  std::string solver = {};
  List<double> ratios = {};  // >= 1, ascending, one for each problem; infinite where it failed

  /// rho(tau): the share of the problems that it solves with at most `tau` times the work of the best. What
  /// no solver solves counts as a problem too.
  double share(double tau) const;
};

/// E. D. Dolan, J. J. More, "Benchmarking optimization software with performance profiles" (2002), for the
/// error at `which` of those that work_to_errors() was asked for. A solver that has no entry for a problem
/// failed there. In the order in which the solvers first appear.
List<PerformanceProfile> performance_profiles(const List<WorkToError>& work, int which);

}  // namespace cairn
