// A scene with a bit of everything, for tests that change it while it runs.
#pragma once

#include <cairn/samples/samples.hpp>
#include "testing.hpp"

namespace cairn::testing {

/// A pile of boxes that lean on each other, a chain that swings, and a box that lies by itself.
struct Yard {
  Scene scene;
  List<BodyId> pile = {};
  BodyId lonely = {};
  JointId pin = {};

  explicit Yard(const SceneSettings& settings = {}) : scene(settings) {
    scene.add_ground();
    for (int i = 0; i < 6; ++i) {
      pile.push_back(scene.add({.shapes = {box(1, 0.8)}, .position = {0.1 * (i % 2), 0.4 + 0.8 * i}}));
    }
    samples::add_chain(scene, 4, {.shapes = {box(1, 0.2)}, .position = {5.5, 4}}, {1, 0});
    pin = scene.joints().id(3);
    lonely = scene.add({.shapes = {box(1, 1)}, .position = {-20, 0.5}});
  }
};

}  // namespace cairn::testing
