// Ropes over rollers: what they pull with, how bodies on them move, and where they are slack or refused.
#include "../solvers/solver_list.hpp"
#include "constraints/pulley_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "joint_worlds.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

using Roller = PulleyJoint::Roller;

constexpr double roller_height = 5;  // [m]

/// A body of this mass that hangs under a roller at x, and the end of the rope that holds it.
PulleyJoint::End hanging_end(Scene& scene, double x, double mass, double parts = 1) {
  const BodyId body = scene.add(disc({x, 0}, mass));
  return {.body = body, .anchor = {x, 0}, .roller = {x, roller_height}, .parts = parts};
}

/// T of one rope on hanging bodies: sum r_i g / sum r_i^2 / m_i, as all accelerations are T r_i / m_i - g and
/// sum r_i a_i is 0.
double rope_tension(const std::vector<double>& parts, const std::vector<double>& masses) {
  double sum = 0, inverse = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    sum += parts[i];
    inverse += parts[i] * parts[i] / masses[i];
  }
  return sum * joint_gravity / inverse;
}

Scene rope_scene(const std::vector<double>& parts, const std::vector<double>& masses,
                 PulleyJoint::Kind kind = PulleyJoint::Kind::rope) {
  Scene scene;
  PulleyJoint::Spec rope{.kind = kind};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    rope.ends.push_back(hanging_end(scene, 2 * static_cast<double>(i), masses[i], parts[i]));
  }
  scene.join<PulleyJoint>(rope);
  return scene;
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

// A17
TEST_CASE_TEMPLATE("a rope joint on 2, 3 or 4 bodies pulls with sum r_i g / sum r_i^2 / m_i after one sweep",
                   Real, float, double, long double) {
  struct Case {
    std::vector<double> parts;
    std::vector<double> masses;
  };
  const std::vector<Case> cases = {{{1, 1}, {2, 1}}, {{1, 2, 1}, {1, 2, 3}}, {{1, 2, 2, 1}, {3, 1, 2, 5}}};
  for (const Case& rope : cases) {
    World<Real> world(rope_scene(rope.parts, rope.masses));
    REQUIRE(joint_row_count(world) == 1);
    step_often(world, 1, 1);
    const double tension = static_cast<double>(joint_impulse(world, JointPart::x)) / joint_dt;
    // One row, solved by one sweep: the rounding of a few operations; long double keeps g in double.
    const double epsilon = std::max(static_cast<double>(std::numeric_limits<Real>::epsilon()),
                                    std::numeric_limits<double>::epsilon());
    const double expected = rope_tension(rope.parts, rope.masses);
    CHECK(std::abs(tension - expected) <= 16 * epsilon * expected);
  }
  CHECK(rope_tension({1, 1}, {2, 1}) == doctest::Approx(40.0 / 3).epsilon(1e-15));
  CHECK(rope_tension({1, 2, 1}, {1, 2, 3}) == doctest::Approx(12).epsilon(1e-15));
}

// B18
TEST_CASE("the masses of an Atwood machine accelerate with (m1 - m2) g / (m1 + m2)") {
  for (const PulleyJoint::Kind kind : {PulleyJoint::Kind::rope, PulleyJoint::Kind::taut}) {
    World world(rope_scene({1, 1}, {2, 1}, kind));
    step_often(world, 30, 2);
    const double speed = (2 - 1) * joint_gravity / (2 + 1) * 30 * joint_dt;
    CHECK(world.bodies().velocity[1].y() == doctest::Approx(-speed).epsilon(1e-9));  // 1e-9: as of a long run
    CHECK(world.bodies().velocity[2].y() == doctest::Approx(speed).epsilon(1e-9));
  }
}

TEST_CASE("a block and tackle with r parts balances r times the mass, and else falls as its ratio says") {
  for (const double ratio : {2.0, 3.0, 5.0}) {
    World balanced(rope_scene({1, ratio}, {1.5, 1.5 * ratio}));
    World falling(rope_scene({1, ratio}, {1.5, 4 * ratio}));
    step_often(balanced, 30, 2);
    step_often(falling, 20, 2);
    // A body at rest: the rounding of g dt, some 0.2 m/s, in each of 30 steps.
    for (const Vec3<double>& velocity : balanced.bodies().velocity) CHECK(velocity.norm() <= 1e-13);
    const double tension = rope_tension({1, ratio}, {1.5, 4 * ratio});
    const double time = 20 * joint_dt;
    CHECK(falling.bodies().velocity[1].y() ==
          doctest::Approx((tension / 1.5 - joint_gravity) * time).epsilon(1e-9));
    CHECK(falling.bodies().velocity[2].y() ==
          doctest::Approx((ratio * tension / (4 * ratio) - joint_gravity) * time).epsilon(1e-9));
  }
}

TEST_CASE("a rope that holds one body at two places pulls it as two parts of rope do") {
  Scene scene;
  const BodyId light = scene.add(disc({0, 0}, 1)), held = scene.add(disc({3, 0}, 2));
  scene.join<PulleyJoint>({.ends = {{.body = light, .anchor = {0, 0}, .roller = {0, 5}},
                                    {.body = held, .anchor = {2.5, 0}, .roller = {2.5, 5}},
                                    {.body = held, .anchor = {3.5, 0}, .roller = {3.5, 5}}}});
  World world(scene);
  step_often(world, 1, 1);
  const double tension = rope_tension({1, 2}, {1, 2});
  CHECK(joint_impulse(world, JointPart::x) / joint_dt == doctest::Approx(tension).epsilon(1e-14));
  CHECK(world.bodies().velocity[2].z() == 0);  // the two torques cancel
}

// B18
TEST_CASE("an Atwood machine with a massive wheel accelerates with (m1 - m2) g / (m1 + m2 + M / 2)") {
  const double heavy = 3, light = 1, wheel_mass = 2, radius = 0.5;
  const double wheel_inertia = wheel_mass * radius * radius / 2;
  Scene scene;
  const BodyId wheel = scene.add(disc({0, 5}, wheel_mass, wheel_inertia));
  const BodyId left = scene.add(disc({-radius, 0}, heavy)), right = scene.add(disc({radius, 0}, light));
  scene.join<RevoluteJoint>({.a = ground, .b = wheel, .anchor = {0, 5}});
  const auto side = [&](BodyId body, double x) {
    scene.join<PulleyJoint>(
        {.ends = {
             {.body = body, .anchor = {x, 0}, .roller = {x, 5}, .carrier = wheel, .kind = Roller::drum},
         }});
  };
  side(left, -radius);
  side(right, radius);
  World world(scene);
  const int steps = 20;
  step_often(world, steps, 300);
  const double a = (heavy - light) * joint_gravity / (heavy + light + wheel_mass / 2);
  const double speed = a * steps * joint_dt;
  CHECK(world.bodies().velocity[2].y() == doctest::Approx(-speed).epsilon(1e-9));
  CHECK(world.bodies().velocity[3].y() == doctest::Approx(speed).epsilon(1e-9));
  CHECK(world.bodies().velocity[1].z() == doctest::Approx(speed / radius).epsilon(1e-9));
  // A tension on each side, and the axle carries both and the wheel.
  const double tension_left = heavy * (joint_gravity - a), tension_right = light * (joint_gravity + a);
  const double axle = tension_left + tension_right + wheel_mass * joint_gravity;
  CHECK(joint_impulse(world, JointPart::x, 1) / joint_dt == doctest::Approx(tension_left).epsilon(1e-9));
  CHECK(joint_impulse(world, JointPart::x, 2) / joint_dt == doctest::Approx(tension_right).epsilon(1e-9));
  CHECK(joint_impulse(world, JointPart::y, 0) / joint_dt == doctest::Approx(axle).epsilon(1e-9));
}

// B19
TEST_CASE("a yo-yo falls with 2 g / 3, and its string carries a third of its weight") {
  const double mass = 3, radius = 0.2;
  Scene scene;
  const BodyId spool = scene.add(disc({0, 0}, mass, mass * radius * radius / 2));
  scene.join<PulleyJoint>({.ends = {{.body = ground,
                                     .anchor = {-radius, 1},
                                     .roller = {-radius, 0},
                                     .carrier = spool,
                                     .kind = Roller::drum}}});
  World world(scene);
  step_often(world, 30, 1);
  const double speed = 2 * joint_gravity / 3 * 30 * joint_dt;
  // The rounding of 30 steps.
  CHECK(world.bodies().velocity[1].y() == doctest::Approx(-speed).epsilon(1e-12));
  // The string is on its left and stands still: -speed - w radius = 0.
  CHECK(world.bodies().velocity[1].z() == doctest::Approx(-speed / radius).epsilon(1e-12));
  CHECK(joint_impulse(world, JointPart::x) / joint_dt ==
        doctest::Approx(mass * joint_gravity / 3).epsilon(1e-12));
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
  CHECK(world.bodies().velocity[1].y() == doctest::Approx(-up * time).epsilon(1e-9));
  CHECK(world.bodies().velocity[2].y() == doctest::Approx(up * time).epsilon(1e-9));
  CHECK(world.bodies().velocity[3].y() == doctest::Approx((up + apart) * time).epsilon(1e-9));
  CHECK(world.bodies().velocity[4].y() == doctest::Approx((up - apart) * time).epsilon(1e-9));
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
      for (std::size_t body = 0; body < problem.velocity.size(); ++body) {
        CHECK((problem.velocity[body] - expected.velocity[body]).norm() <= 1e-12);
      }
    }
  }
}
