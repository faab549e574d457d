// What may touch what: categories, sensors, joints that let bodies collide, and bullets.
#include <Eigen/QR>

#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double wall_thickness = 0.1;  // [m]

/// A bullet of 5 cm, 2 m in front of a thin wall at x = 0.
World<double> bullet_and_wall(double speed, double restitution = 0) {
  Scene scene({.gravity = {0, 0}});
  scene.add({.type = BodyType::static_body,
             .shapes = {box(wall_thickness, 4)},
             .position = {wall_thickness / 2, 0},
             .material = {.restitution = restitution}});
  scene.add({.shapes = {circle(0.05)}, .position = {-2, 0}, .velocity = {speed, 0}});
  return World(scene);
}

double bullet_x(const World<double>& world) { return world.bodies().pose[{2}].position.x(); }

}  // namespace

TEST_CASE("a bullet never passes a thin wall, at any speed up to 1e5 m/s") {
  for (const double speed : {1.0, 10.0, 100.0, 1e3, 1e5}) {
    CAPTURE(speed);
    World<double> world = bullet_and_wall(speed);
    for (int step = 0; step < 300; ++step) {
      take_steps(world, 1);
      CHECK(bullet_x(world) <= -0.05 + 1e-9 * speed);  // at the wall, but for the rounding of C / dt * dt
    }
    CHECK(world.bodies().velocity[{2}].x() <= 1e-9 * speed);
  }
}

TEST_CASE("a bullet rebounds with e of its speed, as any other") {
  World<double> world = bullet_and_wall(1e3, 0.5);
  take_steps(world, 3);
  CHECK(world.bodies().velocity[{2}].x() == doctest::Approx(-500).epsilon(1e-12));
}

TEST_CASE("bodies touch only if each accepts the other's category") {
  const auto rows_between = [](std::uint32_t category_a, std::uint32_t with_a, std::uint32_t category_b,
                               std::uint32_t with_b) {
    Scene scene;
    scene.add({.shapes = {circle(1)}, .filter = {.category = category_a, .collides_with = with_a}});
    scene.add({.shapes = {circle(1)},
               .position = {1.5, 0},
               .filter = {.category = category_b, .collides_with = with_b}});
    World world(scene);
    take_steps(world, 1);
    return world.last_step().problem.row_count();
  };
  CHECK(rows_between(1, ~0u, 1, ~0u) == 2);
  CHECK(rows_between(2, 4, 4, 2) == 2);
  CHECK(rows_between(2, 4, 4, 4) == 0);  // one is not enough
  CHECK(rows_between(2, 2, 4, 2) == 0);
  CHECK(rows_between(1, 0, 1, ~0u) == 0);
}

TEST_CASE("a sensor names what touches it, and neither pushes nor is pushed") {
  Scene scene({.gravity = {0, 0}});
  scene.add({.type = BodyType::static_body, .shapes = {box(2, 2)}, .sensor = true});
  scene.add({.shapes = {circle(0.5)}, .position = {-3.05, 0}, .velocity = {6, 0}});
  World<double> world(scene);
  int sensed = 0;
  for (int step = 0; step < 60; ++step) {
    const double x = world.bodies().pose[{2}].position.x();
    take_steps(world, 1);
    const bool overlaps = std::abs(x) < 1.5;
    CHECK((world.last_step().sensed.size() == 1) == overlaps);
    sensed += overlaps;
    CHECK(world.last_step().problem.rows.empty());
  }
  CHECK(sensed == 30);  // from -1.45 m to 1.45 m, at 0.1 m a step
  CHECK(world.bodies().pose[{2}].position.x() == doctest::Approx(2.95).epsilon(1e-12));
}

TEST_CASE("joined bodies collide where the scene lets them") {
  for (const JointCollision collision : {JointCollision::as_usual, JointCollision::off, JointCollision::on}) {
    Scene scene({.gravity = {0, 0}});
    const BodyId a = scene.add({.shapes = {circle(1)}});
    const BodyId b = scene.add({.shapes = {circle(1)}, .position = {1.5, 0}, .material = {.friction = 0}});
    scene.join<DistanceJoint>({.a = a, .b = b, .anchor_a = {0, 0}, .anchor_b = {1.5, 0}}, collision);
    World world(scene);
    take_steps(world, 1);
    const bool collide = collision == JointCollision::on;
    CHECK(world.last_step().problem.contacts.size() == (collide ? 1u : 0u));
    CHECK(snapshot(world).apart.size() == (collide ? 0u : 1u));
  }
}

TEST_CASE("one friction row a manifold gives the forces of two, in fewer rows and with full rank") {
  const auto slide = [](FrictionRows friction_rows) {
    Scene scene({.gravity = {6, -8}, .friction_rows = friction_rows});
    scene.add_ground({.material = {.friction = 0.5}});
    for (int i = 0; i < 2; ++i) {
      scene.add({.shapes = {box(2, 1)}, .position = {0, 0.5 + i}, .mass = 1, .material = {.friction = 0.5}});
    }
    return World<double>(scene);
  };
  World<double> per_point = slide(FrictionRows::per_point);
  World<double> per_manifold = slide(FrictionRows::per_manifold);
  SequentialImpulse<double> solver({.iterations = 200});
  for (int step = 0; step < 60; ++step) {
    per_point.step(solver);
    per_manifold.step(solver);
  }
  CHECK(per_point.last_step().problem.row_count() == 8);
  CHECK(per_manifold.last_step().problem.row_count() == 6);
  // Both slide with g (sin - mu cos): 6 - 0.5 * 8 = 2 m/s^2; what is left is the solver's, 200 sweeps a step.
  for (const World<double>* world : {&per_point, &per_manifold}) {
    CHECK(world->bodies().velocity[{1}].x() == doctest::Approx(2).epsilon(1e-6));
    CHECK(world->bodies().velocity[{2}].x() == doctest::Approx(2).epsilon(1e-6));
    const Snapshot now = snapshot(*world);
    double friction = 0, load = 0;
    for (const SnapshotContact& contact : now.contacts) {
      CHECK(std::abs(contact.friction_impulse) <= 0.5 * contact.normal_impulse * (1 + 1e-12));
      if (contact.a != ground) continue;
      friction += contact.friction_impulse / now.dt;
      load += contact.normal_impulse / now.dt;
    }
    CHECK(load == doctest::Approx(16).epsilon(1e-6));
    CHECK(std::abs(friction) == doctest::Approx(8).epsilon(1e-6));
  }
  const auto nullity = [](const World<double>& world) {
    const SystemMatrices<double> system = system_matrices(world.last_step().problem);
    return system.A.rows() - Eigen::ColPivHouseholderQR<Matrix<double>>(system.A).rank();
  };
  CHECK(nullity(per_point) == 2);  // one for each manifold
  CHECK(nullity(per_manifold) == 0);
}
