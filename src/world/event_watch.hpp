// Floor 5. What comes about in a step and makes events: bodies that touch, and joints that hold too much.
#pragma once

#include <optional>
#include <utility>

#include <cairn/math/list.hpp>
#include <cairn/world/clock.hpp>
#include <cairn/world/step_report.hpp>
#include <cairn/world/substep.hpp>

namespace cairn {

/// Looks at the substeps of a world for which Plan::watches(), and knows who touched in the step before.
template <Scalar Real>
class EventWatch {
 public:
  /// Another step begins.
  void begin();
  /// A substep was solved, and is about to move its bodies.
  void see(const Substep<Real>& step, const StepRecord<Real>& record);
  /// The step of `dt` [s] is over, at `time` [s]: its scene with the events that it made, due before the next
  /// one; none where it made none.
  std::optional<Scene> end(double time, double dt, const Scene& scene);
  /// The same in another scene, of which some bodies are gone.
  EventWatch in(const Scene& scene) const;

 private:
  using Pairs = List<std::pair<BodyId, BodyId>>;

  void see_touches(const Substep<Real>& step, const StepRecord<Real>& record);
  void see_joints(const Substep<Real>& step, const StepRecord<Real>& record);
  List<int> events_met(const Scene& scene) const;
  List<SceneEvent> breaks(double time, double dt, const Scene& scene) const;

  Pairs before_;                 // what touched in the step before: the lower id first, sorted
  Pairs now_;                    // the same of this step, sorted once it is over
  List<Vec3<double>> impulses_;  // [N s, N s, N m s] of each joint in this step, on its last body
};

}  // namespace cairn
