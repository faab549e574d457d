// Floor 5. What a step tells: a report of how it went, and a record of what it saw.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include <cairn/constraints/row.hpp>
#include <cairn/math/list.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/world/sleeping.hpp>

namespace cairn {

/// What happened in one step. A blow-up is reported here, not thrown: nothing is clamped in silence. The
/// substep in which a body would get a position or a velocity that is no finite number is not done, nor are
/// the further ones of its step: all bodies stay as they were, and only the time goes on.
struct StepReport {
  SolveReport solve = {};                 // of the velocities; of the last substep
  int unfinished = 0;                     // SolveReport::unfinished() solves, of all substeps and passes
  double worst_residual = 0;              // the largest R_E of those that looked at it
  int sweeps = 0;                         // all that were done, for relaxing and for positions too
  std::int64_t rows_solved = 0;           // in all substeps, each once; those of positions too
  std::int64_t row_sweeps = 0;            // rows times sweeps of every solve
  std::int64_t extra_row_sweeps = 0;      // rows times SolveReport::extra_sweeps of every solve
  int contacts = 0;                       // contact points
  int rows = 0;                           // scalar constraints
  AwakeCount awake = {};                  // when the step ended; islands are counted where bodies may sleep
  std::optional<BodyId> not_finite = {};  // the first body that would have a NaN or an infinity, if any
  /// Joints whose points were, when the last substep began, farther apart than the circle around the smaller
  /// body reaches.
  int joints_apart = 0;
  /// Pairs of shapes that were found in each other by more than half of the thinner body.
  int too_deep = 0;

  /// Counts a solve of the step, of so many rows.
  void count(const SolveReport& solved, int row_count) {
    count_left(solved, row_count);
    unfinished += solved.unfinished();
    worst_residual = std::max(worst_residual, solved.residual.value_or(0));
  }
  /// Counts the work of a solve whose answer is left for another one.
  void count_left(const SolveReport& solved, int row_count) {
    sweeps += solved.iterations;
    row_sweeps += std::int64_t{solved.iterations} * row_count;
    extra_row_sweeps += std::int64_t{solved.extra_sweeps} * row_count;
  }
};

/// What the last step saw and found. The first blocks of the problem are those of the joints, in the scene's
/// order; then that of a hand that drags a body, if there is one; then one for each contact, which are
/// ordered by collider_a, collider_b. Of what sleeps there are no contacts, and joints with an empty block.
template <Scalar Real>
struct StepRecord {
  /// After the solve. Its contacts are those of where the step began; they may be without rows (with_rows()).
  VelocityProblem<Real> problem = {};
  PerRow<char> is_new = {};                      // it had no impulse to start from
  List<std::pair<BodyId, BodyId>> sensed = {};   // what touches a sensor, the lower id first, sorted
  List<std::pair<BodyId, BodyId>> passing = {};  // of which one passes the other, which is one-way: likewise
};

}  // namespace cairn
