// Floor 7. Scenes that closed forms, studies, tests and benchmarks share: bodies in lines, on each other, and
// on chains.
//
// A header without a source file: who takes a scene from here links the core alone.
#pragma once

#include <optional>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>
#include <cairn/world/scene.hpp>

namespace cairn::samples {

/// A box of 1 m that stands on the ground at x [m].
inline BodySpec standing_box(double x = 0) { return {.shapes = {box(1, 1)}, .position = {x, 0.5}}; }

/// So many bodies like the first, each `step` [m] from the one before.
inline List<BodyId> add_line(Scene& scene, int count, BodySpec first, const Vec2<double>& step) {
  const Vec2<double> from = first.position;
  List<BodyId> bodies;
  for (int i = 0; i < count; ++i) {
    first.position = from + i * step;
    bodies.push_back(scene.add(first));
  }
  return bodies;
}

/// Boxes of 1 m on each other, the lowest first.
inline List<BodyId> add_stack(Scene& scene, int boxes, const BodySpec& lowest = standing_box()) {
  return add_line(scene, boxes, lowest, {0, 1});
}

/// The same on a ground of its own; friction is that of the boxes.
inline Scene stack(int boxes, const SceneSettings& settings = {}, const BodySpec& lowest = standing_box()) {
  Scene scene(settings);
  scene.add_ground({.material = {.friction = lowest.material.friction}});
  add_stack(scene, boxes, lowest);
  return scene;
}

/// Boxes of 1 m on each other, every second one `aside` [m] to the right of the lowest.
inline List<BodyId> add_staggered_stack(Scene& scene, int boxes, double aside) {
  List<BodyId> bodies;
  for (int i = 0; i < boxes; ++i) {
    bodies.push_back(
        scene.add({.shapes = {box(1, 1)}, .position = {i % 2 == 0 ? 0 : aside, 0.5 + i}, .mass = 1}));
  }
  return bodies;
}

/// Where a pyramid stands, and what it is made of.
struct Pyramid {
  int base = 10;                  // boxes in its lowest row; one fewer in each row above
  double pitch = 1;               // [m] from a box to the next in its row
  Vec2<double> foot = {0, 0};     // [m] the middle of its lowest row
  BodySpec box = standing_box();  // of 1 m; only its place is another
};

/// The lowest row first, each from left to right.
inline void add_pyramid(Scene& scene, Pyramid pyramid) {
  for (int level = 0; level < pyramid.base; ++level) {
    for (int i = 0; i < pyramid.base - level; ++i) {
      const double x = pyramid.pitch * (i + 0.5 * (level - pyramid.base + 1));
      pyramid.box.position = pyramid.foot + Vec2<double>(x, 0.5 + level);
      scene.add(pyramid.box);
    }
  }
}

/// On a ground of its own.
inline Scene pyramid(const Pyramid& pyramid, const SceneSettings& settings = {}) {
  Scene scene(settings);
  scene.add_ground({.material = {.friction = pyramid.box.material.friction}});
  add_pyramid(scene, pyramid);
  return scene;
}

/// Links like the first, each `step` [m] from the one before and joined to it half-way; the first one is
/// joined to `joint.a`, whose other members say of which kind all joints are.
template <typename Joint = RevoluteJoint>
List<BodyId> add_chain(Scene& scene, int links, const BodySpec& first, const Vec2<double>& step,
                       typename Joint::Spec joint = {}) {
  const List<BodyId> bodies = add_line(scene, links, first, step);
  for (int i = 0; i < links; ++i) {
    joint.b = bodies[i];
    joint.anchor = first.position + (i - 0.5) * step;
    scene.join<Joint>(joint);
    joint.a = bodies[i];
  }
  return bodies;
}

/// A spring, and a rope, which may be of rubber; the length [m] is that at rest.
inline DistanceJoint::Spec spring(double length, const Softness& softness) {
  return {.length = length, .kind = DistanceJoint::Kind::spring, .softness = softness};
}
inline DistanceJoint::Spec rope(double length, const std::optional<Softness>& softness = {}) {
  return {.length = length, .kind = DistanceJoint::Kind::rope, .softness = softness};
}

/// Hangs the middle of a body from a point [m] of `joint.a`, which is the ground where nothing else is said,
/// by a rod, or by what `joint` says.
inline JointId hang(Scene& scene, BodyId body, const Vec2<double>& from, DistanceJoint::Spec joint = {}) {
  joint.b = body;
  joint.anchor_a = from;
  joint.anchor_b = scene.bodies()[body].pose.position;
  return scene.join<DistanceJoint>(joint);
}

}  // namespace cairn::samples
