// Floor 5. How a scene stands, before anything moves: for drawing and measuring, no world has to be made.
#pragma once

#include <cairn/dynamics/body.hpp>
#include <cairn/world/scene.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// Poses, velocities and inverse masses of its bodies, as a world of it begins.
template <Scalar Real>
BodyState<Real> state_of(const Scene& scene);

/// The same as of a world that was just made from it.
Snapshot snapshot(const Scene& scene);

/// A body of a scene as it is now: `pose` is that of its centre of mass, `velocity` in [m/s, m/s, rad/s].
SnapshotBody snapshot_body(const SceneBody& body, const Pose<double>& pose, const Vec3<double>& velocity);

/// Adds the forces from outside that act on the bodies of the snapshot at its time, and the scene's paths.
void add_actions(const Scene& scene, Snapshot& snapshot);

/// A joint between bodies as they are now, without its impulse.
template <Scalar Real>
SnapshotJoint snapshot_joint(const Constraint& joint, const BodyState<Real>& state);

/// Adds what has broken and what was counted of a scene whose bodies are so.
template <Scalar Real>
void add_occurrences(const Scene& scene, const BodyState<Real>& state, Snapshot& snapshot);

}  // namespace cairn
