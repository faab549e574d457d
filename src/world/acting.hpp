// Floor 5. What acts on the bodies of a world besides gravity, damping and constraints; and what leads them.
#pragma once

#include <functional>

#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

/// The time of a substep.
struct SubstepTime {
  double begin = 0;       // [s] since the world began
  double length = 0;      // [s]
  bool is_first = false;  // of the world
};

/// The fields of a scene, its forces and its paths.
///
/// Where forces depend on places, as those of attractions and water do, velocities are those of half a
/// substep before the places: that is how semi-implicit Euler keeps to the second order (leapfrog; R. W.
/// Hockney, J. W. Eastwood, Computer Simulation Using Particles, 1981). So what a substep gives is that of
/// half of it before its beginning and half after, gravity's too, and the first substep of a world has half.
/// Air and water slow by implicit Euler, so that no step turns a velocity around.
template <Scalar Real>
class Acting {
 public:
  /// Those of this scene, which must outlive it.
  explicit Acting(const Scene& scene);
  /// Whether a scene has any.
  static bool is_needed(const Scene& scene);

  /// [s] Of `seconds` of a substep, for how long gravity acts.
  Real kick(SubstepTime now, Real seconds) const { return centred_ && now.is_first ? seconds / 2 : seconds; }
  /// Adds to the velocities of bodies what `seconds` [s] of them give.
  void add(const BodyState<Real>& state, SubstepTime now, double seconds,
           PerBody<Vec3<Real>>& velocity) const;
  /// Gives bodies on paths the velocities that take them where they should be at the end of the substep.
  void lead(SubstepTime now, BodyState<Real>& state) const;
  /// Calls `wake` for each body on which a force begins or ends in the substep.
  void find_changes(SubstepTime now, const std::function<void(BodyId)>& wake) const;

 private:
  void add_pulls(const BodyState<Real>& state, double seconds, PerBody<Vec3<Real>>& velocity) const;
  double share(const SceneEvent& event, SubstepTime now, double seconds) const;
  void add_forces(const BodyState<Real>& state, SubstepTime now, double seconds,
                  PerBody<Vec3<Real>>& velocity) const;
  void slow_in_air(const BodyState<Real>& state, double seconds, PerBody<Vec3<Real>>& velocity) const;
  void act_in_water(const BodyState<Real>& state, SubstepTime now, double seconds,
                    PerBody<Vec3<Real>>& velocity) const;

  const Scene& scene_;
  bool centred_;             // some forces depend on places
  List<BodyId> bodies_;      // the dynamic ones
  List<SceneEvent> forces_;  // those of ApplyForce
  List<SceneEvent> paths_;   // and of FollowPath
};

}  // namespace cairn
