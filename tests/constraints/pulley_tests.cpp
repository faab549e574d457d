// Ropes over rollers: one body held twice, a roller that hangs from a rope, and the agreement of solvers.
#include "solvers/solver_list.hpp"
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr double roller_height = 5;  // [m]

/// A body of this mass that hangs under a roller at x, and the end of the rope that holds it.
PulleyJoint::End hanging_end(Scene& scene, double x, double mass) {
  const BodyId body = scene.add(disc({x, 0}, mass));
  return {.body = body, .anchor = {x, 0}, .roller = {x, roller_height}};
}

struct CompoundMasses {
  double left = 9;     // [kg] of the body on the other side of the fixed roller
  double carrier = 2;  // [kg] of the moving roller
  double near = 1;     // [kg] of the two bodies that hang from it
  double far = 3;
};

/// A body and a moving roller on a rope over a fixed one, and two bodies on a rope over the moving roller.
/// Bodies 1 to 4 as in CompoundMasses.
Scene compound_scene(const CompoundMasses& masses) {
  Scene scene;
  const PulleyJoint::End left = hanging_end(scene, -2, masses.left);
  const PulleyJoint::End moving = hanging_end(scene, 2, masses.carrier);
  const BodyId near = scene.add(disc({1, -4}, masses.near)), far = scene.add(disc({3, -4}, masses.far));
  scene.join<PulleyJoint>({.ends = {left, moving}});
  scene.join<PulleyJoint>(
      {.ends = {{.body = near, .anchor = {1, -4}, .roller = {1, 0}, .carrier = moving.body},
                {.body = far, .anchor = {3, -4}, .roller = {3, 0}, .carrier = moving.body}}});
  return scene;
}

}  // namespace

TEST_CASE("a rope that holds one body at two places pulls it as two parts of rope do") {
  Scene scene;
  const BodyId light = scene.add(disc({0, 0}, 1)), held = scene.add(disc({3, 0}, 2));
  scene.join<PulleyJoint>({.ends = {{.body = light, .anchor = {0, 0}, .roller = {0, 5}},
                                    {.body = held, .anchor = {2.5, 0}, .roller = {2.5, 5}},
                                    {.body = held, .anchor = {3.5, 0}, .roller = {3.5, 5}}}});
  World world(scene);
  step_often(world, 1, 1);
  // T (1 + 2 * 2 / 2) = (1 + 2) g, as both accelerations are r_i T / m_i - g and sum r_i a_i = 0.
  const double tension = joint_gravity;
  CHECK(joint_impulse(world, JointPart::x) / joint_dt == doctest::Approx(tension).epsilon(1e-14));
  CHECK(world.bodies().velocity[{2}].z() == 0);  // the two torques cancel
}

TEST_CASE("two bodies on a roller that hangs from a rope itself weigh as much as 4 m1 m2 / (m1 + m2)") {
  const CompoundMasses masses;
  World world(compound_scene(masses));
  const int steps = 20;
  step_often(world, steps, 300);
  // The roller goes up with A, and in its frame gravity is g + A: its rope pulls with 2 m1 m2 / (m1 + m2)
  // times that, on both sides.
  const double hung = 4 * masses.near * masses.far / (masses.near + masses.far);
  const double up =
      (masses.left - masses.carrier - hung) * joint_gravity / (masses.left + masses.carrier + hung);
  const double apart = (masses.far - masses.near) / (masses.far + masses.near) * (joint_gravity + up);
  const double time = steps * joint_dt;
  CHECK(world.bodies().velocity[{1}].y() == doctest::Approx(-up * time).epsilon(1e-9));
  CHECK(world.bodies().velocity[{2}].y() == doctest::Approx(up * time).epsilon(1e-9));
  CHECK(world.bodies().velocity[{3}].y() == doctest::Approx((up + apart) * time).epsilon(1e-9));
  CHECK(world.bodies().velocity[{4}].y() == doctest::Approx((up - apart) * time).epsilon(1e-9));
}

TEST_CASE("all solvers agree on a scene with a pulley of three bodies") {
  World world(compound_scene({}));
  step_often(world, 5);
  VelocityProblem<double> start = world.velocity_problem();
  REQUIRE(start.extra_terms.size() == 1);
  start.impulse.assign(start.impulse.size(), 0);
  for (const int sweeps : {1, 4, 2000}) {
    VelocityProblem<double> expected = start;
    SequentialImpulse<double>({.iterations = sweeps}).solve(expected);
    // Those that go their own way meet the others at the answer.
    const Iterates which = sweeps == 2000 ? Iterates::any : Iterates::of_gauss_seidel;
    for (const SolverMaker<double>& make : all_solvers<double>(which)) {
      VelocityProblem<double> problem = start;
      make({.iterations = sweeps})->solve(problem);
      for (const BodyId body : problem.velocity.indices()) {
        CHECK((problem.velocity[body] - expected.velocity[body]).norm() <= 1e-12);
      }
    }
  }
}
