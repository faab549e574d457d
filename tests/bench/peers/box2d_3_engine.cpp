// Box2D 3 as a peer. The only file that sees its headers: those of Box2D 2.4.1 have the same names.
#include <box2d/box2d.h>
#include <fmt/format.h>

#include <cstdint>
#include <variant>

#include "../measure.hpp"
#include "engine.hpp"
#include <cairn/math/check.hpp>

namespace cairn::bench {

namespace {

b2Vec2 to_v3(const Vec2<double>& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

struct AddShape {
  b2BodyId body;
  const b2ShapeDef* definition;

  void operator()(const Circle<double>& circle) const {
    const b2Circle converted = {to_v3(circle.center), static_cast<float>(circle.radius)};
    b2CreateCircleShape(body, definition, &converted);
  }
  void operator()(const Polygon<double>& polygon) const {
    List<b2Vec2> corners;
    for (int i = 0; i < polygon.vertices.size(); ++i) corners.push_back(to_v3(polygon.vertices[i]));
    const b2Hull hull = b2ComputeHull(corners.data(), corners.size());
    const b2Polygon converted = b2MakePolygon(&hull, static_cast<float>(polygon.radius));
    b2CreatePolygonShape(body, definition, &converted);
  }
  void operator()(const Segment<double>& segment) const {
    const b2Segment converted = {to_v3(segment.point1), to_v3(segment.point2)};
    b2CreateSegmentShape(body, definition, &converted);
  }
  void operator()(const Capsule<double>& capsule) const {
    const b2Capsule converted = {to_v3(capsule.point1), to_v3(capsule.point2),
                                 static_cast<float>(capsule.radius)};
    b2CreateCapsuleShape(body, definition, &converted);
  }
  void operator()(const Chain<double>& chain) const {
    require(chain.closed, "Box2D 3", "chain", "closed", "open");
    List<b2Vec2> points;
    for (const Vec2<double>& point : chain.points) points.push_back(to_v3(point));
    b2ChainDef converted = b2DefaultChainDef();
    converted.points = points.data();
    converted.count = points.size();
    converted.isLoop = true;
    converted.materials = &definition->material;
    converted.materialCount = 1;
    converted.filter = definition->filter;
    b2CreateChain(body, &converted);
  }
};

b2BodyId add(b2WorldId world, const SceneBody& body) {
  const BodySpec& spec = body.spec;
  b2BodyDef definition = b2DefaultBodyDef();
  definition.type = spec.type == BodyType::dynamic     ? b2_dynamicBody
                    : spec.type == BodyType::kinematic ? b2_kinematicBody
                                                       : b2_staticBody;
  definition.position = to_v3(body.pose.position);
  definition.rotation = b2MakeRot(static_cast<float>(body.pose.angle));
  definition.linearVelocity = to_v3(spec.velocity);
  definition.angularVelocity = static_cast<float>(spec.angular_velocity);
  const b2BodyId result = b2CreateBody(world, &definition);
  b2ShapeDef shape = b2DefaultShapeDef();
  shape.material.friction = static_cast<float>(spec.material.friction);
  shape.material.restitution = static_cast<float>(spec.material.restitution);
  shape.filter.categoryBits = spec.filter.category;
  shape.filter.maskBits = spec.filter.collides_with;
  shape.updateBodyMass = false;
  for (const Shape<double>& one : spec.shapes) std::visit(AddShape{result, &shape}, one);
  if (spec.type == BodyType::dynamic) {
    b2Body_SetMassData(result, {static_cast<float>(body.mass), {0, 0}, static_cast<float>(body.inertia)});
  }
  return result;
}

class Box2D3Engine final : public Engine {
 public:
  Box2D3Engine(const Scene& scene, const PeerSettings& settings)
      : substeps_(settings.substeps), dt_(static_cast<float>(scene.settings().dt)) {
    b2WorldDef definition = b2DefaultWorldDef();
    definition.gravity = to_v3(scene.settings().gravity);
    definition.enableSleep = false;
    definition.enableContinuous = false;
    // It would say into the tables that it takes up no more than 128 new pairs of a shape in a step.
    b2SetLogFcn([](const char*) {});
    world_ = b2CreateWorld(&definition);
    for (const SceneBody& body : scene.bodies()) bodies_.push_back(add(world_, body));
    for (const Pin& joint : pins_of(scene)) pin(joint);
  }
  ~Box2D3Engine() override { b2DestroyWorld(world_); }
  Box2D3Engine(const Box2D3Engine&) = delete;
  Box2D3Engine& operator=(const Box2D3Engine&) = delete;

  void step() override { b2World_Step(world_, dt_, substeps_); }
  void put(const SceneBody& body) { bodies_.push_back(add(world_, body)); }
  b2Profile profile() const { return b2World_GetProfile(world_); }
  PerBody<Pose<double>> poses() const override {
    PerBody<Pose<double>> result;
    for (const b2BodyId body : bodies_) {
      const b2Pos center = b2Body_GetWorldCenter(body);
      result.push_back({.position = {center.x, center.y},
                        .angle = static_cast<double>(b2Rot_GetAngle(b2Body_GetRotation(body)))});
    }
    return result;
  }
  PerBody<Vec3<double>> velocities() const override {
    PerBody<Vec3<double>> result;
    for (const b2BodyId body : bodies_) {
      const b2Vec2 velocity = b2Body_GetLinearVelocity(body);
      result.push_back({velocity.x, velocity.y, b2Body_GetAngularVelocity(body)});
    }
    return result;
  }

 private:
  void pin(const Pin& pin) {
    b2RevoluteJointDef definition = b2DefaultRevoluteJointDef();
    definition.base.bodyIdA = bodies_[pin.a];
    definition.base.bodyIdB = bodies_[pin.b];
    definition.base.localFrameA = {to_v3(pin.anchor_a), b2MakeRot(static_cast<float>(pin.start))};
    definition.base.localFrameB.p = to_v3(pin.anchor_b);
    definition.base.collideConnected = pin.touch;
    definition.enableLimit = pin.lower.has_value();
    definition.lowerAngle = static_cast<float>(pin.lower.value_or(0));
    definition.upperAngle = static_cast<float>(pin.upper.value_or(0));
    if (pin.motor) {
      definition.enableMotor = true;
      definition.motorSpeed = static_cast<float>(pin.motor->speed);
      definition.maxMotorTorque = static_cast<float>(pin.motor->max_force);
    }
    b2CreateRevoluteJoint(world_, &definition);
  }

  int substeps_;
  float dt_;  // [s]
  b2WorldId world_ = b2_nullWorldId;
  PerBody<b2BodyId> bodies_ = {};
};

}  // namespace

std::unique_ptr<Engine> make_box2d_3(const Scene& scene, const PeerSettings& settings) {
  return std::make_unique<Box2D3Engine>(scene, settings);
}

Phases phases_of_box2d_3(const Scene& scene, const PeerSettings& settings, int steps) {
  Box2D3Engine engine(scene, settings);
  List<Phase> parts = {{.name = "pairs"},
                       {.name = "collide"},
                       {.name = "set-up"},
                       {.name = "constraints"},
                       {.name = "all else"}};
  for (int step = 0; step < steps; ++step) {
    engine.step();
    const b2Profile profile = engine.profile();
    const float told = profile.pairs + profile.collide + profile.solverSetup + profile.constraints;
    int i = 0;
    for (const float milliseconds :
         {profile.pairs, profile.collide, profile.solverSetup, profile.constraints, profile.step - told}) {
      parts[i++].seconds.push_back(1e-3 * static_cast<double>(milliseconds));
    }
  }
  return {.parts = parts};
}

List<Phase> edits_of_box2d_3(const Scene& scene, const BodySpec& body, int times) {
  Box2D3Engine engine(scene, {});
  for (int step = 0; step < 3; ++step) engine.step();
  Scene alone;
  const SceneBody added = alone.bodies()[alone.add(body)];
  Phase in_world = {.name = "b2CreateBody and its shape"}, steps = {.name = "the step after it"};
  for (int i = 0; i < times; ++i) {
    const Stopwatch adding;
    engine.put(added);
    in_world.seconds.push_back(adding.seconds());
    const Stopwatch stepping;
    engine.step();
    steps.seconds.push_back(stepping.seconds());
  }
  return {in_world, steps};
}

std::string box2d_3_version() {
  const b2Version version = b2GetVersion();
  return fmt::format("{}.{}.{}", version.major, version.minor, version.revision);
}

}  // namespace cairn::bench
