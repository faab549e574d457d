// Bullet as a peer, in the plane: bodies move along x and y and turn about z, and boxes meet as rectangles.
#include <BulletCollision/CollisionDispatch/btBox2dBox2dCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btBox2dShape.h>
#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <variant>

#include "engine.hpp"
#include <cairn/math/check.hpp>

namespace cairn::bench {

namespace {

btVector3 to_bullet(const Vec2<double>& v) {
  return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), 0};
}

btTransform to_bullet(const Vec2<double>& position, double angle) {
  return btTransform(btQuaternion(btVector3(0, 0, 1), static_cast<btScalar>(angle)), to_bullet(position));
}

/// A shape in the frame of its body.
struct PlacedShape {
  std::unique_ptr<btCollisionShape> shape = {};
  btTransform place = btTransform::getIdentity();
};

struct MakeBulletShape {
  PlacedShape operator()(const Circle<double>& circle) const {
    return {std::make_unique<btSphereShape>(static_cast<btScalar>(circle.radius)),
            to_bullet(circle.center, 0)};
  }
  PlacedShape operator()(const Polygon<double>& polygon) const {
    const Vec2<double> along = polygon.vertices[1] - polygon.vertices[0];
    const Vec2<double> up = polygon.vertices[2] - polygon.vertices[1];
    const bool is_box =
        polygon.vertices.size() == 4 && std::abs(along.dot(up)) < 1e-9 * along.norm() * up.norm();
    require(is_box, "Bullet", "shape", "a circle or a rectangle, as it has no others in the plane",
            "another");
    const auto half = [](const Vec2<double>& side) { return static_cast<btScalar>(side.norm() / 2); };
    return {std::make_unique<btBox2dShape>(btVector3(half(along), half(up), half(up))),
            to_bullet((polygon.vertices[0] + polygon.vertices[2]) / 2, std::atan2(along.y(), along.x()))};
  }
  template <typename Other>
  PlacedShape operator()(const Other& other) const {
    require(false, "Bullet", "shape", "a circle or a rectangle, as it has no others in the plane",
            shape_name(other));
    return {};
  }
};

/// A kinematic body: Bullet leaves it to its user to move it.
struct Driven {
  btRigidBody* body;
  btVector3 velocity;  // [m/s]
  btVector3 spin;      // [rad/s]
};

class BulletEngine final : public Engine {
 public:
  BulletEngine(const Scene& scene, const PeerSettings& settings)
      : dt_(static_cast<btScalar>(scene.settings().dt)) {
    const int plane = BOX_2D_SHAPE_PROXYTYPE;
    dispatcher_.registerCollisionCreateFunc(plane, plane, &boxes_in_the_plane_);
    world_.setGravity(to_bullet(scene.settings().gravity));
    world_.getSolverInfo().m_numIterations = settings.iterations;
    for (const SceneBody& body : scene.bodies()) add(body);
    for (const Pin& joint : pins_of(scene)) pin(joint);
  }
  ~BulletEngine() override {
    for (const auto& joint : joints_) world_.removeConstraint(joint.get());
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
  }
  BulletEngine(const BulletEngine&) = delete;
  BulletEngine& operator=(const BulletEngine&) = delete;

  void step() override {
    for (const Driven& one : driven_) {
      btTransform next;
      btTransformUtil::integrateTransform(one.body->getWorldTransform(), one.velocity, one.spin, dt_, next);
      one.body->setWorldTransform(next);
    }
    world_.stepSimulation(dt_, 0);
  }
  PerBody<Pose<double>> poses() const override {
    PerBody<Pose<double>> result;
    for (const auto& body : bodies_) {
      const btTransform& place = body->getWorldTransform();
      const btQuaternion turn = place.getRotation();
      result.push_back(
          {.position = {place.getOrigin().x(), place.getOrigin().y()},
           .angle = 2 * std::atan2(static_cast<double>(turn.z()), static_cast<double>(turn.w()))});
    }
    return result;
  }
  PerBody<Vec3<double>> velocities() const override {
    PerBody<Vec3<double>> result;
    for (const auto& body : bodies_) {
      const btVector3& velocity = body->getLinearVelocity();
      result.push_back({velocity.x(), velocity.y(), body->getAngularVelocity().z()});
    }
    return result;
  }

 private:
  /// One shape about the centre of mass as it is; others as parts.
  btCollisionShape* shape_of(const BodySpec& spec) {
    const auto parts = std::make_shared<btCompoundShape>();
    shapes_.push_back(parts);
    bool about_center = spec.shapes.size() == 1;
    for (const Shape<double>& shape : spec.shapes) {
      PlacedShape placed = std::visit(MakeBulletShape(), shape);
      parts->addChildShape(placed.place, placed.shape.get());
      about_center = about_center && placed.place == btTransform::getIdentity();
      shapes_.push_back(std::move(placed.shape));
    }
    return about_center ? shapes_.back().get() : parts.get();
  }
  void add(const SceneBody& body) {
    const BodySpec& spec = body.spec;
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(body.mass), nullptr, shape_of(spec),
                                                  {0, 0, static_cast<btScalar>(body.inertia)});
    info.m_startWorldTransform = to_bullet(body.pose.position, body.pose.angle);
    // It multiplies those of two bodies.
    info.m_friction = static_cast<btScalar>(std::sqrt(spec.material.friction));
    info.m_restitution = static_cast<btScalar>(std::sqrt(spec.material.restitution));
    bodies_.push_back(std::make_unique<btRigidBody>(info));
    btRigidBody& made = *bodies_.back();
    made.setLinearFactor({1, 1, 0});
    made.setAngularFactor({0, 0, 1});
    made.setActivationState(DISABLE_DEACTIVATION);
    const btVector3 velocity = to_bullet(spec.velocity);
    const btVector3 spin(0, 0, static_cast<btScalar>(spec.angular_velocity));
    if (spec.type == BodyType::dynamic) {
      made.setLinearVelocity(velocity);
      made.setAngularVelocity(spin);
    } else if (spec.type == BodyType::kinematic) {
      made.setCollisionFlags(btCollisionObject::CF_KINEMATIC_OBJECT);
      driven_.push_back({&made, velocity, spin});
    }
    // A body without shapes is here for its joints alone.
    const int mask = spec.shapes.empty() ? 0 : static_cast<int>(spec.filter.collides_with);
    world_.addRigidBody(&made, static_cast<int>(spec.filter.category), mask);
  }
  void pin(const Pin& pin) {
    btRigidBody &a = *bodies_[pin.a], &b = *bodies_[pin.b];
    const btVector3 at_a = to_bullet(pin.anchor_a), at_b = to_bullet(pin.anchor_b), axis(0, 0, 1);
    if (pin.motor || pin.lower) {
      auto hinge = std::make_unique<btHingeConstraint>(a, b, at_a, at_b, axis, axis);
      // Its angle is that of a, seen from b, and 0 where both have the same; its impulse is that of a step.
      if (pin.motor) {
        hinge->enableAngularMotor(true, static_cast<btScalar>(-pin.motor->speed),
                                  static_cast<btScalar>(pin.motor->max_force) * dt_);
      }
      if (pin.lower) {
        hinge->setLimit(static_cast<btScalar>(-pin.start - *pin.upper),
                        static_cast<btScalar>(-pin.start - *pin.lower));
      }
      joints_.push_back(std::move(hinge));
    } else {
      joints_.push_back(std::make_unique<btPoint2PointConstraint>(a, b, at_a, at_b));
    }
    world_.addConstraint(joints_.back().get(), !pin.touch);
  }

  btScalar dt_;  // [s]
  btBox2dBox2dCollisionAlgorithm::CreateFunc boxes_in_the_plane_ = {};
  btDefaultCollisionConfiguration configuration_ = {};
  btCollisionDispatcher dispatcher_ = btCollisionDispatcher(&configuration_);
  btDbvtBroadphase broadphase_ = {};
  btSequentialImpulseConstraintSolver solver_ = {};
  btDiscreteDynamicsWorld world_ = {&dispatcher_, &broadphase_, &solver_, &configuration_};
  List<std::shared_ptr<btCollisionShape>> shapes_ = {};
  PerBody<std::unique_ptr<btRigidBody>> bodies_ = {};
  List<Driven> driven_ = {};
  List<std::unique_ptr<btTypedConstraint>> joints_ = {};
};

}  // namespace

std::unique_ptr<Engine> make_bullet(const Scene& scene, const PeerSettings& settings) {
  return std::make_unique<BulletEngine>(scene, settings);
}

std::string bullet_version() { return fmt::format("{}.{}", btGetVersion() / 100, btGetVersion() % 100); }

}  // namespace cairn::bench
