// Floor 7. Building a Box2D world from a scene, stepping it, and reading it back.
#include <cairn/reference/box2d_world.hpp>

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/math/check.hpp>
#include <cairn/reference/box2d_acting.hpp>
#include <cairn/reference/box2d_contacts.hpp>
#include <cairn/reference/box2d_joints.hpp>
#include <cairn/reference/box2d_events.hpp>
#include <cairn/reference/box2d_shapes.hpp>
#include <cairn/world/plan.hpp>
#include <cairn/world/scene_length.hpp>
#include <cairn/world/scene_snapshot.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

b2BodyType body_type(BodyType type) {
  if (type == BodyType::static_body) return b2_staticBody;
  return type == BodyType::kinematic ? b2_kinematicBody : b2_dynamicBody;
}

constexpr std::uint32_t box2d_filter_bits = 0xFFFF;  // that a category may have

b2Body* create_body(b2World& world, const SceneBody& body) {
  const BodySpec& spec = body.spec;
  b2BodyDef definition;
  definition.type = body_type(spec.type);
  definition.position = to_box2d(body.pose.position);
  definition.angle = static_cast<float>(body.pose.angle);
  definition.linearVelocity = to_box2d(spec.velocity);
  definition.angularVelocity = static_cast<float>(spec.angular_velocity);
  definition.linearDamping = static_cast<float>(spec.damping.linear);
  definition.angularDamping = static_cast<float>(spec.damping.angular);
  definition.gravityScale = static_cast<float>(spec.gravity_scale);
  definition.fixedRotation = spec.fixed_rotation;
  return world.CreateBody(&definition);
}

/// Names the fixtures by their number among the parts of all colliders: Cairn orders contacts by it.
void create_fixtures(b2Body& body, const Shape<double>& shape, const BodySpec& spec, double threshold,
                     int collider) {
  b2FixtureDef definition;
  definition.friction = static_cast<float>(spec.material.friction);
  definition.restitution = static_cast<float>(spec.material.restitution);
  definition.restitutionThreshold = static_cast<float>(threshold);
  definition.filter.categoryBits = static_cast<uint16>(spec.filter.category);
  definition.filter.maskBits = static_cast<uint16>(spec.filter.collides_with & box2d_filter_bits);
  const List<std::unique_ptr<b2Shape>> parts = to_box2d(shape);
  for (int i = 0; i < parts.size(); ++i) {
    definition.shape = parts[i].get();
    definition.userData.pointer = static_cast<std::uintptr_t>(most_box2d_parts * collider + i);
    body.CreateFixture(&definition);
  }
}

void set_mass(b2Body& body, const SceneBody& scene_body) {
  if (scene_body.spec.type != BodyType::dynamic) return;
  b2MassData mass;
  mass.mass = static_cast<float>(scene_body.mass);
  mass.center.SetZero();  // the scene's bodies have their frame there
  mass.I = static_cast<float>(scene_body.inertia);
  body.SetMassData(&mass);
}

void check(const Box2DSettings& settings) {
  require(settings.velocity_iterations >= 0, "Box2DWorld", "velocity_iterations", ">= 0",
          settings.velocity_iterations);
  require(settings.position_iterations >= 0, "Box2DWorld", "position_iterations", ">= 0",
          settings.position_iterations);
}

/// What this world of Box2D would ignore, and so must not be given.
void check_contacts_of(const BodySpec& spec) {
  require(!spec.sensor, "Box2DWorld", "sensor", "false: sensors are not taken over", "true");
  require(spec.filter.one_way.isZero(0), "Box2DWorld", "one_way", "[0, 0]: one-way bodies are not taken over",
          "a direction");
  require(spec.filter.category <= box2d_filter_bits, "Box2DWorld", "category",
          "of the first 16 bits, as Box2D 2.4.1 has no more", spec.filter.category);
}

}  // namespace

struct Box2DWorld::Simulation {
  Simulation(const Scene& the_scene, const Box2DSettings& the_settings);
  void add_bodies();
  void do_event(const SceneEvent& event);
  void drop_joints(const SceneJoints& before);
  SnapshotBody body(BodyId id) const;
  SnapshotJoint joint(int index, const BodyState<double>& state) const;
  BodyState<double> state() const;
  void note_servos();
  void drive_servos();

  Scene scene;
  Box2DSettings settings;
  Box2DContacts contacts;
  b2World world;
  PerBody<b2Body*> bodies;  // owned by the world
  List<b2Joint*> joints;    // in the scene's order; owned by the world
  List<BodyId> colliders;   // whose shape it is, in the scene's order
  bool has_servos = false;
  int steps = 0;
};

Box2DWorld::Simulation::Simulation(const Scene& the_scene, const Box2DSettings& the_settings)
    : scene(the_scene), settings(the_settings), contacts(scene), world(to_box2d(scene.settings().gravity)) {
  check(settings);
  for (const SceneBody& body : scene.bodies()) check_contacts_of(body.spec);
  check_surfaces(scene);
  for (const SceneEvent& event : scene.events()) check_event(event);
  check_strengths(scene.joints());
  world.SetContactListener(&contacts);
  world.SetWarmStarting(scene.settings().warm_start);
  world.SetAllowSleeping(settings.sleeping);
  world.SetContinuousPhysics(settings.continuous);
  add_bodies();
  joints = create_joints(world, scene, bodies);
  note_servos();
}

void Box2DWorld::Simulation::add_bodies() {
  const PerBody<SceneBody>& scene_bodies = scene.bodies();
  PerBody<int> first_collider;
  for (const BodyId id : scene_bodies.indices()) {
    first_collider.push_back(colliders.size());
    for (const Shape<double>& shape : scene_bodies[id].spec.shapes) {
      colliders.resize(colliders.size() + piece_count(shape), id);
    }
  }
  bodies.resize(scene_bodies.size());
  const double threshold = *full_settings(scene).restitution_threshold;
  for (int count = 0; count < scene_bodies.size(); ++count) {
    const bool last_first = settings.creation == Box2DSettings::Creation::last_first;
    const BodyId id = {last_first ? scene_bodies.size() - 1 - count : count};
    const BodySpec& spec = scene_bodies[id].spec;
    bodies[id] = create_body(world, scene_bodies[id]);
    int collider = first_collider[id];
    for (const Shape<double>& shape : spec.shapes) {
      create_fixtures(*bodies[id], shape, spec, threshold, collider);
      collider += piece_count(shape);
    }
    set_mass(*bodies[id], scene_bodies[id]);
  }
}

/// Destroys the joints that the scene had before and has no longer.
void Box2DWorld::Simulation::drop_joints(const SceneJoints& before) {
  List<b2Joint*> kept;
  for (int i = 0; i < before.size(); ++i) {
    if (scene.joints().number_of(before.id(i))) {
      kept.push_back(joints[i]);
    } else {
      world.DestroyJoint(joints[i]);
    }
  }
  joints = kept;
}

/// The scene has done it to itself. A removed body leaves an empty place.
void Box2DWorld::Simulation::do_event(const SceneEvent& event) {
  if (const auto* push = std::get_if<PushBody>(&event.action)) {
    b2Body& body = *bodies[push->body];
    body.ApplyLinearImpulse(to_box2d(push->impulse), body.GetWorldPoint(to_box2d(push->point)), true);
  }
  if (const auto* other = std::get_if<SwitchMotor>(&event.action)) {
    const std::optional<int> number = scene.joints().number_of(other->joint);
    if (number) set_motor(*joints[*number], other->motor);
  }
  if (const auto* other = std::get_if<ChangeBody>(&event.action))
    change_body(*bodies[other->body], scene.bodies()[other->body].spec.material, *other);
  if (const auto* other = std::get_if<SetGravity>(&event.action)) world.SetGravity(to_box2d(other->gravity));
  if (const auto* removal = std::get_if<RemoveBody>(&event.action)) {
    world.DestroyBody(bodies[removal->body]);
    bodies[removal->body] = create_body(world, scene.bodies()[removal->body]);
  }
}

SnapshotBody Box2DWorld::Simulation::body(BodyId id) const {
  const SceneBody& scene_body = scene.bodies()[id];
  const b2Body& box2d_body = *bodies[id];
  const b2Vec2 center = box2d_body.GetWorldCenter();
  const b2Vec2 velocity = box2d_body.GetLinearVelocity();
  return {.type = scene_body.spec.type,
          .pose = {.position = {center.x, center.y}, .angle = static_cast<double>(box2d_body.GetAngle())},
          .velocity = {velocity.x, velocity.y, box2d_body.GetAngularVelocity()},
          .mass = static_cast<double>(box2d_body.GetMass()),
          .inertia = static_cast<double>(box2d_body.GetInertia()),
          .gravity_scale = scene_body.spec.gravity_scale,
          .awake = box2d_body.IsAwake(),
          .removed = scene_body.removed,
          .shapes = scene_body.spec.shapes};
}

SnapshotJoint Box2DWorld::Simulation::joint(int index, const BodyState<double>& state) const {
  SnapshotJoint result = snapshot_joint(*scene.joints()[index], state);
  const b2Vec2 impulse = joints[index]->GetReactionForce(1);  // at dt = 1 s a force is its impulse
  result.id = scene.joints().id(index);
  result.impulse = {impulse.x, impulse.y};
  return result;
}

BodyState<double> Box2DWorld::Simulation::state() const {
  BodyState<double> result = state_of<double>(scene);
  for (const BodyId id : bodies.indices()) {
    const b2Vec2 center = bodies[id]->GetWorldCenter();
    result.pose[id] = {.position = {center.x, center.y},
                       .angle = static_cast<double>(bodies[id]->GetAngle())};
  }
  return result;
}

void Box2DWorld::Simulation::note_servos() {
  has_servos =
      std::any_of(scene.joints().begin(), scene.joints().end(),
                  [](const std::shared_ptr<const Constraint>& joint) { return joint->traits().has_servo; });
}

/// Box2D has motors: the speed of a servo is set before each step.
void Box2DWorld::Simulation::drive_servos() {
  if (!has_servos) return;
  const BodyState<double> now = state();
  for (int i = 0; i < joints.size(); ++i) {
    std::optional<JointMotor> motor = scene.joints()[i]->motor();
    const std::optional<double> speed = servo_speed(*scene.joints()[i], now, scene.settings().dt);
    if (!speed) continue;
    motor->speed = *speed;
    set_motor(*joints[i], motor);
  }
}

Box2DWorld::Box2DWorld(const Scene& scene, const Box2DSettings& settings)
    : simulation_(std::make_unique<Simulation>(scene, settings)) {}

Box2DWorld::~Box2DWorld() = default;

bool Box2DWorld::do_events() {
  Simulation& simulation = *simulation_;
  // The time step and its multiple are rounded, each once.
  const double rounded = 1 + 2 * std::numeric_limits<double>::epsilon();
  const double until = rounded * simulation.steps * simulation.scene.settings().dt;
  const List<SceneEvent> events = simulation.scene.events();
  const SceneJoints before = simulation.scene.joints();
  if (!simulation.scene.do_events(until)) return false;
  simulation.drop_joints(before);
  simulation.note_servos();
  for (const SceneEvent& event : events) {
    if (event.time <= until) simulation.do_event(event);
  }
  return true;
}

void Box2DWorld::step() {
  do_events();
  Simulation& simulation = *simulation_;
  act_on(simulation.bodies, simulation.scene, simulation.steps);
  simulation.drive_servos();
  simulation.contacts.begin_step();
  simulation.world.Step(static_cast<float>(simulation.scene.settings().dt),
                        simulation.settings.velocity_iterations, simulation.settings.position_iterations);
  simulation.steps += 1;
}

Snapshot Box2DWorld::snapshot() const {
  const Simulation& simulation = *simulation_;
  const SceneSettings& settings = simulation.scene.settings();
  Snapshot result{.time = simulation.steps * settings.dt,
                  .step = simulation.steps,
                  .dt = settings.dt,
                  .gravity = settings.gravity,
                  .fields = settings.fields,
                  .contacts = simulation.contacts.contacts(simulation.colliders),
                  .apart = simulation.scene.joints().apart()};
  for (const BodyId id : simulation.bodies.indices()) result.bodies.push_back(simulation.body(id));
  add_actions(simulation.scene, result);
  const BodyState<double> state = simulation.state();
  for (int i = 0; i < simulation.joints.size(); ++i) result.joints.push_back(simulation.joint(i, state));
  add_occurrences(simulation.scene, state, result);
  return result;
}

bool Box2DWorld::is_awake(BodyId body) const {
  const PerBody<b2Body*>& bodies = simulation_->bodies;
  require(body.index >= 0 && body.index < bodies.size(), "Box2DWorld::is_awake", "body",
          "the id of a body of this scene", body.index);
  return bodies[body]->IsAwake();
}

}  // namespace cairn
