// How far a scene is from what it should be, by one measure for every engine.
#pragma once

#include "engine.hpp"
#include "peer_scenes.hpp"
#include <cairn/world/snapshot.hpp>

namespace cairn::bench {

/// What is wrong with the bodies where they are.
struct Errors {
  bool exploded = false;  // a body is nowhere, or kilometres off: the others are not measured
  double overlap = 0;     // [m] the deepest of two shapes
  double gap = 0;         // [m] the widest of a joint
  double sinking = 0;     // [m] of the body that began highest
  double aside = 0;       // [m] the longest way to the left or right of a body that should stand
  int outside = 0;        // bodies that went through a wall
};

/// Measures the bodies of one scene.
class Ruler {
 public:
  /// `scene` is made by `entry`.
  Ruler(const PeerScene& entry, const Scene& scene);
  Errors errors(const Engine& engine);

 private:
  PeerScene entry_;
  Scene scene_;
  Snapshot start_;
  Snapshot now_;  // whose poses are the engine's
  BodyId top_ = {};
};

}  // namespace cairn::bench
