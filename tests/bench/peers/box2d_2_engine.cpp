// Box2D 2.4.1 as a peer: the reference's shapes, in a world without listeners.
#include <box2d/box2d.h>

#include <cstdint>

#include "engine.hpp"
#include <cairn/reference/box2d_shapes.hpp>

namespace cairn::bench {

namespace {

class Box2D2Engine final : public Engine {
 public:
  Box2D2Engine(const Scene& scene, const PeerSettings& settings)
      : settings_(settings),
        dt_(static_cast<float>(scene.settings().dt)),
        world_(to_box2d(scene.settings().gravity)) {
    world_.SetAllowSleeping(false);
    world_.SetContinuousPhysics(false);
    for (const SceneBody& body : scene.bodies()) bodies_.push_back(add(body));
    for (const Pin& joint : pins_of(scene)) pin(joint);
  }
  void step() override { world_.Step(dt_, settings_.iterations, settings_.position_iterations); }
  PerBody<Pose<double>> poses() const override {
    PerBody<Pose<double>> result;
    for (const b2Body* body : bodies_) {
      const b2Vec2 center = body->GetWorldCenter();
      result.push_back({.position = {center.x, center.y}, .angle = static_cast<double>(body->GetAngle())});
    }
    return result;
  }
  PerBody<Vec3<double>> velocities() const override {
    PerBody<Vec3<double>> result;
    for (const b2Body* body : bodies_) {
      const b2Vec2 velocity = body->GetLinearVelocity();
      result.push_back({velocity.x, velocity.y, body->GetAngularVelocity()});
    }
    return result;
  }

 private:
  void pin(const Pin& pin) {
    b2RevoluteJointDef definition;
    definition.bodyA = bodies_[pin.a];
    definition.bodyB = bodies_[pin.b];
    definition.localAnchorA = to_box2d(pin.anchor_a);
    definition.localAnchorB = to_box2d(pin.anchor_b);
    definition.collideConnected = pin.touch;
    definition.referenceAngle = static_cast<float>(pin.start);
    definition.enableLimit = pin.lower.has_value();
    definition.lowerAngle = static_cast<float>(pin.lower.value_or(0));
    definition.upperAngle = static_cast<float>(pin.upper.value_or(0));
    if (pin.motor) {
      definition.enableMotor = true;
      definition.motorSpeed = static_cast<float>(pin.motor->speed);
      definition.maxMotorTorque = static_cast<float>(pin.motor->max_force);
    }
    world_.CreateJoint(&definition);
  }
  b2Body* add(const SceneBody& body) {
    const BodySpec& spec = body.spec;
    b2BodyDef definition;
    definition.type = spec.type == BodyType::dynamic     ? b2_dynamicBody
                      : spec.type == BodyType::kinematic ? b2_kinematicBody
                                                         : b2_staticBody;
    definition.position = to_box2d(body.pose.position);
    definition.angle = static_cast<float>(body.pose.angle);
    definition.linearVelocity = to_box2d(spec.velocity);
    definition.angularVelocity = static_cast<float>(spec.angular_velocity);
    b2Body* result = world_.CreateBody(&definition);
    for (const Shape<double>& shape : spec.shapes) {
      b2FixtureDef fixture;
      fixture.friction = static_cast<float>(spec.material.friction);
      fixture.restitution = static_cast<float>(spec.material.restitution);
      fixture.filter.categoryBits = static_cast<std::uint16_t>(spec.filter.category);
      fixture.filter.maskBits = static_cast<std::uint16_t>(spec.filter.collides_with);
      for (const std::unique_ptr<b2Shape>& part : to_box2d(shape)) {
        fixture.shape = part.get();
        result->CreateFixture(&fixture);
      }
    }
    if (spec.type == BodyType::dynamic) {
      b2MassData mass;
      mass.mass = static_cast<float>(body.mass);
      mass.center.SetZero();
      mass.I = static_cast<float>(body.inertia);
      result->SetMassData(&mass);
    }
    return result;
  }

  PeerSettings settings_;
  float dt_;  // [s]
  b2World world_;
  PerBody<b2Body*> bodies_ = {};  // owned by the world
};

}  // namespace

std::unique_ptr<Engine> make_box2d_2(const Scene& scene, const PeerSettings& settings) {
  return std::make_unique<Box2D2Engine>(scene, settings);
}

}  // namespace cairn::bench
