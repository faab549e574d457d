// Floor 4. Contacts in lanes, of which no rows were written.
#pragma once

#include <cairn/math/list.hpp>
#include <cairn/constraints/row.hpp>
#include <cairn/solvers/wide/lane_batches.hpp>
#include <cairn/solvers/wide/lane_sets.hpp>

namespace cairn {

/// The contacts without rows in the problem's own precision, from which lanes are filled. A run is of batches
/// of such contacts, one behind the other.
template <Scalar Real>
class LaneContacts {
 public:
  /// Makes room for these batches; each body has its root of the inverse mass in `root`.
  void arrange(const LaneBatches& batches, const VelocityProblem<Real>& problem,
               const PerBody<Vec3<Real>>& root);
  /// Takes over contacts and impulses; of a problem whose number it has seen only what the second solve is.
  void take(const LaneCode<Real>& code, const LaneBatches& batches, const VelocityProblem<Real>& problem);
  /// Whether it has taken over this problem before, as far as numbers of problems tell.
  bool knows(const VelocityProblem<Real>& problem) const {
    return problem.number.value() != 0 && problem.number.value() == taken_;
  }
  /// The warm start of a run.
  void push(const LaneCode<Real>& code, Span<const LaneBatch> run, PerBody<Vec3<Real>>& velocity);
  /// Fills the rows of all batches, from `velocity` on.
  void fill(const LaneCode<Real>& code, const LaneBatches& batches, Real relaxation,
            const PerBody<Vec3<Real>>& velocity, List<LaneRow>& rows, List<LaneCoupling>& couplings);
  /// Takes over what sweeps have changed since in a run, and gives it to the bodies.
  void empty(const LaneCode<Real>& code, Span<const LaneBatch> run, const List<LaneRow>& rows,
             PerBody<Vec3<Real>>& velocity);
  /// One sweep over a run in the problem's own precision; returns the largest step of an impulse [N s].
  Real sweep_once(const LaneCode<Real>& code, Span<const LaneBatch> run, Real relaxation,
                  PerBody<Vec3<Real>>& velocity);
  /// Adds what a run has in one of the two sums of R_E [J], at these velocities, in each lane.
  void add_energy(const LaneCode<Real>& code, Span<const LaneBatch> run, LaneEnergy kind,
                  const PerBody<Vec3<Real>>& velocity, Real* squares);
  /// Gives the problem the impulses of the contacts.
  void give(const LaneBatches& batches, VelocityProblem<Real>& problem) const;
  /// What it takes up [bytes].
  std::size_t bytes() const { return contacts_.bytes() + roots_.bytes() + bodies_.bytes(); }

 private:
  void gather(const LaneBatch& batch, const VelocityProblem<Real>& problem);
  void gather_manifold(const Manifold<Real>& manifold, int lane);
  void take_velocities(const PerBody<Vec3<Real>>& velocity);
  void give_velocities(PerBody<Vec3<Real>>& velocity) const;

  List<LaneContactBatch<Real>> contacts_;  // a batch each
  List<LaneRoots> roots_;                  // of each batch
  PerBody<LaneBody<Real>> bodies_;         // as fast as they are, and one that nothing moves
  std::uint64_t taken_ = 0;                // the number of the problem that they are of
  LaneContactInput<Real> input_ = {};      // scratch, of one batch
};

}  // namespace cairn
