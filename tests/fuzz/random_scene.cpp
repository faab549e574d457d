#include "fuzz/random_scene.hpp"

#include <functional>
#include <stdexcept>

#include <cairn/cairn.hpp>

namespace cairn::fuzz {

namespace {

const int most_bodies_at_first = 12;

Vec2<double> point(double reach, Choices& choices) {
  const double x = choices.between(-reach, reach);
  return {x, choices.between(0, 2 * reach)};
}

List<Shape<double>> random_shapes(Choices& choices) {
  const double size = choices.between(0.2, 2), other = choices.between(0.2, 2);
  switch (choices.below(5)) {
    case 0:
      return {box(size, other)};
    case 1:
      return {circle(size / 2)};
    case 2:
      return {capsule({0, 0}, {size / 2, 0}, other / 4)};
    case 3:
      return {box(0.5, 0.5), circle(0.4)};
    default:
      return {polygon({{-size, 0}, {size, 0}, {0, other}})};
  }
}

/// One that only touches, or any.
BodySpec random_spec(Choices& choices, bool plain) {
  BodySpec body = {.shapes = random_shapes(choices)};
  body.position = point(4, choices);
  if (choices.one_in(2)) body.angle = choices.between(-3, 3);
  if (choices.one_in(2)) body.velocity = point(choices.one_in(4) ? 20 : 1, choices);
  if (choices.one_in(6)) body.type = BodyType::static_body;
  if (choices.one_in(8)) body.type = BodyType::kinematic;
  if (choices.one_in(9)) body.sensor = true;
  if (choices.one_in(7)) body.fixed_rotation = true;
  if (choices.one_in(4)) body.material.friction = 0;
  if (choices.one_in(7)) body.damping.linear = choices.between(0, 2);
  if (!plain && choices.one_in(6)) body.material.restitution = choices.between(0, 1);
  return body;
}

std::optional<JointMotor> random_motor(Choices& choices) {
  if (!choices.one_in(3)) return {};
  const double speed = choices.between(-10, 10);
  JointMotor motor{.speed = speed, .max_force = choices.between(0, 100)};
  if (choices.one_in(2)) motor.target = choices.between(-3, 3);
  return motor;
}

JointSpring random_spring(Choices& choices) {
  const double stiffness = choices.one_in(4) ? 1e9 : choices.between(0, 100);
  return {.softness = SpringSoftness{.stiffness = stiffness, .damping = choices.between(0, 5)},
          .rest = choices.between(-1, 1)};
}

/// A joint between two bodies at a point.
using Join = void (*)(Scene&, BodyId a, BodyId b, const Vec2<double>& at, Choices&);

const List<Join>& joins() {
  static const List<Join> all = {
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>& at, Choices& choices) {
        const JointId joint = scene.join<RevoluteJoint>({.a = a, .b = b, .anchor = at});
        scene.change(joint, random_motor(choices));
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>& at, Choices&) {
        scene.join<RevoluteJoint>({.a = a, .b = b, .anchor = at, .lower = -0.5, .upper = 0.5});
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>& at, Choices&) {
        scene.join<WeldJoint>({.a = a, .b = b, .anchor = at});
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>& at, Choices& choices) {
        DistanceJoint::Spec rod = {.a = a, .b = b, .anchor_a = at, .anchor_b = point(4, choices)};
        if (choices.one_in(2)) rod.kind = DistanceJoint::Kind::rope;
        scene.join<DistanceJoint>(rod);
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>& at, Choices& choices) {
        const Vec2<double> axis = point(1, choices);
        const JointId joint = scene.join<PrismaticJoint>({.a = a, .b = b, .anchor = at, .axis = axis});
        scene.change(joint, random_motor(choices));
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>&, Choices& choices) {
        const double most = choices.between(0, 50);
        scene.join<FrictionJoint>({.a = a, .b = b, .max_force = most, .max_torque = most});
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>&, Choices& choices) {
        scene.join<GearJoint>({.a = a, .b = b, .c = random_body(scene, choices)});
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>&, Choices& choices) {
        scene.join<DifferentialJoint>({.a = a, .b = b, .c = random_body(scene, choices)});
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>& at, Choices& choices) {
        PrismaticJoint::Spec spec = {.a = a, .b = b, .anchor = at, .axis = point(1, choices)};
        spec.kind = static_cast<PrismaticJoint::Kind>(choices.below(3));
        spec.spring = random_spring(choices);
        if (choices.one_in(3)) spec.ratchet = choices.between(-1, 1);
        scene.change(scene.join<PrismaticJoint>(spec), random_motor(choices));
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>& at, Choices& choices) {
        RevoluteJoint::Spec spec = {.a = a, .b = b, .anchor = at, .spring = random_spring(choices)};
        if (choices.one_in(3)) spec.ratchet = choices.between(-1, 1);
        scene.change(scene.join<RevoluteJoint>(spec), random_motor(choices));
      },
      [](Scene& scene, BodyId a, BodyId b, const Vec2<double>&, Choices& choices) {
        scene.join<GearJoint>({.a = a,
                               .b = b,
                               .c = random_body(scene, choices),
                               .mesh = GearJoint::Mesh::rack,
                               .axis = point(1, choices)});
      },
  };
  return all;
}

/// What is refused is left out.
void try_it(const std::function<void()>& change) {
  try {
    change();
  } catch (const std::invalid_argument&) {
  }
}

void join_randomly(Scene& scene, Choices& choices) {
  const BodyId a = random_body(scene, choices), b = random_body(scene, choices);
  const Vec2<double> at = point(4, choices);
  const Join join = joins()[choices.below(joins().size())];
  try_it([&] { join(scene, a, b, at, choices); });
}

void add_event_randomly(Scene& scene, double after, Choices& choices) {
  SceneEvent event = {.time = after + choices.between(0, 0.3)};
  const BodyId body = random_body(scene, choices);
  if (choices.one_in(2)) {
    event.action = RemoveBody{body};
  } else {
    event.action = PushBody{.body = body, .impulse = point(3, choices), .point = point(0.5, choices)};
  }
  try_it([&] { scene.add(event); });
}

void change_body(Scene& scene, Choices& choices) {
  const BodyId body = random_body(scene, choices);
  if (body.index >= scene.bodies().size()) return;
  BodySpec spec = scene.bodies()[body].spec;
  spec.material.friction = choices.between(0, 2);
  spec.mass = choices.between(0.1, 1e4);
  try_it([&] { scene.change(body, spec); });
}

SceneSettings random_settings(Choices& choices) {
  SceneSettings settings;
  settings.substeps = 1 + choices.below(4);
  settings.contact_search = static_cast<ContactSearch>(choices.below(3));
  settings.stabilization.policy = static_cast<StabilizationPolicy>(choices.below(5));
  if (choices.one_in(4)) settings.sleeping = Sleeping{.speed = 0.3, .angular_speed = 0.3, .time = 0.1};
  if (choices.one_in(6)) settings.warm_start = false;
  return settings;
}

}  // namespace

Scene random_scene(Choices& choices) {
  SceneSettings settings = random_settings(choices);
  const bool plain = choices.one_in(2);
  if (!plain && choices.one_in(3)) settings.friction_rows = FrictionRows::per_manifold;
  Scene scene(settings);
  if (!choices.one_in(8)) scene.add_ground();
  const int bodies = 2 + choices.below(most_bodies_at_first - 1);
  for (int i = 0; i < bodies; ++i) try_it([&] { scene.add(random_spec(choices, plain)); });
  const int joints = plain ? 0 : choices.below(8);
  for (int i = 0; i < joints; ++i) join_randomly(scene, choices);
  const int events = choices.below(4);
  for (int i = 0; i < events; ++i) add_event_randomly(scene, 0, choices);
  return scene;
}

BodyId random_body(const Scene& scene, Choices& choices) {
  return {choices.below(scene.bodies().size() + 1)};
}

void edit_randomly(Scene& scene, Choices& choices) {
  const bool plain = scene.joints().empty();
  const int changes = 1 + choices.below(3);
  for (int i = 0; i < changes; ++i) {
    switch (choices.below(5)) {
      case 0:
        try_it([&] { scene.add(random_spec(choices, plain)); });
        break;
      case 1:
        try_it([&] { scene.remove(random_body(scene, choices)); });
        break;
      case 2:
        add_event_randomly(scene, choices.between(0, 1), choices);
        break;
      case 3:
        change_body(scene, choices);
        break;
      default:
        if (!plain || choices.one_in(4)) join_randomly(scene, choices);
    }
  }
}

void change_rules(Scene& scene, Choices& choices) {
  SceneSettings settings = scene.settings();
  settings.substeps = 1 + choices.below(4);
  settings.contact_search = static_cast<ContactSearch>(choices.below(3));
  if (choices.one_in(3)) settings.stabilization.policy = static_cast<StabilizationPolicy>(choices.below(5));
  scene.set_settings(settings);
}

}  // namespace cairn::fuzz
