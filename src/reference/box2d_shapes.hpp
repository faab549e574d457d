// Floor 7. Shapes as Box2D takes them, and refusing what it does not have.
#pragma once

#include <box2d/b2_shape.h>

#include <memory>

#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// The same vector in single precision.
b2Vec2 to_box2d(const Vec2<double>& v);

/// The parts that a shape has in Box2D: of a capsule its two ends and a middle, of any other one.
inline constexpr int most_box2d_parts = 3;
/// [m] How far the middle of a capsule, with its skin, lies inside it: what lies on the ends does not meet
/// it.
inline constexpr double capsule_middle_depth = 0.01;

/// @throws std::invalid_argument for a rounded polygon, one of more than 8 vertices, and a capsule of a
/// radius of 0.02 m or less.
List<std::unique_ptr<b2Shape>> to_box2d(const Shape<double>& shape);

}  // namespace cairn
