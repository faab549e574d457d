// Measures of runs that are written by hand, and of worlds whose invariants are known.
#include "testing.hpp"

using namespace cairn;

namespace {

const double path_epsilon = std::numeric_limits<double>::epsilon();

/// A body of 2 kg without inertia, at a height and with a velocity; gravity 10 m/s^2 down.
Snapshot ball_at(double time, double height, const Vec2<double>& velocity) {
  Snapshot snapshot{.time = time, .dt = 0.1, .gravity = {0, -10}};
  snapshot.bodies.push_back({});
  snapshot.bodies.push_back({.type = BodyType::dynamic,
                             .pose = {{0, height}, 0},
                             .velocity = {velocity.x(), velocity.y(), 0},
                             .mass = 2,
                             .shapes = {circle(0.5)}});
  return snapshot;
}

Trajectory measured(World<double> world, int iterations, int steps) {
  SequentialImpulse<double> solver({.iterations = iterations});
  TrajectoryMeasure measure;
  measure.add(snapshot(world));
  for (int step = 0; step < steps; ++step) {
    world.step(solver);
    measure.add(snapshot(world));
  }
  return measure.result();
}

}  // namespace

TEST_CASE(
    "the energy gain is the most that there ever was above the start, the change what is left at the end") {
  TrajectoryMeasure measure;
  measure.add(ball_at(0, 1, {0, 0}));      // 20 J
  measure.add(ball_at(0.1, 1, {3, 0}));    // 29 J
  measure.add(ball_at(0.2, 0.5, {1, 0}));  // 11 J
  CHECK(measure.result().energy_gain == 9);
  CHECK(measure.result().energy_change == -9);
  CHECK(measure.result().snapshots == 3);
  CHECK(measure.result().time == 0.2);
  // 20 N through the diagonal of the box around a disc of 1 m.
  CHECK(measure.result().energy_scale == doctest::Approx(20 * std::sqrt(2.0)).epsilon(4 * path_epsilon));
  CHECK(measure.result().relative_energy_gain() == 9 / measure.result().energy_scale);
  CHECK(measure.result().relative_energy_change() == -9 / measure.result().energy_scale);
}

TEST_CASE("a body that hangs from a joint can fall as far as the joint is away") {
  Snapshot hung = ball_at(0, 0, {0, 0});
  hung.joints.push_back({.b = {1}, .anchor_a = {3, 4}, .anchor_b = {3, 4}});
  // 20 N through the diagonal from the far corner around the disc to the anchor.
  CHECK(energy_scale(hung) == doctest::Approx(20 * std::hypot(3.5, 4.5)).epsilon(4 * path_epsilon));
}

TEST_CASE("work that the caller knows of is no gain") {
  TrajectoryMeasure measure;
  measure.add(ball_at(0, 1, {0, 0}));
  measure.add(ball_at(0.1, 1, {3, 0}), 9);
  measure.add(ball_at(0.2, 1, {3, 0}));
  CHECK(measure.result().energy_gain == 0);
  measure.add(ball_at(0.3, 1, {4, 0}), 3);  // 7 J for 3
  CHECK(measure.result().energy_gain == 4);
}

TEST_CASE(
    "the scale of the energy does not depend on the origin, and is 0 for bodies that rest without gravity") {
  CHECK(energy_scale(ball_at(0, 1, {0, 0})) ==
        doctest::Approx(energy_scale(ball_at(0, 1000, {0, 0}))).epsilon(1000 * path_epsilon));
  Snapshot still = ball_at(0, 0, {0, 0});
  still.gravity.setZero();
  CHECK(energy_scale(still) == 0);
  TrajectoryMeasure measure;
  measure.add(still);
  CHECK(measure.result().relative_energy_gain() == 0);
  still.bodies[{1}].velocity = {1, 0, 0};
  measure.add(still);
  CHECK(std::isinf(measure.result().relative_energy_gain()));
}

TEST_CASE("the mean penetration is over all contact points seen, the worst cone over all of them") {
  TrajectoryMeasure measure;
  Snapshot snapshot = ball_at(0, 1, {0, 0});
  measure.add(snapshot);
  CHECK(measure.result().mean_contact_penetration == 0);
  snapshot.contacts.push_back({.b = {1}, .normal = {0, 1}, .separation = -0.03});
  snapshot.contacts.push_back({.b = {1}, .normal = {0, 1}, .separation = 0.5});  // apart: counts as 0
  measure.add(snapshot);
  snapshot.contacts = {{.b = {1},
                        .normal = {0, 1},
                        .separation = -0.06,
                        .normal_impulse = 2,
                        .friction_impulse = -1.5,
                        .friction = 0.5}};
  measure.add(snapshot);
  CHECK(measure.result().mean_contact_penetration == doctest::Approx(0.03).epsilon(4 * path_epsilon));
  CHECK(measure.result().worst_cone_violation == 0.5);
  CHECK(measure.result().worst_penetration == 0);  // the shapes do not overlap, whatever the contacts say
}

TEST_CASE("friction that pushes a body along has power, and friction that brakes it has none") {
  // The ball has gone 0.1 m/s for 0.1 s since the contact was found, 0.5 m below its centre, and turns at
  // 2 rad/s: its lowest point goes 0.1 + 2 * 0.5 = 1.1 m/s to the right.
  Snapshot snapshot = ball_at(0, 1, {0.1, 0});
  snapshot.bodies[{1}].velocity.z() = 2;
  snapshot.bodies[{1}].pose.position.x() = 0.01;
  snapshot.contacts.push_back(
      {.b = {1}, .position = {0, 0.5}, .normal = {0, 1}, .normal_impulse = 1, .friction = 1});
  for (const double friction : {0.2, -0.2}) {
    snapshot.contacts[0].friction_impulse = friction;
    TrajectoryMeasure measure;
    measure.add(snapshot);
    // 0.2 N s in 0.1 s at 1.1 m/s
    const double power = friction > 0 ? 2.2 : 0;
    CHECK(measure.result().worst_friction_power == doctest::Approx(power).epsilon(8 * path_epsilon));
  }
}

TEST_CASE("a body that is not finite makes every measure infinite, and nothing after it counts") {
  TrajectoryMeasure measure;
  measure.add(ball_at(0, 1, {0, 0}));
  measure.add(ball_at(0.1, std::numeric_limits<double>::quiet_NaN(), {0, 0}));
  measure.add(ball_at(0.2, 1, {0, 0}));
  const Trajectory& result = measure.result();
  CHECK_FALSE(result.finite);
  for (const double worst :
       {result.worst_penetration, result.mean_contact_penetration, result.worst_drift, result.energy_gain,
        result.energy_change, result.momentum_error, result.angular_momentum_error,
        result.worst_cone_violation, result.worst_friction_power, result.relative_energy_gain()}) {
    CHECK(worst == std::numeric_limits<double>::infinity());
  }
  TrajectoryMeasure huge;
  huge.add(ball_at(0, 1, {0, 0}));
  huge.add(ball_at(0.1, 1, {1e200, 0}));  // its energy is beyond all numbers
  CHECK_FALSE(huge.result().finite);
}

TEST_CASE("snapshots of another scene are refused") {
  TrajectoryMeasure measure;
  measure.add(ball_at(0, 1, {0, 0}));
  CHECK_THROWS_AS(measure.add(Snapshot{}), std::invalid_argument);
}

TEST_CASE("two bodies on a rod keep their momentum as they fall, but for gravity's") {
  Scene scene(
      {.stabilization = {.policy = StabilizationPolicy::baumgarte}});  // relaxed turns them by its drift
  const BodyId first = scene.add({.shapes = {box(1, 0.2)}, .position = {3, 0}, .velocity = {1, 4}});
  const BodyId second =
      scene.add({.shapes = {box(1, 0.2)}, .position = {5, 0}, .velocity = {-2, 1}, .angular_velocity = 3});
  scene.join<DistanceJoint>({.a = first, .b = second, .anchor_a = {3.5, 0}, .anchor_b = {4.5, 0.1}});
  const int steps = 300;
  const Trajectory run = measured(World(scene), 20, steps);
  CHECK(run.isolated);
  // After 5 s they are 125 m further down, at 50 m/s: roundings of 0.4 kg times 50 m/s, and of that times
  // 125 m, in every step and every one of its 20 row updates.
  const double rounding = steps * 20 * path_epsilon;
  CHECK(run.momentum_error <= 0.4 * 50 * rounding);
  CHECK(run.angular_momentum_error <= 0.4 * 50 * 125 * rounding);
  CHECK(run.momentum_error > 0);
  CHECK(run.angular_momentum_error > 0);
  CHECK(run.worst_drift > 0);
}

TEST_CASE("a pin that has drifted turns its bodies by its drift times its impulse, and no more") {
  Scene scene({.gravity = {0, 0}});
  const BodyId first = scene.add({.shapes = {box(1, 0.2)}, .position = {0, 0}});
  const BodyId second = scene.add({.shapes = {box(1, 0.2)}, .position = {1, 0}, .angular_velocity = 20});
  scene.join<RevoluteJoint>({.a = first, .b = second, .anchor = {0.5, 0}});
  World world(scene);
  SequentialImpulse<double> solver({.iterations = 20});
  TrajectoryMeasure measure;
  measure.add(snapshot(world));
  double most = 0;  // [N m s]
  for (int step = 0; step < 60; ++step) {
    const double drift = snapshot(world).joints[0].drift;
    world.step(solver);
    measure.add(snapshot(world));
    most += drift * snapshot(world).joints[0].impulse.norm();
  }
  CHECK(measure.result().isolated);
  CHECK(measure.result().angular_momentum_error <= most);
  CHECK(measure.result().angular_momentum_error >= most / 1000);
  // 0.4 kg at about 10 m/s, rounded in every of 60 steps by each of 40 row updates
  CHECK(measure.result().momentum_error <= 0.4 * 10 * 60 * 40 * path_epsilon);
}

TEST_CASE("a block that brakes on the ground loses energy, keeps to its cone, and is not isolated") {
  Scene scene;
  scene.add_ground();
  scene.add({.shapes = {box(1, 0.2)}, .position = {0, 0.1}, .velocity = {2, 0}, .mass = 1});
  const Trajectory run = measured(World(scene), 100, 60);
  CHECK_FALSE(run.isolated);
  // It stops after 2 / (0.6 10) = 1/3 s; gravity and the floor give what the slop holds: m g 0.005 m.
  CHECK(run.energy_change == doctest::Approx(-2).epsilon(0.05 / 2));
  CHECK(run.energy_gain <= 1e-12);
  CHECK(run.worst_cone_violation <= 4 * path_epsilon);
  // At rest sliding is 0 but for what 100 sweeps leave.
  CHECK(run.worst_friction_power <= 1e-9);
  CHECK(run.worst_penetration <= 0.005 + 1e-3);
}

TEST_CASE("a momentum that comes from outside is seen: a step of 2 kg from rest to 3 m/s is 6 N s") {
  TrajectoryMeasure measure;
  Snapshot start = ball_at(0, 1, {0, 0});
  start.gravity.setZero();
  measure.add(start);
  start.bodies[{1}].velocity = {3, 0, 0};
  measure.add(start);
  CHECK(measure.result().momentum_error == 6);
  CHECK(measure.result().angular_momentum_error == 6);  // at a height of 1 m above the origin
}
