// What a guarded step keeps of impulses, and what it does not write, ask for or take.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "constraints/distance_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "constraints/weld_joint.hpp"
#include "measure/energy.hpp"
#include "solvers/iterative/block_sequential_impulse.hpp"
#include "solvers/impulse_energy.hpp"
#include "solvers/iterative/sequential_impulse.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

/// One body of 2 kg that falls with 3 m/s, and one row on its speed.
VelocityProblem<double> falling_body(double bias, double softness, double impulse) {
  VelocityProblem<double> problem;
  problem.velocity = {{0, 0, 0}, {0, -3, 0}};
  problem.inverse_mass = {{0, 0, 0}, {0.5, 0.5, 1}};
  problem.rows.push_back(
      {.a = ground, .b = {1}, .jacobian_b = {0, 1, 0}, .bias = bias, .softness = softness});
  problem.impulse = {impulse};
  return problem;
}

/// A box that has come to rest on the ground.
World<double> box_at_rest(bool watches) {
  Scene scene({.guarded = watches});
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 50});
  for (int step = 0; step < 60; ++step) world.step(solver);
  return world;
}

/// Gives every row an impulse that is no number: 0 times it is none for the ground either.
class NoNumberSolver final : public Solver<double> {
 public:
  std::string name() const override { return "no number"; }
  SolveReport solve(VelocityProblem<double>& problem, SolveObserver<double>*) override {
    for (double& impulse : problem.impulse) impulse = std::nan("");
    apply_impulses(problem);
    return {};
  }
};

}  // namespace

TEST_CASE("of impulses to begin from the share is kept that makes their energy least") {
  EnergyMemory<double> memory;
  // D = p^2 (1 / m + softness) / 2 - p (3 + bias): least at p = (3 + bias) / (1 / m + softness) = 4.
  VelocityProblem<double> problem = falling_body(0.25, 0.3125, 16);
  CHECK(limit_warm_start(problem, memory) == doctest::Approx(0.25).epsilon(1e-15));
  CHECK(problem.impulse[0] == doctest::Approx(4).epsilon(1e-15));
  CHECK(problem.velocity[{1}].y() == -3);  // a warm start is given by the solver
  problem.impulse = {2};                   // too little is no harm
  CHECK(limit_warm_start(problem, memory) == 1);
  CHECK(problem.impulse[0] == 2);
  problem.impulse = {-2};  // the wrong way round
  CHECK(limit_warm_start(problem, memory) == 0);
  CHECK(problem.impulse[0] == 0);

  // A contact is to stop the body with 6 N s; what it asks for beyond that pushes it out.
  problem = falling_body(5, 0, 16);
  problem.rows[0].bounds = Bounds<double>::unilateral();
  CHECK(limit_warm_start(problem, memory) == doctest::Approx(6.0 / 16).epsilon(1e-15));
  problem.impulse = {std::numeric_limits<double>::quiet_NaN()};
  CHECK(limit_warm_start(problem, memory) == 1);  // the step will report it
}

TEST_CASE("of what a solve has found the share is kept at which its rows do not work") {
  EnergyMemory<double> memory;
  VelocityProblem<double> problem = falling_body(0.25, 0.3125, 16);
  apply_impulses(problem);
  CHECK(problem.velocity[{1}].y() == 5);
  CHECK(limit_solved(problem, memory) == doctest::Approx(0.25).epsilon(1e-15));
  CHECK(problem.impulse[0] == doctest::Approx(4).epsilon(1e-15));
  CHECK(problem.velocity[{1}].y() == doctest::Approx(-1).epsilon(1e-15));  // -3 + 4 / 2
  CHECK(limit_solved(problem, memory) == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE("impulses that hold a box at rest are kept, and dropped once it leaves the ground by itself") {
  SequentialImpulse<double> no_sweeps({.iterations = 0});
  const double dt = 1.0 / 60, gravity = 10;
  World<double> resting = box_at_rest(true);
  CHECK(resting.step(no_sweeps).warm_share == doctest::Approx(1).epsilon(1e-6));
  CHECK(std::abs(resting.bodies().velocity[{1}].y()) < 1e-6);  // what 60 steps of 50 sweeps have left

  // Thrown up with 1 m/s, it needs no impulse; the last one, m g dt, would make it faster by g dt.
  for (const bool watches : {false, true}) {
    World<double> world = box_at_rest(watches);
    world.set_velocity({1}, {0, 1, 0});
    const StepReport report = world.step(no_sweeps);
    CHECK(report.warm_share == (watches ? 0 : 1));
    const double expected = watches ? 1 - gravity * dt : 1;
    CHECK(world.bodies().velocity[{1}].y() == doctest::Approx(expected).epsilon(1e-6));
  }
}

TEST_CASE("a box that rebounds from a wall after too few sweeps gains no energy where it is guarded") {
  for (const bool watches : {false, true}) {
    Scene scene({.gravity = {0, 0}, .guarded = watches});
    scene.add({.type = BodyType::static_body, .shapes = {box(0.1, 4)}});
    scene.add({.shapes = {box(0.2, 0.2)},
               .position = {-1.6, 0.1},
               .velocity = {100, 0},
               .restitution = 1,
               .fast = true});
    World<double> world(scene);
    BlockSequentialImpulse<double> solver({.iterations = 10});
    const double before = kinetic_energy(snapshot(world));
    const StepReport report = world.step(solver);
    const double gain = kinetic_energy(snapshot(world)) / before - 1;
    CHECK(report.contacts == 2);
    if (watches) CHECK(gain < 64 * std::numeric_limits<double>::epsilon());
    if (!watches) CHECK(gain > 0.01);  // else there was nothing to guard against
    CHECK((report.solved_share < 1) == watches);
  }
}

TEST_CASE("a guarded joint that has come apart by metres asks for a quarter of its body a step, times beta") {
  for (const bool watches : {false, true}) {
    Scene scene(
        {.gravity = {0, 0}, .stabilization = {.policy = StabilizationPolicy::baumgarte}, .guarded = watches});
    const BodyId ball = scene.add({.shapes = {circle(0.2)}});
    scene.join<RevoluteJoint>({.a = ground, .b = ball, .anchor = {0, 0}});
    scene.displace(ball, {5, 0});
    World<double> world(scene);
    SequentialImpulse<double> solver;
    world.step(solver);
    // beta C / dt, with C = 5 m, or a quarter of 0.4 m.
    const double expected = -0.2 * (watches ? 0.1 : 5) * 60;
    CHECK(world.bodies().velocity[{1}].x() == doctest::Approx(expected).epsilon(1e-12));
  }
}

TEST_CASE("a spring that is stretched by metres has not failed: guarded, it pulls as it does alone") {
  const auto after_a_step = [](bool watches) {
    Scene scene({.gravity = {0, 0}, .guarded = watches});
    const BodyId ball = scene.add({.shapes = {circle(0.2)}, .mass = 1});
    scene.join<DistanceJoint>({.a = ground,
                               .b = ball,
                               .anchor_a = {-5, 0},
                               .length = 1,
                               .kind = DistanceJoint::Kind::spring,
                               .softness = SpringSoftness{.stiffness = 10, .damping = 0}});
    World<double> world(scene);
    SequentialImpulse<double> solver;
    CHECK(world.step(solver).solved_share == doctest::Approx(1).epsilon(1e-14));
    return world.bodies().velocity[{1}].x();
  };
  CHECK(after_a_step(false) < 0);
  CHECK(after_a_step(true) == doctest::Approx(after_a_step(false)).epsilon(1e-14));
}

TEST_CASE("what guards take from a solve that fails changes no bit of what it does not touch") {
  const auto pendulum_beside = [](int links) {
    Scene scene({.stabilization = {.policy = StabilizationPolicy::baumgarte}, .guarded = true});
    scene.add_ground({.height = -30});
    const BodyId bob = scene.add({.shapes = {circle(0.5)}, .position = {1, 0}});
    scene.join<RevoluteJoint>({.a = ground, .b = bob, .anchor = {0, 0}});
    BodyId before = ground;
    for (int i = 0; i < links; ++i) {
      const BodyId link = scene.add({.shapes = {box(1, 0.05)}, .position = {9.5 + i, 0}});
      scene.join<RevoluteJoint>({.a = before, .b = link, .anchor = {9.0 + i, 0}});
      before = link;
    }
    for (int i = 0; i < links; ++i) scene.displace({2 + i}, {0.7 * (i + 1), 0});  // it begins open
    World<double> world(scene);
    SequentialImpulse<double> solver({.iterations = 2});
    double least = 1;
    for (int step = 0; step < 60; ++step) least = std::min(least, world.step(solver).warm_share);
    CHECK((least < 0.5) == (links > 0));
    return world;
  };
  const World<double> alone = pendulum_beside(0), beside = pendulum_beside(20);
  CHECK(alone.bodies().pose[{1}].position == beside.bodies().pose[{1}].position);
  CHECK(alone.bodies().velocity[{1}] == beside.bodies().velocity[{1}]);
}

TEST_CASE("a row for an angle that nothing can turn is not written") {
  for (const bool turns : {true, false}) {
    Scene scene;
    const BodyId body = scene.add({.shapes = {box(1, 1)}, .fixed_rotation = !turns});
    scene.join<WeldJoint>({.a = ground, .b = body, .anchor = {0, 0}});
    World<double> world(scene);
    SequentialImpulse<double> solver;
    CHECK(world.step(solver).rows == (turns ? 3 : 2));
    const VelocityProblem<double>& problem = world.last_step().problem;
    for (const ConstraintRow<double>& row : problem.rows) CHECK(inverse_effective_mass(problem, row) > 0);
    CHECK(problem.blocks[0].count == problem.row_count());
    CHECK(snapshot(world).joints[0].impulse.y() > 0);
  }
}

TEST_CASE("a step that is not done names a body that moves, not the ground that it is joined to") {
  Scene scene;
  const BodyId body = scene.add({.shapes = {circle(1)}, .position = {0, 1}});
  scene.join<RevoluteJoint>({.a = ground, .b = body, .anchor = {0, 0}});
  World<double> world(scene);
  NoNumberSolver solver;
  const StepReport report = world.step(solver);
  CHECK(report.not_finite == body);
  CHECK(world.bodies().velocity[ground] == Vec3<double>(0, 0, 0));
}

TEST_CASE("a shape without a size is refused under its own name") {
  for (const double radius : {std::nan(""), -1.0, 0.0, double(INFINITY)}) {
    Scene scene;
    const Shape<double> bad = Circle<double>{.radius = radius};
    CHECK_THROWS_WITH_AS(scene.add({.type = BodyType::static_body, .shapes = {circle(1), bad}}),
                         doctest::Contains("size of shapes[1] must be > 0 m"), std::invalid_argument);
  }
}

TEST_CASE("springs that would let a body through are refused by name where a scene is guarded") {
  const auto make = [](bool watches, double dt) {
    Scene scene({.dt = dt, .stabilization = {.policy = StabilizationPolicy::soft}, .guarded = watches});
    scene.add({.shapes = {box(1, 1)}});
    return World<double>(scene);
  };
  // g / (2 pi 0.25 / dt)^2 = 0.5 m at dt = 0.351 s.
  CHECK_NOTHROW(make(true, 0.35));
  CHECK_NOTHROW(make(false, 0.352));
  CHECK_THROWS_WITH_AS(make(true, 0.352), doctest::Contains("stabilization.soft must be stiffer"),
                       std::invalid_argument);
}

TEST_CASE("the springs of a pin carry the mass that hangs on it, however little inertia there is") {
  const double dt = 1.0 / 60, omega = 2 * pi * 15;  // a quarter of the steps
  for (const double inertia : {1.0, 1e-6}) {
    Scene scene({.stabilization = {.policy = StabilizationPolicy::soft}});
    const BodyId body = scene.add({.position = {0.6, -0.8}, .mass = 2, .inertia = inertia});
    scene.join<RevoluteJoint>({.a = ground, .b = body, .anchor = {0, 0}});
    World<double> world(scene);
    for (const ConstraintRow<double>& row : world.velocity_problem().rows) {
      // 1 / (h (c + h k)) with k = m omega^2 and c = 2 zeta m omega, zeta = 5.
      const double expected = 1 / (dt * 2 * omega * (10 + dt * omega));
      CHECK(row.softness == doctest::Approx(expected).epsilon(1e-12));
    }
  }
}
