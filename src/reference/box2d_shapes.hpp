// Floor 7. Shapes and joints as Box2D takes them, and refusing what it does not have.
#pragma once

#include <box2d/b2_shape.h>

#include <memory>
#include <utility>

#include <cairn/constraints/constraint.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>

class b2Body;
class b2Joint;
class b2World;

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

/// Creates the joint between two bodies of the world. They do not collide if they are among those kept
/// `apart`.
/// @throws std::invalid_argument unless it is a revolute joint without limits and motor, or a rod of at least
/// 0.005 m.
b2Joint* create_joint(b2World& world, const Constraint& joint, const PerBody<b2Body*>& bodies,
                      const List<std::pair<BodyId, BodyId>>& apart);

}  // namespace cairn
