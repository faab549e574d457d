// Floor 5. What a step tells: a report of how it went, and a record of what it saw.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "collision/manifold.hpp"
#include "constraints/contact_problem.hpp"
#include "constraints/row.hpp"
#include "math/list.hpp"
#include "solvers/solver.hpp"
#include "world/sleeping.hpp"

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
/// order; then that of a hand that drags a body, if there is one; then one for each manifold. Of what sleeps
/// there are no manifolds, and joints with an empty block.
template <Scalar Real>
struct StepRecord {
  List<Manifold<Real>> manifolds = {};          // ordered by collider_a, collider_b; where the step began
  VelocityProblem<Real> problem = {};           // after the solve
  int first_contact_block = 0;                  // the block of the first manifold
  PerRow<char> is_new = {};                     // it had no impulse to start from
  List<std::pair<BodyId, BodyId>> sensed = {};  // what touches a sensor, the lower id first, sorted
  /// The problem has all rows; else its solver took contacts as they are, those that could do without rows:
  /// with_rows().
  bool has_rows = true;
  List<Contact<Real>> contacts = {};         // of each manifold, then
  PerBody<Pose<Real>> pose_before = {};      // where the substep began,
  PerBody<Vec3<Real>> velocity_before = {};  // how fast bodies were,
  PerBody<Vec3<Real>> free_velocity = {};    // and v_1

  /// How many rows joints and the hand have: the first ones.
  int joint_rows() const {
    if (first_contact_block == 0) return 0;
    const RowBlock& last = problem.blocks[first_contact_block - 1];
    return last.first + last.count;
  }
  /// [N s] What the rows of a block gave, in their order.
  Span<const Real> impulses(const RowBlock& block) const {
    return {problem.impulse.as_vector().data() + block.first, block.count};
  }
  /// [N s] What the rows of one of the contacts gave, or would have given.
  Span<const Real> impulses(const Contact<Real>& contact) const {
    if (contact.block) return impulses(problem.blocks[*contact.block]);
    return {contact.impulse.data(), contact.count};
  }
};

}  // namespace cairn
