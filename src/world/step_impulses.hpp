// Floor 5. What contacts and joints give in a whole step, for whoever asks.
#pragma once

#include <cairn/math/list.hpp>
#include <cairn/world/snapshot.hpp>
#include <cairn/world/step_report.hpp>

namespace cairn {

/// The contact points that the last substep of a step saw, and what they gave in it.
template <Scalar Real>
List<SnapshotContact> contacts_of(const StepRecord<Real>& record);
/// What a joint gave to its last body in it [N s]; of a hand, too, which is behind those of the scene.
template <Scalar Real>
Vec2<double> joint_impulse(const StepRecord<Real>& record, int joint);

/// Adds up the impulses of a step's substeps: a snapshot has those of the last one alone.
///   StepImpulses impulses;
///   world.step(solver, impulses);
///   const Snapshot now = impulses.in(snapshot(world));
/// Costs about as much as a snapshot for each substep, and a world steps to the same bits with it.
class StepImpulses {
 public:
  /// Another step begins: none have been given yet.
  void clear();
  /// Those of a substep.
  template <Scalar Real>
  void add(const StepRecord<Real>& substep);
  /// The same of a step of a snapshot, as other engines give it.
  void add(const Snapshot& substep);

  /// The snapshot of the end of the step with the impulses of the whole step, and `dt` [s] that of the step:
  /// impulse over dt is the mean force. A contact that was gone before the end is among them, where it was
  /// last. Where no substep was done, the snapshot as it is.
  /// @throws std::invalid_argument for one of another step: with fewer joints than were added.
  Snapshot in(Snapshot end) const;

 private:
  void add(List<SnapshotContact> contacts, const List<Vec2<double>>& joints, double dt);

  List<SnapshotContact> contacts_;  // by bodies, and then as they came
  List<Vec2<double>> joints_;       // [N s] on the last body of each, in the order of the scene
  double dt_ = 0;                   // [s] of all substeps
};

}  // namespace cairn
