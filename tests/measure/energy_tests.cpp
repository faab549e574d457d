// Energy and momentum: of states written by hand, and of worlds that must keep them.
#include "geometry/random_shapes.hpp"
#include "testing.hpp"

using namespace cairn;

namespace {

/// Two bodies by hand: 2 kg at (1, 3) and 4 kg at (-2, 0), and the ground, which counts for nothing.
Snapshot two_bodies() {
  Snapshot snapshot;
  snapshot.gravity = {0, -10};
  snapshot.bodies.push_back({.type = BodyType::static_body, .pose = {{0, -5}, 0}});
  snapshot.bodies.push_back(
      {.type = BodyType::dynamic, .pose = {{1, 3}, 0}, .velocity = {3, -4, 2}, .mass = 2, .inertia = 0.5});
  snapshot.bodies.push_back({.type = BodyType::dynamic,
                             .pose = {{-2, 0}, 1},
                             .velocity = {0, 1, 0},
                             .mass = 4,
                             .inertia = 3,
                             .gravity_scale = 0.5});
  return snapshot;
}

/// Discs of all sizes that fly at each other without gravity.
Scene cluster(int discs) {
  Scene scene({.gravity = {0, 0}, .restitution_threshold = 0});
  test::Random random(5);
  for (int i = 0; i < discs; ++i) {
    const Vec2<double> place(1.5 * (i % 5), 1.5 * (i / 5));
    scene.add({.shapes = {circle(random.uniform(0.3, 0.6))},
               .position = place,
               .velocity = Vec2<double>(3, 3) - place + random.point(1),
               .angular_velocity = random.uniform(-5, 5),
               .material = {.restitution = random.uniform(0, 1)}});
  }
  return scene;
}

}  // namespace

TEST_CASE("kinetic energy is (m v^2 + I w^2) / 2, summed over the bodies") {
  CHECK(kinetic_energy(two_bodies()) == (2 * 25 + 0.5 * 4) / 2 + 4 * 1 / 2.0);
}

TEST_CASE("potential energy is m g h with each body's gravity scale") {
  CHECK(potential_energy(two_bodies()) == 2 * 10 * 3 + 0.5 * 4 * 10 * 0);
  Snapshot sideways = two_bodies();
  sideways.gravity = {-10, 0};
  CHECK(potential_energy(sideways) == 2 * 10 * 1 + 0.5 * 4 * 10 * -2);
}

TEST_CASE("total energy is kinetic and potential energy together") {
  CHECK(total_energy(two_bodies()) == kinetic_energy(two_bodies()) + potential_energy(two_bodies()));
}

TEST_CASE("momentum is m v, and I w + x cross m v about the origin") {
  const Vec3<double> total = momentum(two_bodies());
  CHECK(total.x() == 2 * 3 + 4 * 0);
  CHECK(total.y() == 2 * -4 + 4 * 1);
  CHECK(total.z() == 0.5 * 2 + 2 * (1 * -4 - 3 * 3) + 3 * 0 + 4 * (-2 * 1 - 0));
}

TEST_CASE("twenty discs that collide keep their momentum and their angular momentum") {
  World world(cluster(20));
  SequentialImpulse<double> solver;
  const Snapshot start = snapshot(world);
  int contacts = 0;
  for (int step = 0; step < 600; ++step) contacts += world.step(solver).contacts;
  CHECK(contacts > 100);
  const Vec3<double> before = momentum(start), after = momentum(snapshot(world));
  // Every step rounds the velocities of 20 discs, below 10 m/s, at distances below 100 m from the origin.
  double mass = 0;
  for (const SnapshotBody& body : start.bodies) mass += body.mass;
  const double rounding = std::numeric_limits<double>::epsilon() * 600 * mass * 10;
  CHECK(std::abs(after.x() - before.x()) <= rounding);
  CHECK(std::abs(after.y() - before.y()) <= rounding);
  CHECK(std::abs(after.z() - before.z()) <= 100 * rounding);
}

TEST_CASE("collisions and friction never add energy") {
  World world(cluster(20));
  SequentialImpulse<double> solver({.iterations = 50});
  double before = total_energy(snapshot(world));
  for (int step = 0; step < 300; ++step) {
    world.step(solver);
    const double after = total_energy(snapshot(world));
    CHECK(after <= before * (1 + 1e-12));
    before = after;
  }
}
