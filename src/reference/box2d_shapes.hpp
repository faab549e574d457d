// Floor 7. Shapes and joints as Box2D takes them, and refusing what it does not have.
#pragma once

#include <box2d/b2_shape.h>

#include <memory>
#include <utility>

#include "constraints/constraint.hpp"
#include "geometry/shape.hpp"
#include "math/list.hpp"

class b2Body;
class b2Joint;
class b2World;

namespace cairn {

/// The same vector in single precision.
b2Vec2 to_box2d(const Vec2<double>& v);

/// @throws std::invalid_argument for a capsule, a rounded polygon, or more than 8 vertices.
std::unique_ptr<b2Shape> to_box2d(const Shape<double>& shape);

/// Creates the joint between two bodies of the world. They do not collide if they are among those kept
/// `apart`.
/// @throws std::invalid_argument unless it is a revolute joint without limits and motor, or a rod of at least
/// 0.005 m.
b2Joint* create_joint(b2World& world, const Constraint& joint, const PerBody<b2Body*>& bodies,
                      const List<std::pair<BodyId, BodyId>>& apart);

}  // namespace cairn
