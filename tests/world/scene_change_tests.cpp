// Changing a scene that is already built: its settings, and where a body stands.
#include "testing.hpp"

using namespace cairn;

TEST_CASE("new settings take the place of a scene's own, and worlds made of it earlier keep theirs") {
  Scene scene;
  scene.add({.shapes = {circle(1)}});
  World before(scene);
  scene.set_settings({.gravity = {3, 0}, .dt = 0.5});
  World after(scene);
  SequentialImpulse<double> solver;
  before.step(solver);
  after.step(solver);
  // One step of falling: g dt.
  CHECK(before.bodies().velocity[{1}].y() == doctest::Approx(-10.0 / 60).epsilon(1e-15));
  CHECK(after.bodies().velocity[{1}] == Vec3<double>(1.5, 0, 0));
}

TEST_CASE("settings that a scene could not be made with are refused, and change nothing") {
  Scene scene({.dt = 0.25});
  CHECK_THROWS_WITH_AS(scene.set_settings({.substeps = 0}),
                       "Scene: substeps must be from 1 to 1000000, got 0", std::invalid_argument);
  CHECK_THROWS_AS(scene.set_settings({.gravity = {0, NAN}}), std::invalid_argument);
  CHECK_THROWS_AS(scene.set_settings({.dt = 0}), std::invalid_argument);
  CHECK(scene.settings().dt == 0.25);
  CHECK(scene.settings().gravity.y() == -10);
}

TEST_CASE("a displaced body is moved, and turned about its centre of mass, with its shapes") {
  const Vec2<double> center(2, 1);
  Scene scene;
  const BodyId body = scene.add({.shapes = {circle(0.5, center)}, .position = {10, 20}});
  displace(scene, body, {0.25, -0.5}, pi / 2);
  const SceneBody& now = scene.bodies()[{1}];
  // Sums of a few numbers of 20 m.
  const double tolerance = 64 * std::numeric_limits<double>::epsilon() * 20;
  CHECK((now.pose.position - Vec2<double>(12.25, 20.5)).norm() <= tolerance);
  CHECK(now.pose.angle == pi / 2);
  CHECK(now.spec.angle == pi / 2);
  // The frame that the shapes were given in turns with it: its origin was at (-2, -1) from the centre.
  CHECK((now.spec.position - Vec2<double>(12.25 + 1, 20.5 - 2)).norm() <= tolerance);
  const World world(scene);
  CHECK((world.bodies().pose[{1}].position - now.pose.position).norm() == 0);
}

TEST_CASE("a joint whose body is displaced begins with the error of that displacement") {
  Scene scene;
  const BodyId bob = scene.add({.shapes = {circle(0.5)}, .position = {0, -2}});
  scene.join<DistanceJoint>({.a = ground, .b = bob, .anchor_a = {0, 0}, .anchor_b = {0, -2}});
  displace(scene, bob, {0, -0.125});
  const World world(scene);
  CHECK(snapshot(world).joints[0].drift == 0.125);
}

TEST_CASE("what cannot be displaced is refused by name") {
  Scene scene;
  const BodyId body = scene.add({.shapes = {circle(1)}});
  CHECK_THROWS_WITH_AS(displace(scene, ground, {0, 0}),
                       "displace: body must be the id of a body other than the ground, got 0",
                       std::invalid_argument);
  CHECK_THROWS_AS(displace(scene, {2}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(displace(scene, {-1}, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(displace(scene, body, {NAN, 0}), std::invalid_argument);
  CHECK_THROWS_AS(displace(scene, body, {0, 0}, INFINITY), std::invalid_argument);
  CHECK(scene.bodies()[{1}].pose.position == Vec2<double>(0, 0));
}
