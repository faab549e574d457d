// How far a scene is from what it should be, by one measure for every engine.
#pragma once

#include "engine.hpp"
#include "world/snapshot.hpp"

namespace cairn::bench {

/// What is wrong with the bodies where they are.
struct Errors {
  bool exploded = false;  // a body is nowhere, or kilometres off: the others are not measured
  double error = 0;       // [m] the widest gap of a joint; without joints the deepest overlap of two shapes
  double sinking = 0;     // [m] of the body that began highest
  double aside = 0;       // [m] the longest way of a body to the left or right
};

/// Measures the bodies of one scene.
class Ruler {
 public:
  explicit Ruler(const Scene& scene);
  Errors errors(const Engine& engine);

 private:
  Scene scene_;
  Snapshot start_;
  Snapshot now_;  // whose poses are the engine's
  BodyId top_ = {};
};

}  // namespace cairn::bench
