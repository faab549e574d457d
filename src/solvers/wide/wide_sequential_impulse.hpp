// Floor 4. Sequential impulses, many rows at a time.
#pragma once

#include <cairn/solvers/solver.hpp>
#include <cairn/solvers/stopping.hpp>
#include <cairn/solvers/wide/lane_system.hpp>

namespace cairn {

/// Whether impulses go on the way that they went.
enum class Momentum {
  none,
  nesterov,  // as in AcceleratedProjectedGaussSeidel
};

/// SequentialImpulse for speed: Algorithm 1 in an order of its own, up to 16 blocks of rows at a time. Blocks
/// of one colour share no body that can move, so their order means nothing, and each takes a lane of the
/// processor's widest registers (lane_batches.hpp says which blocks do not). The order of the rows inside a
/// block is as written; RowOrder is not looked at.
///
/// Lanes compute in single precision, and hold nothing but changes
/// since the warm start (lane_system.hpp). Where what is left to change is small beside what has changed,
/// impulses go back into the problem, velocities are computed from them in its own precision, and lanes begin
/// again: as iterative refinement does (J. H. Wilkinson, Rounding Errors in Algebraic Processes, 1963). So
/// any R_E that the problem's precision allows is reached. Where one sweep is all that is asked for, changes
/// have nothing to be kept for: it is made in the problem's own precision, to the bits of SequentialImpulse
/// in this order.
///
/// With Momentum::nesterov it is AcceleratedProjectedGaussSeidel in that order: y, the energy f and the rule
/// by which a sweep is undone are explained there; f is added up in the precision of lanes.
/// SolveReport::largest_change is that of the last sweep from y.
///
/// Guarantees: impulses inside their bounds; velocities are those that the impulses make, to a rounding of
/// the problem's own; the same bits for every instruction set. A tolerance is judged by
/// R_E, computed where the steps of a sweep are near those for which R_E was last seen to be too large
/// (Stopping).
///
/// Cost: 12 multiply-adds a row and sweep, 24 with momentum, 16 rows at a time; filling lanes with
/// rows and emptying them takes as long as two or three sweeps of SequentialImpulse, so one or two sweeps
/// gain nothing; with contacts that have no rows, about as long as one, and a single sweep
/// over them, 16 at a time in the problem's precision, a third of that. Memory linear in m. Colours are kept
/// from solve to solve while bodies and kinds of rows are the same. Observers: after_row comes when all rows
/// of a batch have been updated. Sources: E. Catto, Box2D v3 (2024), for colours and lanes in SI.
template <Scalar Real = double>
class WideSequentialImpulse final : public Solver<Real> {
 public:
  /// With the widest registers of this processor, or those of another set that it has.
  /// @throws std::invalid_argument for settings out of range.
  explicit WideSequentialImpulse(const SolverSettings& settings = {}, Momentum momentum = Momentum::none,
                                 LaneSet set = widest_lane_set());

  std::string name() const override { return momentum_ == Momentum::none ? "wide SI" : "wide accelerated"; }
  /// @throws std::invalid_argument unless the problem's blocks follow each other and cover all rows.
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer = nullptr) override;
  /// Where there is no patience: standstills and their like are judged by rows.
  bool takes_contacts() const override { return settings_.patience == 0; }
  /// Rows in lanes, m impulses, and of every body its velocity, its inverse mass and their like.
  std::size_t memory() const override { return lanes_.bytes(); }
  /// How many sweeps with momentum the last solve undid.
  int restarts() const { return restarts_; }

 private:
  LaneSteps<Real> iterate(int number, VelocityProblem<Real>& problem, SolveObserver<Real>* watcher);
  void accept_or_undo(VelocityProblem<Real>& problem, const LaneSteps<Real>& gathered,
                      const LaneSteps<Real>& swept);

  SolverSettings settings_;
  Momentum momentum_ = Momentum::none;
  LaneSystem<Real> lanes_;
  Stopping<Real> stopping_;
  Real path_ = 0;  // [N s] what changes since the lanes were filled add up to, at most
  int k_ = 1;      // of the next sweep, counted from the last restart
  int restarts_ = 0;
};

}  // namespace cairn
