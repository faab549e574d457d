// A stack of boxes as one row per interface, solved and recorded row by row.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cairn.hpp"

namespace cairn::stack {

struct StackSettings {
  int boxes = 3;
  double dt = 0.02;     // [s]
  double gravity = 10;  // [m/s^2]
  int sweeps = 10;
  std::string order = "up";  // in which rows are visited: up, down or shuffle
  std::uint64_t seed = 1;    // of the shuffle
};

/// What happened: every row update, and the answers to compare with.
struct StackRun {
  StackSettings settings = {};
  std::vector<int> interface_of_row = {};  // interface i is below box i + 1; interface 0 is the ground's
  VelocityProblem<double> problem = {};    // as it was before the solve
  std::vector<RowRecord> updates = {};     // sweeps * boxes
  std::vector<SweepRecord> sweeps = {};    // sweeps + 1; 0: nothing given yet
  std::vector<double> exact = {};          // [N] for each interface: the weight above it
  Snapshot snapshot = {};                  // the stack at rest, for drawing
};

/// The problem written by hand: boxes of 1 kg that gravity has just made fall, one normal row per interface
/// with j = (0, -1, 0 | 0, 1, 0), and nothing else. Row k is the k-th in visiting order.
VelocityProblem<double> stack_problem(const StackSettings& settings,
                                      const std::vector<int>& interface_of_row);

StackRun run_stack(const StackSettings& settings);

/// lambda [N] of each interface after the given sweep.
std::vector<double> lambda_after(const StackRun& run, int sweep);

/// Gauss-Seidel on A lambda = b in plain loops: lambda [N] of each row after every sweep, [sweep][row].
std::vector<std::vector<double>> gauss_seidel(const VelocityProblem<double>& problem, int sweeps);

/// How much of the error one sweep leaves. The scaled matrix of a stack of n boxes has the eigenvalues of a
/// Chebyshev matrix, 1 - cos((2k - 1) pi / 2n), and Gauss-Seidel squares what Jacobi leaves: cos^2(pi / 2n).
double error_factor(int boxes);

/// The same, measured: the ratio of two successive errors, once the others have died out; 0 if no error is
/// left.
double measured_error_factor(const StackSettings& settings);

}  // namespace cairn::stack
