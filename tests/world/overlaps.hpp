// How deep bodies of one shape each are in each other, by their poses alone.
#pragma once

#include <cairn/collision/collide.hpp>
#include "testing.hpp"

namespace cairn::testing {

/// [m] Negative where they are apart.
inline double overlap(const Scene& scene, BodyId a, const Pose<double>& pose_a, BodyId b,
                      const Pose<double>& pose_b) {
  const Manifold<double> found = collide<double>(scene.bodies()[a].spec.shapes[0], pose_a,
                                                 scene.bodies()[b].spec.shapes[0], pose_b, 1e3);
  double deepest = -1e3;
  for (int i = 0; i < found.count; ++i) deepest = std::max(deepest, -found.points[i].separation);
  return deepest;
}

inline double overlap(const World<double>& world, BodyId a, BodyId b) {
  return overlap(world.scene(), a, pose_of(world, a), b, pose_of(world, b));
}

}  // namespace cairn::testing
