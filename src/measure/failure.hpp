// Floor 6. What no scene should show, whatever else is expected of it.
#pragma once

#include <optional>
#include <string>

#include "math/list.hpp"
#include "measure/violation.hpp"
#include "world/scene.hpp"

namespace cairn {

/// Ways in which a simulation has failed, however its numbers look.
enum class FailureKind {
  went_through,   // a body is in another by more than a quarter of the thinner one: it is on its way through
  came_apart,     // the points that a joint holds together are farther apart than half of the shorter body
  fell_out,       // a body that had something unmovable under it is below all that cannot be moved
  gained_energy,  // kinetic and potential energy have risen by more than a quarter of their scale, from
                  // nowhere
};

/// One of them.
struct Failure {
  FailureKind kind = FailureKind::went_through;  // what happened
  double time = 0;                               // [s] when it was seen
  double distance = 0;                           // [m] of overlap, or of a gap
  double gain = 0;                               // of the scale of energies, by which they rose
  BodyId a = {};                                 // of two bodies the first; or the one that fell out
  BodyId b = {};                                 // the second
  std::string joint = {};                        // what came apart: Constraint::name()
};

/// "box is 0.3 m deep in ground after 1.2 s, more than a quarter of the thinner one". Bodies without a name
/// go by their number.
std::string failure_text(const Failure& failure, const PerBody<std::string>& names = {});

/// Whether something in the scene may give energy to the rest: a body that moves by itself, a motor, a
/// spring, or an event that switches a motor on.
bool is_driven(const Scene& scene);

/// Looks at the snapshots of a run, one after the other, and keeps the first failure of each kind. Of
/// overlaps it sees what is handed to it; gears and differentials hold no points and cannot come apart.
class FailureWatch {
 public:
  /// Of a run that begins so.
  explicit FailureWatch(const Snapshot& start);

  /// Where bodies have been removed from the scene: from now on it looks at what is left, as it stands now.
  void scene_changed(const Snapshot& now);
  /// Looks at the bodies as they are after `time` [s].
  void see(const Snapshot& now, double time);
  /// The same for overlaps.
  void see(const List<Overlap>& overlaps, double time);
  /// Looks at how far energy is above that of the start, as a share of its scale, in a scene that nothing
  /// drives.
  void see_gain(double gain, double time);
  /// In the order in which they happened.
  const List<Failure>& failures() const { return failures_; }

 private:
  void look_around(const Snapshot& now);
  bool knows(FailureKind kind) const;
  void see_joints(const Snapshot& now, double time);
  void see_falls(const Snapshot& now, double time);

  PerBody<double> thickness_;  // [m] the shorter side of the thinnest shape; infinite where there is none
  PerBody<double> length_;     // [m] the longer side of the longest shape; infinite likewise
  PerBody<char> has_floor_;    // something unmovable was under it
  int removed_ = 0;            // bodies that were
  std::optional<double> lowest_still_;  // [m] the height of the lowest point that cannot move
  List<Failure> failures_;
};

}  // namespace cairn
