// What a step refuses, leaves unwritten, or names.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

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

TEST_CASE("a row for an angle that nothing can turn is not written") {
  for (const bool turns : {true, false}) {
    Scene scene;
    const BodyId body = scene.add({.shapes = {box(1, 1)}, .fixed_rotation = !turns});
    scene.join<WeldJoint>({.a = ground, .b = body, .anchor = {0, 0}});
    World<double> world(scene);
    CHECK(take_steps(world, 1).rows == (turns ? 3 : 2));
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

TEST_CASE("springs that would let a body through are refused by name") {
  const auto make = [](double dt) {
    Scene scene({.dt = dt, .stabilization = {.policy = StabilizationPolicy::soft}});
    scene.add_ground();
    scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
    return World<double>(scene);
  };
  // g / (2 pi 0.25 / dt)^2 = 0.5 m at dt = 0.351 s.
  CHECK_NOTHROW(make(0.35));
  CHECK_THROWS_WITH_AS(make(0.352), doctest::Contains("stabilization.soft must be stiffer"),
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
