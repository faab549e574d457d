// Pucks on a table, seen from above: cones and pyramids of friction.
#include "solvers/solver_list.hpp"
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr double puck_mass = 2;                           // [kg]
constexpr double puck_inertia = 0.5;                      // [kg m^2]
constexpr double table_grip = 4;                          // [m/s^2] mu g
constexpr double puck_friction = puck_mass * table_grip;  // [N] mu m g
constexpr double puck_speed = 4;                          // [m/s]
constexpr double fine_dt = 1.0 / 4096;                    // [s]

/// One puck on a table, sliding at this speed and direction; the pull is that of a table that leans.
Scene puck_scene(FrictionShape shape, double direction, double speed = puck_speed, double dt = fine_dt,
                 const Vec2<double>& pull = {0, 0}) {
  Scene scene({.gravity = pull, .dt = dt});
  BodySpec puck = disc({0, 0}, puck_mass, puck_inertia);
  puck.velocity = speed * Vec2<double>(std::cos(direction), std::sin(direction));
  const BodyId body = scene.add(puck);
  scene.join<FrictionJoint>({.b = body, .max_force = puck_friction, .shape = shape});
  return scene;
}

}  // namespace

TEST_CASE(
    "from rest, the circle holds a pull up to mu m g in all directions, and the square more on diagonals") {
  const auto acceleration = [](FrictionShape shape, double pull) {
    const Vec2<double> diagonal = pull * Vec2<double>(std::sqrt(0.5), std::sqrt(0.5));
    World world(puck_scene(shape, 0, 0, joint_dt, diagonal));
    step_often(world, 30, 5);
    const Vec2<double> velocity = world.bodies().velocity[{1}].head<2>();
    CHECK(std::abs(cross(velocity, diagonal)) <= 1e-12);
    return velocity.norm() / (30 * joint_dt);
  };
  // The rounding of 30 steps.
  CHECK(acceleration(FrictionShape::circle, 0.9 * table_grip) <= 1e-13);
  CHECK(acceleration(FrictionShape::circle, 1.3 * table_grip) ==
        doctest::Approx(0.3 * table_grip).epsilon(1e-12));
  CHECK(acceleration(FrictionShape::square, 1.3 * table_grip) <= 1e-13);
  CHECK(acceleration(FrictionShape::square, 2 * table_grip) ==
        doctest::Approx((2 - std::sqrt(2)) * table_grip).epsilon(1e-12));
}

TEST_CASE("where a string turns the way of a puck, the circle still takes mu g off its speed") {
  const double length = 1.5, seconds = 0.5;
  Scene scene({.gravity = {0, 0}, .dt = fine_dt});
  BodySpec puck = disc({length, 0}, puck_mass, puck_inertia);
  puck.velocity = {0, puck_speed};
  const BodyId body = scene.add(puck);
  scene.join<DistanceJoint>({.a = ground, .b = body, .anchor_a = {0, 0}, .anchor_b = {length, 0}});
  scene.join<FrictionJoint>({.b = body, .max_force = puck_friction});
  World world(scene);
  step_often(world, static_cast<int>(seconds / fine_dt), 10);
  // The string turns the way by v dt / length in a step, up to 7e-4 rad, and the friction is behind by about
  // so much: its cosine loses the square of that, and its sine goes to the string. What the string takes off
  // by turning the velocity is of the first order in it.
  const double speed = puck_speed - table_grip * seconds;
  CHECK(world.bodies().velocity[{1}].head<2>().norm() == doctest::Approx(speed).epsilon(1e-3));
}

TEST_CASE("friction stops the turning of a puck by max_torque, and then holds it") {
  Scene scene({.gravity = {0, 0}});
  BodySpec puck = disc({0, 0}, puck_mass, puck_inertia);
  puck.angular_velocity = 3;
  const double torque = 1;  // 2 rad/s^2: at rest after 1.5 s
  const BodyId body = scene.add(puck);
  scene.join<FrictionJoint>({.b = body, .max_torque = torque});
  World world(scene);
  REQUIRE(joint_row_count(world) == 1);  // no rows for sliding where there is no friction
  step_often(world, 60, 1);
  CHECK(world.bodies().velocity[{1}].z() == doctest::Approx(3 - 2 * 60 * joint_dt).epsilon(1e-12));
  step_often(world, 60, 1);
  CHECK(std::abs(world.bodies().velocity[{1}].z()) <= 1e-15);
}

TEST_CASE("a plank that slides on another gives it what it loses, and both end at one velocity") {
  Scene scene({.gravity = {0, 0}});
  BodySpec upper = disc({1, 1}, 1, 1), lower = disc({0, 0}, 3, 2);
  upper.velocity = {2, 1};
  const BodyId on = scene.add(upper), under = scene.add(lower);
  scene.join<FrictionJoint>({.a = under, .b = on, .max_force = 2, .max_torque = 1});
  World world(scene);
  step_often(world, 600, 50);
  const Vec2<double> apart = world.bodies().pose[{1}].position - world.bodies().pose[{2}].position;
  step_often(world, 1, 50);
  const Vec3<double>& v = world.bodies().velocity[{1}];
  const Vec3<double>& w = world.bodies().velocity[{2}];
  const Vec2<double> momentum = v.head<2>() + 3 * w.head<2>();
  CHECK((momentum - Vec2<double>(2, 1)).norm() <= 1e-12);  // the rounding of 600 steps
  // They go on as one rigid body, by the places where the step began.
  CHECK(v.z() == doctest::Approx(w.z()).epsilon(1e-9));
  const Vec2<double> slip = v.head<2>() - w.head<2>() - cross(w.z(), apart);
  CHECK(slip.norm() <= 1e-9);
  // Internal forces leave the moment of momentum about the origin as it was: (1, 1) x (2, 1) = -1.
  const double moment = cross<double>(world.bodies().pose[{1}].position, v.head<2>()) + v.z() +
                        3 * cross<double>(world.bodies().pose[{2}].position, w.head<2>()) + 2 * w.z();
  CHECK(moment == doctest::Approx(-1).epsilon(1e-9));
}

TEST_CASE("all solvers agree on a puck in the circle, and none leaves it") {
  for (const double speed : {0.01, 4.0}) {  // held, and sliding
    World world(puck_scene(FrictionShape::circle, 0.7, speed, joint_dt));
    const VelocityProblem<double> start = world.velocity_problem();
    REQUIRE(start.rows.size() == 2);
    VelocityProblem<double> expected = start;
    SequentialImpulse<double>({.iterations = 200}).solve(expected);
    CHECK(residual(expected, residual_scale(start)).energy <= 1e-14);
    for (const SolverMaker<double>& make : all_solvers<double>(Iterates::any)) {
      VelocityProblem<double> problem = start;
      make({.iterations = 200})->solve(problem);
      CHECK((problem.velocity[{1}] - expected.velocity[{1}]).norm() <= 1e-13);
      CHECK(std::hypot(problem.impulse[0], problem.impulse[1]) <= puck_friction * joint_dt * (1 + 1e-15));
    }
  }
}

TEST_CASE("on fixed axes that leave each other the rest of a disc, the order of the rows is the answer") {
  // 1 kg that slides at 45 degrees: Coulomb's impulse is radius / sqrt(2) on both axes. Here the row that is
  // first takes all, and no row may change it: an answer, but to another question.
  for (const int first : {0, 1}) {
    VelocityProblem<double> problem;
    problem.velocity = {Vec3<double>::Zero(), Vec3<double>(2, 2, 0)};
    problem.inverse_mass = {Vec3<double>::Zero(), Vec3<double>(1, 1, 1)};
    for (int i = 0; i < 2; ++i) {
      ConstraintRow<double> row;
      row.b = {1};
      row.jacobian_b(i == 0 ? first : 1 - first) = 1;
      row.bounds = Bounds<double>::rest_of_disc(0.5, 1 - i);
      problem.rows.push_back(row);
    }
    problem.blocks = {{0, 2}};
    problem.impulse = {0, 0};
    SequentialImpulse<double>({.iterations = 100}).solve(problem);
    CHECK(problem.impulse == PerRow<double>{-0.5, 0});
    CHECK(residual(problem, 1.0).energy == 0);
  }
}

TEST_CASE("the rest of a disc is what Pythagoras leaves, and nothing beyond its rim") {
  const Bounds<double> rest = Bounds<double>::rest_of_disc(5, 0);
  CHECK(rest.is_friction());
  CHECK_FALSE(rest.is_equality());
  CHECK(rest.clamp(9, {3}) == 4);
  CHECK(rest.clamp(-9, {-3}) == -4);
  CHECK(rest.clamp(1, {3}) == 1);
  CHECK(rest.clamp(9, {0}) == 5);
  CHECK(rest.clamp(9, {7}) == 0);
  CHECK(std::isnan(rest.clamp(std::nan(""), {3})));
}

TEST_CASE("friction on one body, nowhere, or of no strength is refused") {
  CHECK(refusal_of<FrictionJoint>({.a = {1}, .b = {1}, .max_force = 1}) ==
        "FrictionJoint: b must be another body than a, got 1");
  CHECK(refusal_of<FrictionJoint>({.b = {1}, .anchor = Vec2<double>(0, std::nan("")), .max_force = 1}) ==
        "FrictionJoint: anchor must be finite numbers of m, got (0, nan)");
  CHECK(refusal_of<FrictionJoint>({.b = {1}, .max_force = -1}) ==
        "FrictionJoint: max_force must be a finite number >= 0 N, got -1");
  CHECK(refusal_of<FrictionJoint>({.b = {1}, .max_torque = std::nan("")}) ==
        "FrictionJoint: max_torque must be a finite number >= 0 N m, got nan");
  CHECK(refusal_of<FrictionJoint>({.b = {1}}) ==
        "FrictionJoint: max_force must be > 0 N where max_torque is 0 N m, got 0");
}
