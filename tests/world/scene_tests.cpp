// From specs to bodies: masses, centres, materials and damping.
#include "testing.hpp"

#include <cairn/measure/fingerprint.hpp>
#include <cairn/world/scene_snapshot.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A disc that comes down on the ground at 2 m/s, touching; returns its velocity after one step without
/// gravity.
Vec3<double> landed(const Material& material, const Material& surface, double threshold) {
  Scene scene({.gravity = {0, 0}, .restitution_threshold = threshold});
  scene.add_ground({.material = surface});
  scene.add({.shapes = {circle(0.5)}, .position = {0, 0.5}, .velocity = {9, -2}, .material = material});
  World<double> world = world_after(scene, 1);
  return world.bodies().velocity[{1}];
}

const double few_roundings = 64 * std::numeric_limits<double>::epsilon();

}  // namespace

TEST_CASE("a body's mass is density times area unless it is given, and its inertia scales with it") {
  Scene scene;
  scene.add({.shapes = {box(2, 3)}, .density = 5});
  scene.add({.shapes = {box(2, 3)}, .mass = 7, .density = 5});
  scene.add({.shapes = {box(2, 3)}, .mass = 7, .inertia = 11});
  scene.add({.shapes = {box(2, 3)}, .fixed_rotation = true});
  scene.add({.type = BodyType::kinematic, .shapes = {box(2, 3)}});
  const double per_mass = (4.0 + 9.0) / 12;  // [m^2] (w^2 + h^2) / 12
  CHECK(scene.bodies()[{1}].mass == doctest::Approx(30).epsilon(few_roundings));
  CHECK(scene.bodies()[{1}].inertia == doctest::Approx(30 * per_mass).epsilon(few_roundings));
  CHECK(scene.bodies()[{2}].mass == 7);
  CHECK(scene.bodies()[{2}].inertia == doctest::Approx(7 * per_mass).epsilon(few_roundings));
  CHECK(scene.bodies()[{3}].inertia == 11);
  CHECK(scene.bodies()[{4}].inertia == 0);
  CHECK(scene.bodies()[{4}].mass > 0);
  CHECK(scene.bodies()[{5}].mass == 0);
  const World world(scene);
  CHECK(world.bodies().inverse_mass[ground].isZero(0));
  CHECK(world.bodies().inverse_mass[{2}] == Vec3<double>(1.0 / 7, 1.0 / 7, 1 / scene.bodies()[{2}].inertia));
  CHECK(world.bodies().inverse_mass[{4}].z() == 0);
  CHECK(world.bodies().inverse_mass[{5}].isZero(0));
}

TEST_CASE("a body's frame is moved to its centre of mass, and its shapes stay where they were in the world") {
  const Vec2<double> center(2, 1);
  const Pose<double> given = {{10, 20}, pi / 3};
  Scene scene;
  const BodyId body =
      scene.add({.shapes = {circle(0.5, center)}, .position = given.position, .angle = given.angle});
  const World world(scene);
  const SnapshotBody now = snapshot(world).bodies[body];
  CHECK((now.pose.position - given.world(center)).norm() <= few_roundings * 25);
  CHECK(now.pose.angle == given.angle);
  const Vec2<double> drawn = now.pose.world(std::get<Circle<double>>(now.shapes.at(0)).center);
  CHECK((drawn - given.world(center)).norm() <= few_roundings * 25);
}

TEST_CASE("the ground's surface is where it was asked for") {
  Scene scene;
  scene.add_ground({.height = 3, .half_width = 2});
  const BodyId box_on_it = scene.add({.shapes = {box(1, 1)}, .position = {1, 3.5}});
  const BodyId box_beside = scene.add({.shapes = {box(1, 1)}, .position = {3, 3.5}});
  const World<double> world = world_after(scene, 30, 100);  // feet 1/2 m from the middle: 1/4 a sweep
  const auto height = [&](BodyId id) { return world.bodies().pose[id].position.y(); };
  CHECK(std::abs(height(box_on_it) - 3.5) <= few_roundings * 30);
  CHECK(height(box_beside) < 3);
}

TEST_CASE("the friction of two bodies is the geometric mean of theirs") {
  // The disc slips: friction changes its 9 m/s by mu times the 2 m/s that the normal impulse takes away.
  const double mu = std::sqrt(0.2 * 0.8);
  const Vec3<double> v = landed({.friction = 0.2}, {.friction = 0.8}, 0);
  CHECK(v.x() == doctest::Approx(9 - mu * 2).epsilon(few_roundings));
  CHECK(landed({.friction = 0}, {.friction = 0.8}, 0).x() == 9);
}

TEST_CASE("the restitution of two bodies is the larger of theirs") {
  CHECK(landed({.restitution = 0.25}, {.restitution = 0.75}, 0).y() ==
        doctest::Approx(1.5).epsilon(few_roundings));
  CHECK(landed({.restitution = 0.75}, {.restitution = 0.25}, 0).y() ==
        doctest::Approx(1.5).epsilon(few_roundings));
}

TEST_CASE("an approach slower than the threshold does not rebound, a faster one does in full") {
  CHECK(landed({.restitution = 0.5}, {}, 1.99).y() == doctest::Approx(1).epsilon(few_roundings));
  CHECK(std::abs(landed({.restitution = 0.5}, {}, 2.01).y()) <= few_roundings);
}

TEST_CASE("damping divides velocities by 1 + c dt in every step, and never turns them around") {
  const double dt = 1.0 / 60;
  for (const double c : {0.5, 3.0, 1000.0}) {
    Scene scene({.gravity = {0, 0}});
    scene.add({.shapes = {circle(1)},
               .velocity = {3, 4},
               .angular_velocity = 5,
               .damping = {.linear = c, .angular = 2 * c}});
    World world(scene);
    SequentialImpulse<double> solver;
    for (int k = 1; k <= 20; ++k) {
      world.step(solver);
      const Vec3<double>& v = world.bodies().velocity[{1}];
      CHECK(v.x() == doctest::Approx(3 * std::pow(1 + c * dt, -k)).scale(0).epsilon(few_roundings));
      CHECK(v.y() == doctest::Approx(4 * std::pow(1 + c * dt, -k)).scale(0).epsilon(few_roundings));
      CHECK(v.z() == doctest::Approx(5 * std::pow(1 + 2 * c * dt, -k)).scale(0).epsilon(few_roundings));
    }
  }
}

TEST_CASE("gravity acts on dynamic bodies by their gravity scale, and on no others") {
  Scene scene({.gravity = {1, -10}});
  scene.add({.shapes = {circle(1)}, .position = {0, 0}, .gravity_scale = -0.5});
  scene.add({.shapes = {circle(1)}, .position = {9, 0}, .gravity_scale = 0});
  scene.add({.type = BodyType::kinematic, .shapes = {circle(1)}, .position = {20, 0}, .velocity = {0, 2}});
  World<double> world = world_after(scene, 1);
  CHECK(world.bodies().velocity[{1}].x() == doctest::Approx(-0.5 / 60));
  CHECK(world.bodies().velocity[{1}].y() == doctest::Approx(5.0 / 60));
  CHECK(world.bodies().velocity[{2}].isZero(0));
  CHECK(world.bodies().velocity[{3}] == Vec3<double>(0, 2, 0));
  CHECK(world.bodies().pose[{3}].position.y() == doctest::Approx(2.0 / 60));
}

TEST_CASE("copies of a scene have the same bodies until one of them is changed") {
  Scene scene;
  scene.add({.shapes = {box(1, 1)}});
  const World world(scene);
  CHECK(&world.scene().bodies() == &scene.bodies());
  displace(scene, {1}, {3, 0});
  CHECK(scene.bodies()[{1}].pose.position == Vec2<double>(3, 0));
  CHECK(world.scene().bodies()[{1}].pose.position == Vec2<double>(0, 0));
}

TEST_CASE("bodies with equal shapes share them, and part when one gets others") {
  Scene scene;
  for (const double x : {0, 2, 4}) scene.add({.shapes = {box(1, 1)}, .position = {x, 0}});
  scene.add({.shapes = {box(1, 2)}, .position = {6, 0}});
  const auto place = [&](int body) { return scene.bodies()[{body}].spec.shapes.data(); };
  CHECK(place(1) == place(2));
  CHECK(place(1) == place(3));
  CHECK(place(1) != place(4));
  BodySpec spec = scene.bodies()[{2}].spec;
  spec.shapes.push_back(circle(0.1));
  scene.change({2}, spec);
  CHECK(scene.bodies()[{2}].spec.shapes.size() == 2);
  CHECK(scene.bodies()[{3}].spec.shapes.size() == 1);
  CHECK(place(1) == place(3));
}

TEST_CASE("a scene is seen as a world of it begins, and no world is made for it") {
  Scene scene({.gravity = {0, -3}, .dt = 0.02, .substeps = 4});
  scene.add_ground();
  const BodyId disc = scene.add(
      {.shapes = {circle(0.5)}, .position = {3, 4}, .velocity = {1, 2}, .angular_velocity = -1, .mass = 2});
  scene.join<DistanceJoint>({.a = ground, .b = disc, .anchor_a = {0, 0}, .anchor_b = {3, 4}});
  displace(scene, disc, {3, 4}, 0.5);
  const Snapshot seen = snapshot(scene), begun = snapshot(World<double>(scene));
  CHECK(seen.dt == 0.02 / 4);
  CHECK(seen.gravity == Vec2<double>(0, -3));
  CHECK(seen.bodies.size() == scene.bodies().size());
  CHECK(seen.bodies[disc].pose.position == Vec2<double>(6, 8));
  CHECK(seen.bodies[disc].pose.angle == 0.5);
  CHECK(seen.bodies[disc].velocity == Vec3<double>(1, 2, -1));
  CHECK(seen.bodies[disc].mass == 2);
  CHECK(seen.bodies[disc].awake);
  CHECK(seen.joints[0].drift == doctest::Approx(5).epsilon(few_roundings));  // 10 m, where the rod has 5
  CHECK(seen.joints[0].drift == begun.joints[0].drift);
  CHECK(seen.dt == begun.dt);
  CHECK(seen.apart == begun.apart);
  CHECK(fingerprint_of(seen) == fingerprint_of(begun));
}
