// Floor 7. What acts on the bodies of a Box2D world besides gravity and damping, and leads them, as Cairn has
// it.
#pragma once

#include <cairn/world/scene.hpp>

class b2Body;

namespace cairn {

/// Gives Box2D's bodies, before a step, the velocities that forces, fields and paths of the scene make of
/// theirs. `steps`: how many were taken before.
void act_on(const PerBody<b2Body*>& bodies, const Scene& scene, int steps);

}  // namespace cairn
