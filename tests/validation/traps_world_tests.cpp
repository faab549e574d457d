// Mistakes of a whole step: tangents that disagree, rows in another order, angles that wrap, work that is not
// counted, bodies that fall asleep.
#include "constraints/constraint_list.hpp"
#include "geometry/random_shapes.hpp"
#include <cairn/collision/collide.hpp>
#include "problems.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// The rows between a box of 4 m by 1 m in a pose of its own and one of 1 m by 1 m that lies on it, askew.
template <Scalar Real>
PerRow<ConstraintRow<Real>> rows_of_tilted_boxes(test::Random& random) {
  const Pose<double> below = {random.point(3), random.uniform(-pi, pi)};
  const Vec2<double> place = below.world({random.uniform(-1, 1), 1});
  const Pose<double> above = {place, below.angle + random.uniform(-0.01, 0.01)};
  PerBody<Pose<Real>> poses(1);
  for (const Pose<double>& pose : {below, above}) {
    poses.push_back({pose.position.cast<Real>(), static_cast<Real>(pose.angle)});
  }
  const Manifold<Real> manifold = collide<Real>(shape_cast<Real>(box(4, 1)), poses[{1}],
                                                shape_cast<Real>(box(1, 1)), poses[{2}], Real(0.1));
  return written_contact(manifold, Real(0.5), poses);
}

/// What a rod too long by 0.1 m and the ground leave of a box's vertical speed [m/s] after one step.
double pressed_box_speed(RowOrder order) {
  Scene scene({.stabilization = {.policy = StabilizationPolicy::baumgarte}});
  scene.add_ground();
  const BodyId pressed =
      scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .mass = 1, .fixed_rotation = true});
  scene.join<DistanceJoint>(
      {.a = ground, .b = pressed, .anchor_a = {0, 2}, .anchor_b = {0, 0.5}, .length = 1.6},
      JointCollision::on);
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 20, .order = order});
  world.step(solver);
  return velocity_of(world, pressed).y();
}

}  // namespace

TEST_CASE_TEMPLATE("the friction rows of one manifold are one row written twice, but for rounding", Real,
                   float, double) {
  test::Random random(41);
  int pairs = 0;
  for (int round = 0; round < 200; ++round) {
    const PerRow<ConstraintRow<Real>> rows = rows_of_tilted_boxes<Real>(random);
    if (rows.size() != 4) continue;
    ++pairs;
    const Vec3<Real> gap_a = rows[1].jacobian_a - rows[3].jacobian_a;
    const Vec3<Real> gap_b = rows[1].jacobian_b - rows[3].jacobian_b;
    // Places in the world are below 8 m, and each is rounded a few times.
    const Real tolerance = 8 * 8 * std::numeric_limits<Real>::epsilon();
    CHECK(gap_a.cwiseAbs().maxCoeff() <= tolerance);
    CHECK(gap_b.cwiseAbs().maxCoeff() <= tolerance);
    CHECK(std::abs(rows[0].jacobian_a.z() - rows[2].jacobian_a.z()) > Real(0.5));  // two points all the same
  }
  CHECK(pairs > 150);
}

TEST_CASE("contacts come after joints, so that a box pressed too hard stays out of the ground") {
  // The rod wants beta C / dt = 1.2 m/s downwards, the ground 0: the last row of a sweep gets its wish.
  const double rod_speed = 0.2 * 0.1 / test_dt;
  CHECK(std::abs(pressed_box_speed(RowOrder::as_written)) <= 1e-12);  // of impulses up to 20 * 1.2 N s
  CHECK(pressed_box_speed(RowOrder::reverse) == doctest::Approx(-rod_speed).epsilon(1e-12));
}

TEST_CASE("a hinge with limits counts turns: it stops a wheel at 9 rad, not at 9 - 2 pi, and lets it back") {
  const double limit = 9, speed = 4;  // [rad], [rad/s]
  Scene scene({.gravity = {0, 0}});
  const BodyId wheel = scene.add({.shapes = {circle(0.5)}, .angle = 3, .angular_velocity = speed, .mass = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = wheel, .anchor = {0, 0}, .lower = -limit, .upper = limit});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 10});
  for (const double direction : {1.0, -1.0}) {
    world.set_velocity(wheel, {0, 0, direction * speed});
    const double from = pose_of(world, wheel).angle;
    run(world, solver, 1);  // 4 rad, past pi
    CHECK(pose_of(world, wheel).angle == doctest::Approx(from + direction * speed).epsilon(1e-12));
    run(world, solver, 5);
    // The angle is measured from that of the start. The last step takes what room is left.
    CHECK(pose_of(world, wheel).angle == doctest::Approx(3 + direction * limit).epsilon(1e-9));
    CHECK(std::abs(velocity_of(world, wheel).z()) <= 1e-9);
  }
}

TEST_CASE("a weld holds while its bodies turn through pi at different times, again and again") {
  const double omega = 10;  // [rad/s]
  Scene scene({.gravity = {0, 0}});
  List<BodyId> halves;
  for (const double side : {-1.0, 1.0}) {
    halves.push_back(scene.add({.shapes = {circle(0.5)},
                                .position = {side, 0},
                                .angle = side * 3,
                                .velocity = {0, side * omega},
                                .angular_velocity = omega,
                                .mass = 1}));
  }
  scene.join<WeldJoint>({.a = halves[0], .b = halves[1], .anchor = {0, 0}});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 500});
  for (int step = 1; step <= 200; ++step) {
    world.step(solver);
    // Symmetric about the middle, so that nothing turns the halves against each other.
    const double angle = pose_of(world, halves[1]).angle - pose_of(world, halves[0]).angle;
    CHECK(std::abs(angle - 6) <= 1e-9);
    CHECK(std::abs(velocity_of(world, halves[0]).z() - velocity_of(world, halves[1]).z()) <= 1e-9);
  }
  CHECK(pose_of(world, halves[1]).angle > 8 * pi);  // the stretch of a fast turn slows it
}

TEST_CASE("nothing falls asleep: a stack at rest for ten seconds falls freely when its table is gone") {
  Scene scene;
  const BodyId table =
      scene.add({.type = BodyType::kinematic, .shapes = {box(10, 1)}, .position = {0, -0.5}});
  const List<BodyId> boxes = samples::add_stack(scene, 3);
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 50});
  run(world, solver, 10);
  CHECK(world.last_step().problem.row_count() == 3 * 4);
  world.set_velocity(table, {0, -10, 0});
  const double before = velocity_of(world, boxes[0]).y();
  world.step(solver);
  CHECK(std::abs(before) <= 1e-9);
  for (const BodyId each : boxes) {
    CHECK(velocity_of(world, each).y() == doctest::Approx(-test_gravity * test_dt).epsilon(1e-6));
  }
}
