// Floor 6. What no scene should show, whatever else is expected of it.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include <cairn/measure/violation.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

/// Ways in which a simulation has failed, however its numbers look.
enum class FailureKind {
  went_through,  // a body is in another by more than a quarter of the thinner one, as thick as it is the way
                 // that they push each other: it is on its way through
  came_apart,    // the points that a joint holds together are farther apart than half of the shorter body
  stayed_off,   // a joint ends with an error of a twentieth of the shorter body or more, which had not halved
                // for a second
  began_below,  // a body that nothing holds begins below the top of the ground, with nothing to land on
  fell_out,     // a body that had something unmovable under it is below all that cannot be moved
  falls_for_ever,  // a body that nothing holds is a hundred of its lengths below all that it could have
                   // landed on, or below where the lowest began where there is no such thing
  gained_energy,   // kinetic and potential energy have risen by more than a quarter of their scale, from
                   // nowhere
};

/// One of them.
struct Failure {
  FailureKind kind = FailureKind::went_through;  // what happened
  double time = 0;                               // [s] when it was seen
  double since = 0;                              // [s] from when an error stayed, or a fall went on
  double distance = 0;                           // [m] of overlap, of a gap, or of a fall
  double gain = 0;                               // of the scale of energies, by which they rose
  BodyId a = {};                                 // of two bodies the first; or the one that fell
  BodyId b = {};                                 // the second
  std::string joint = {};                        // what came apart: Constraint::name()
};

/// "box is 0.3 m deep in ground after 1.2 s, more than a quarter of the thinner one". Bodies without a name
/// go by their number.
std::string failure_text(const Failure& failure, const PerBody<std::string>& names = {});

/// Whether something in the scene may give energy to the rest: a body that moves by itself, a surface that
/// runs, a motor, or an event that switches a motor on, a force, a path, wind or a flow. Springs give back
/// what they held, which counts as potential energy.
bool is_driven(const Scene& scene);

/// Looks at the snapshots of a run, one after the other, and keeps the first failure of each kind. Of
/// overlaps it sees what is handed to it; gears and differentials hold no points and cannot come apart.
class FailureWatch {
 public:
  /// Of a run that begins so. `ends_are_stated`: it is known where bodies should be at the end, and a fall
  /// may lead there: then nothing began below, and nothing falls for ever.
  explicit FailureWatch(const Snapshot& start, bool ends_are_stated = false);

  /// Where bodies or joints have been removed from the scene: from now on it looks at what is left, as it
  /// stands now.
  void scene_changed(const Snapshot& now);
  /// Looks at the bodies as they are after `time` [s].
  void see(const Snapshot& now, double time);
  /// The same for the overlaps of these bodies.
  void see(const List<Overlap>& overlaps, const Snapshot& now, double time);
  /// Looks at how far energy is above that of the start, as a share of its scale, in a scene that nothing
  /// drives.
  void see_gain(double gain, double time);
  /// Looks at the end of the run, which the last see() was of.
  void end(const Snapshot& now, double time);
  /// In the order in which they happened.
  const List<Failure>& failures() const { return failures_; }

 private:
  /// From when a joint has been off without a halving of its error, and by how much at most; 0: it is not.
  struct JointError {
    double since = 0;    // [s]
    double largest = 0;  // [m]
  };

  void look_around(const Snapshot& now);
  void note_floors(const Snapshot& now);
  bool knows(FailureKind kind) const;
  double shorter(const SnapshotJoint& joint) const;
  bool goes_deeper(const Overlap& overlap, const Snapshot& now) const;
  void see_begin(const Snapshot& start);
  void see_joints(const Snapshot& now, double time);
  void see_errors(const Snapshot& now, double time);
  void see_falls(const Snapshot& now, double time);

  PerBody<double> length_;        // [m] the longer side of the longest shape; infinite without shapes
  PerBody<Pose<double>> before_;  // when overlaps were last seen
  PerBody<char> has_floor_;       // something unmovable was under it
  PerBody<double>
      below_since_;          // [s] from when it has been below all that it could land on; infinite: it is not
  List<JointError> errors_;  // joint by joint
  bool ends_are_stated_ = false;
  int removed_ = 0;    // bodies that were
  double lowest_ = 0;  // [m] the height of the lowest point that cannot move, or else of all
  List<Failure> failures_;
};

}  // namespace cairn
