// Floor 9. What a sweep takes: the one price by which counted work of different solvers is compared.
#pragma once

#include <string>

#include <cairn/math/list.hpp>

namespace cairn {

/// What one iteration of a solver takes on this machine, in sweeps of sequential impulses over the same rows:
/// of `newton` a linear system. SolverEntry::work_of_a_sweep is the median of a machine where nothing else
/// ran.
struct SweepPrice {
  std::string solver = {};
  double least = 0;  // of all problems on which it was measured
  double median = 0;
  double most = 0;
};

/// Of each of these, measured on the frozen problems of at least 30 rows with 64 sweeps from nothing, all
/// that a solve takes among it. Seconds of the processor, together.
List<SweepPrice> measured_prices(const List<std::string>& solvers);

}  // namespace cairn
