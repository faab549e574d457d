// Lesson 03. A stack of boxes as one row per interface, solved and recorded row by row.
#pragma once

#include <cstdint>

#include "lessons/kit/kit.hpp"

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
  PerRow<int> interface_of_row = {};     // interface i is below box i + 1; interface 0 is the ground's
  VelocityProblem<double> problem = {};  // as it was before the solve
  List<RowRecord> updates = {};          // sweeps * boxes
  List<PerRow<double>> sweeps = {};      // [N s] for each row, after 0, 1, ... sweeps
  List<double> exact = {};               // [N] for each interface: the weight above it
  Snapshot snapshot = {};                // the stack at rest, for drawing
};

/// The stack after one step of falling, its rows written by hand, and nothing solved yet.
StackRun falling_stack(const StackSettings& settings);

/// How fast each box moves upwards [m/s]: now, and after the given sweep.
List<double> box_velocities(const PerBody<Vec3<double>>& velocity);
List<double> velocities_after(const StackRun& run, int sweep);

/// lambda [N] of each interface after the given sweep.
List<double> lambda_after(const StackRun& run, int sweep);

/// Gauss-Seidel on A lambda = b in plain loops: lambda [N] of each row after every sweep, [sweep][row].
List<PerRow<double>> gauss_seidel(const VelocityProblem<double>& problem, int sweeps);

/// What one sweep leaves of the error: rho = cos^2(pi / 2n), derived in README.md.
double error_factor(int boxes);

/// The same, measured: the ratio of two successive errors, once the others have died out; 0 if no error is
/// left.
double measured_error_factor(const StackSettings& settings);

// What is printed, checked and drawn.

void tell_scene(Lesson& lesson, const StackRun& run);
void tell_updates(Lesson& lesson, const StackRun& run);
void tell_sweeps(Lesson& lesson, const StackRun& run);
void check_claims(Lesson& lesson, const StackRun& run);
/// What one sweep from the ground up leaves of the uppermost box's speed.
void check_question(Lesson& lesson, const StackRun& run);
CsvTable table_of(const StackRun& run);

/// The question, a frame for every row update, the course of all sweeps, and the answer.
List<Shot> stack_shots(const StackRun& run);

}  // namespace cairn::stack
