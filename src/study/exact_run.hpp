// Floor 9. Where the bodies of a scene come to when every step is small and solved to its end.
#pragma once

#include <cairn/math/list.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// A scene after a second of `newton` to its last digits in 3840 substeps, or at the end of a shorter run.
class ExactRun {
 public:
  /// Nothing is known.
  ExactRun() = default;
  /// Nothing is run where the scene has more freedoms than are solved at once by default, or where that does
  /// not end well.
  ExactRun(const Scene& scene, double seconds);

  bool is_known() const { return !places_.empty(); }
  /// [s] that it ran.
  double seconds() const { return seconds_; }
  /// [m] How far the farthest body of a run of the same scene is from where it should be, at that time.
  double gap(const Snapshot& now) const;

 private:
  double seconds_ = 1;
  PerBody<Vec2<double>> places_ = {};
};

}  // namespace cairn
