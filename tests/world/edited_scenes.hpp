// What tests of editing share: a chain of balls, refusals, and the bits of a body.
#pragma once

#include <bit>

#include "testing.hpp"

namespace cairn::testing {

inline void append_point(const Vec2<double>& point, List<double>& numbers) {
  numbers.push_back(point.x());
  numbers.push_back(point.y());
}

inline void append_shape(const Shape<double>& shape, List<double>& numbers) {
  if (const auto* disc = std::get_if<Circle<double>>(&shape)) {
    append_point(disc->center, numbers);
    numbers.push_back(disc->radius);
  } else if (const auto* outline = std::get_if<Polygon<double>>(&shape)) {
    for (const Vec2<double>& vertex : outline->vertices) append_point(vertex, numbers);
    for (const Vec2<double>& normal : outline->normals) append_point(normal, numbers);
    numbers.push_back(outline->radius);
  } else if (const auto* line = std::get_if<Segment<double>>(&shape)) {
    append_point(line->point1, numbers);
    append_point(line->point2, numbers);
  }
}

/// Every number of a body that editing could change.
inline List<std::uint64_t> bits_of(const SceneBody& body) {
  const BodySpec& spec = body.spec;
  List<double> numbers = {body.pose.angle, body.mass, body.inertia, spec.angle, spec.angular_velocity};
  for (const Vec2<double>& point : {body.pose.position, spec.position, spec.velocity})
    append_point(point, numbers);
  for (const Shape<double>& shape : spec.shapes) append_shape(shape, numbers);
  List<std::uint64_t> bits;
  for (const double number : numbers) bits.push_back(std::bit_cast<std::uint64_t>(number));
  return bits;
}

/// A chain of three balls from the ground; balls 1 and 2 are held by two joints.
struct HangingChain {
  Scene scene;
  List<JointId> joints;

  HangingChain() {
    for (int i = 1; i <= 3; ++i) scene.add({.shapes = {circle(0.5)}, .position = {1.0 * i, 0}});
    for (const int a : {0, 1, 1, 2}) {
      joints.push_back(scene.join<DistanceJoint>(
          {.a = {a}, .b = {a + 1}, .anchor_a = {1.0 * a, 0}, .anchor_b = {a + 1.0, 0}}));
    }
  }
};

inline List<JointId> ids_of(const Scene& scene) {
  List<JointId> ids;
  for (int i = 0; i < scene.joints().size(); ++i) ids.push_back(scene.joints().id(i));
  return ids;
}

}  // namespace cairn::testing
