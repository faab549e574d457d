// The problems that the benchmarks solve: what a world of boxes hands to its solver.
#pragma once

#include <cairn/cairn.hpp>

namespace cairn::bench {

/// Boxes of 1 m in rows of base, base - 1, ..., 1, neighbours 0.1 m apart, after a few steps. With friction
/// 4 base^2 rows, all of them of contacts.
VelocityProblem<double> pyramid_problem(int base);

/// The pyramid, and beside it hanging chains with a tenth as many rows: joints are the rare kind (paper 4.4).
VelocityProblem<double> pyramid_with_chains_problem(int base);

/// Boxes one on the other: 4 rows for each.
VelocityProblem<double> stack_problem(int boxes);

/// A chain of rods that hangs from the ground: 2 rows for each.
VelocityProblem<double> chain_problem(int links);

/// The same, with nothing to start from.
VelocityProblem<double> cold(VelocityProblem<double> problem);

/// Bytes of the problem itself.
std::size_t problem_memory(const VelocityProblem<double>& problem);

}  // namespace cairn::bench
