// Editing the bodies of a scene: what they are, where they begin, and how fast.
#include "edited_scenes.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Bodies of every kind, most of them with a centre of mass beside the frame of their shapes.
Scene every_kind() {
  const List<Shape<double>> beside = {polygon({{0, 0}, {0.7, 0.1}, {0.3, 0.9}}), circle(0.3, {0.8, -0.1})};
  Scene scene;
  scene.add({.shapes = beside, .position = {3.1, 0.3}, .angle = 0.7, .velocity = {1, 2}, .density = 0.3});
  scene.add({.shapes = beside, .position = {0.1, 7}, .angular_velocity = 3, .mass = 0.7});
  scene.add({.shapes = beside, .angle = -2, .mass = 0.7, .inertia = 0.3});
  scene.add({.shapes = beside, .position = {-5, 1}, .fixed_rotation = true});
  scene.add({.position = {1, 1}, .mass = 2, .inertia = 3});
  scene.add({.shapes = {segment({0.1, 0.2}, {1, 0.3})}, .mass = 2, .fixed_rotation = true});
  scene.add({.type = BodyType::kinematic, .shapes = beside, .position = {0, 9}, .velocity = {0.1, 0}});
  scene.add({.type = BodyType::static_body, .shapes = beside, .position = {0.7, -3}, .angle = 0.1});
  scene.add({.type = BodyType::static_body, .position = {-0.0, -0.0}});
  return scene;
}

}  // namespace

TEST_CASE("a body changed to the spec that it has is the same to the last bit, whatever kind it is") {
  Scene scene = every_kind();
  const auto check_all = [&scene] {
    for (const BodyId body : scene.bodies().indices()) {
      if (body == ground) continue;
      CAPTURE(body.index);
      const SceneBody before = scene.bodies()[body];
      scene.change(body, before.spec);
      CHECK(bits_of(scene.bodies()[body]) == bits_of(before));
    }
  };
  check_all();
  for (const BodyId body : scene.bodies().indices()) {
    if (body != ground) displace(scene, body, {0.1, 0.7}, 0.3);
  }
  check_all();
  scene.place({1}, {{-0.0, 1.0 / 3}, 7.1}, {0.1, -0.0, 3});
  check_all();
}

TEST_CASE("a change of density and back leaves no rounding behind") {
  Scene scene = every_kind();
  const SceneBody before = scene.bodies()[{1}];
  BodySpec spec = before.spec;
  spec.density = 0.7;
  scene.change({1}, spec);
  CHECK(scene.bodies()[{1}].mass == doctest::Approx(before.mass * 7 / 3).epsilon(1e-15));
  spec.density = before.spec.density;
  scene.change({1}, spec);
  CHECK(bits_of(scene.bodies()[{1}]) == bits_of(before));
}

TEST_CASE("a changed body has the mass of its new shapes, type and density, and begins where it was") {
  Scene scene;
  const BodyId body = scene.add({.shapes = {box(1, 1)}, .position = {2, 3}, .angle = 0.5});
  BodySpec spec = scene.bodies()[body].spec;
  spec.shapes = {box(2, 3)};
  spec.density = 5;
  spec.material.friction = 0.25;
  scene.change(body, spec);
  const SceneBody& now = scene.bodies()[body];
  CHECK(now.mass == doctest::Approx(30).epsilon(1e-14));
  CHECK(now.inertia == doctest::Approx(30 * (4.0 + 9.0) / 12).epsilon(1e-14));
  CHECK((now.pose.position - Vec2<double>(2, 3)).norm() <= 1e-15);
  CHECK(now.pose.angle == 0.5);
  CHECK(now.spec.material.friction == 0.25);
  spec = now.spec;
  spec.type = BodyType::kinematic;
  scene.change(body, spec);
  CHECK(scene.bodies()[body].mass == 0);
  CHECK(scene.bodies()[body].inertia == 0);
}

TEST_CASE("shapes that move the centre of mass of a free body stay where they are in the world") {
  Scene scene;
  const Pose<double> pose = {{2, 3}, 0.5};
  const BodyId body = scene.add({.shapes = {circle(1)}, .position = pose.position, .angle = pose.angle});
  BodySpec spec = scene.bodies()[body].spec;
  spec.shapes.push_back(circle(1, {4, 0}));
  scene.change(body, spec);
  const SceneBody& now = scene.bodies()[body];
  const double tolerance = 64 * std::numeric_limits<double>::epsilon() * 4;  // of numbers of 4 m
  CHECK((now.pose.position - pose.world({2, 0})).norm() <= tolerance);
  CHECK((std::get<Circle<double>>(now.spec.shapes[0]).center - Vec2<double>(-2, 0)).norm() <= tolerance);
  CHECK((std::get<Circle<double>>(now.spec.shapes[1]).center - Vec2<double>(2, 0)).norm() <= tolerance);
}

TEST_CASE("a body with joints may grow around its centre of mass, and not beside it") {
  HangingChain chain;
  BodySpec spec = chain.scene.bodies()[{1}].spec;
  spec.shapes = {box(0.3, 0.7)};
  chain.scene.change({1}, spec);
  CHECK(snapshot(World<double>(chain.scene)).joints[0].drift <= 1e-15);
  spec.shapes = {circle(0.5, {0.25, 0})};
  CHECK(message_of([&] { chain.scene.change({1}, spec); }) ==
        "Scene::change: shapes must be around the body's centre of mass, (0, 0) m, while it has joints, got "
        "(0.25, 0)");
  CHECK(chain.scene.bodies()[{1}].mass == doctest::Approx(0.21));
  while (!chain.scene.joints().empty()) chain.scene.remove(chain.scene.joints().id(0));
  chain.scene.change({1}, spec);
  CHECK(chain.scene.bodies()[{1}].pose.position.x() == 1.25);
}

TEST_CASE("a body begins where and as fast as it was placed, bit by bit") {
  Scene scene = every_kind();
  const Pose<double> pose = {{0.1, 1.0 / 3}, 7.3};
  const Vec3<double> velocity(0.7, -1.0 / 7, 3.3);
  scene.place({1}, pose, velocity);
  const World world(scene);
  CHECK(world.bodies().pose[{1}].position == pose.position);
  CHECK(world.bodies().pose[{1}].angle == pose.angle);
  CHECK(world.bodies().velocity[{1}] == velocity);
  // The frame that its shapes were given in goes with it, as when it is displaced.
  Scene displaced = every_kind();
  const Pose<double> from = displaced.bodies()[{1}].pose;
  displace(displaced, {1}, pose.position - from.position, pose.angle - from.angle);
  const BodySpec& spec = scene.bodies()[{1}].spec;
  CHECK((spec.position - displaced.bodies()[{1}].spec.position).norm() <= 1e-14);
  CHECK(spec.angle == pose.angle);
}

TEST_CASE("a scene into which a world's present is written goes on as that world") {
  Scene scene = every_kind();
  World world(scene);
  SequentialImpulse<double> solver;
  for (int step = 0; step < 20; ++step) world.step(solver);
  for (const BodyId body : scene.bodies().indices()) {
    if (body != ground) scene.place(body, world.bodies().pose[body], world.bodies().velocity[body]);
  }
  World next(scene);
  world.step(solver);
  next.step(solver);
  for (const BodyId body : scene.bodies().indices()) {
    CHECK(next.bodies().pose[body].position == world.bodies().pose[body].position);
    CHECK(next.bodies().velocity[body] == world.bodies().velocity[body]);
  }
}

TEST_CASE("a static body is not placed with a velocity") {
  Scene scene;
  const BodyId wall = scene.add({.type = BodyType::static_body, .shapes = {box(1, 1)}});
  CHECK(message_of([&] {
          scene.place(wall, {{1, 0}, 0}, {0, 3, 4});
        }) == "Scene::place: velocity must be 0 for a static body, got 5");
  CHECK(scene.bodies()[wall].pose.position == Vec2<double>(0, 0));
  scene.place(wall, {{1, 0}, 0}, {0, 0, 0});
  CHECK(scene.bodies()[wall].pose.position == Vec2<double>(1, 0));
}
