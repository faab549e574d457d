// The step: the same bits for the same world, a copy that goes its own way, and a report that hides nothing.
#include "solvers/solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A bit of everything: boxes that fall on each other, a ball that bounces, a bar on a pin, a ball on a rod.
Scene busy_scene(const SceneSettings& settings = {}) {
  Scene scene(settings);
  scene.add_ground();
  for (int i = 0; i < 4; ++i) {
    scene.add({.shapes = {box(1, 0.8)},
               .position = {0.2 * i, 1 + 1.1 * i},
               .angle = 0.3 * i,
               .damping = {.linear = 0.1}});
  }
  scene.add({.shapes = {circle(0.3)}, .position = {0.4, 7}, .material = {.restitution = 0.7}});
  const BodyId bar = scene.add({.shapes = {capsule({-1, 0}, {1, 0}, 0.1)}, .position = {2.5, 2}});
  const BodyId ball = scene.add({.shapes = {circle(0.4)}, .position = {-3, 2}, .velocity = {4, 0}});
  scene.join<RevoluteJoint>({.a = ground, .b = bar, .anchor = {3, 2}});
  scene.join<DistanceJoint>({.a = ground, .b = ball, .anchor_a = {-1, 6}, .anchor_b = {-3, 2}});
  return scene;
}

/// Keeps the first problem of a step, as it was given, and leaves it to another solver.
template <Scalar Real>
class Eavesdropper final : public Solver<Real> {
 public:
  std::string name() const override { return "eavesdropper"; }
  SolveReport solve(VelocityProblem<Real>& problem, SolveObserver<Real>* observer) override {
    if (!heard) heard = problem;
    return solver_.solve(problem, observer);
  }
  std::optional<VelocityProblem<Real>> heard = {};

 private:
  SequentialImpulse<Real> solver_;
};

}  // namespace

TEST_CASE_TEMPLATE("two runs of one scene give the same bits", Real, float, double) {
  for (const SolverMaker<Real>& make : all_solvers<Real>()) {
    World<Real> first(busy_scene()), second(busy_scene());
    const auto solver = make({}), other_solver = make({});
    for (int step = 0; step < 100; ++step) {
      first.step(*solver);
      second.step(*other_solver);
    }
    CHECK(first.last_step().problem.row_count() > 10);
    CHECK(same_state(first, second));
  }
}

TEST_CASE_TEMPLATE("a copy of a world steps as the original does, and neither disturbs the other", Real,
                   float, double) {
  World<Real> world = world_after<Real>(busy_scene(), 60), twin = world;
  const World<Real> before = world;
  take_steps(twin, 60);
  CHECK(same_state(world, before));
  take_steps(world, 60);
  CHECK(same_state(world, twin));
}

TEST_CASE_TEMPLATE("velocity_problem is what the next step hands to its solver, and asking changes nothing",
                   Real, float, double) {
  World<Real> world(busy_scene({}));
  Eavesdropper<Real> solver;
  for (int step = 0; step < 80; ++step) {
    const World<Real> before = world;
    const VelocityProblem<Real> foreseen = world.velocity_problem();
    CHECK(same_state(world, before));
    solver.heard.reset();
    world.step(solver);
    check_same_problem(foreseen, *solver.heard);
  }
}

TEST_CASE("a step reports its rows, contact points and sweeps, and counts time") {
  Scene scene({.dt = 0.125});
  scene.add_ground({.material = {.friction = 0.5}});
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .material = {.friction = 0.5}});
  World world(scene);
  SequentialImpulse<double> solver({.iterations = 7});
  const StepReport report = world.step(solver);
  CHECK(report.contacts == 2);
  CHECK(report.rows == 4);  // with friction
  CHECK(report.solve.iterations == 7);
  CHECK_FALSE(report.not_finite.has_value());
  world.set_dt(0.25);
  world.step(solver);
  CHECK(world.clock().time == 0.375);
  CHECK(world.clock().steps == 2);
}

TEST_CASE("a step names the first body that is not finite any more, and does not throw") {
  Scene scene({.gravity = {0, 0}, .dt = 1});
  const double huge = std::numeric_limits<double>::max();
  scene.add({.shapes = {circle(1)}, .position = {5, 0}});
  const BodyId runaway = scene.add({.position = {0, 0.75 * huge}, .mass = 1, .fixed_rotation = true});
  const BodyId other = scene.add({.position = {0.75 * huge, 0}, .mass = 1, .fixed_rotation = true});
  World world(scene);
  CHECK_FALSE(take_steps(world, 1).not_finite.has_value());
  world.set_velocity(runaway, {0, 0.75 * huge, 0});
  world.set_velocity(other, {0.75 * huge, 0, 0});
  CHECK(take_steps(world, 1).not_finite == runaway);
}

TEST_CASE("bodies joined by a joint do not collide with each other, but with everything else") {
  Scene scene;
  scene.add_ground();
  const BodyId lower = scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
  const BodyId upper = scene.add({.shapes = {box(1, 1)}, .position = {0, 1.25}});
  scene.join<RevoluteJoint>({.a = lower, .b = upper, .anchor = {0, 1}});
  World<double> world = world_after(scene, 1);
  const Snapshot now = snapshot(world);
  CHECK(now.contacts.size() == 2);
  for (const SnapshotContact& contact : now.contacts)
    CHECK(std::minmax(contact.a, contact.b).first == ground);
}

TEST_CASE("without warm starting every step begins from no impulses") {
  for (const bool warm : {true, false}) {
    Scene scene({.warm_start = warm});
    scene.add_ground();
    scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}});
    World<double> world = world_after(scene, 1);
    for (const double impulse : world.velocity_problem().impulse) {
      if (!warm) CHECK(impulse == 0);
    }
    CHECK((world.velocity_problem().impulse[0] > 0) == warm);
  }
}

TEST_CASE("a snapshot shows impulses where they act: a hanging ball pulls its rod with its weight") {
  Scene scene;
  const BodyId ball = scene.add({.shapes = {circle(0.5)}, .position = {0, -2}, .mass = 3});
  scene.join<DistanceJoint>({.a = ground, .b = ball, .anchor_a = {0, 0}, .anchor_b = {0, -2}});
  World<double> world = world_after(scene, 1);
  const Snapshot now = snapshot(world);
  REQUIRE(now.joints.size() == 1);
  CHECK(now.joints[0].name == "rod");
  CHECK(now.joints[0].impulse.x() == doctest::Approx(0));
  CHECK(now.joints[0].impulse.y() / now.dt == doctest::Approx(3 * 10));  // [N], on the ball
  CHECK(now.joints[0].anchor_b.y() == doctest::Approx(-2));
}
