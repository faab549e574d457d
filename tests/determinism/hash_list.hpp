// Fingerprints of runs: two builds that print the same ones compute the same bits.
#pragma once

#include <string>

#include <cairn/study/frozen/frozen_problem.hpp>
#include <cairn/math/list.hpp>

namespace cairn::determinism {

/// How many runs there are.
int run_count();
/// "SCENE SOLVER SCALAR HASH" of one of them: all snapshots of its steps.
std::string run_line(int run);
/// "frozen NAME SOLVER HASH" of each problem and solver: velocities and impulses after a solve.
List<std::string> frozen_lines(const List<FrozenProblem>& problems);
/// What comes back once the problem is written and read.
FrozenProblem written_and_read(const FrozenProblem& frozen);
/// All lines: the runs', those of the frozen set, made anew.
List<std::string> all_lines();

}  // namespace cairn::determinism
