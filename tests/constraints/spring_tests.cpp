// Springs and ropes: two ways to say how stiff, extremes, slack, and what is refused.
#include "joint_worlds.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

using Kind = DistanceJoint::Kind;

const double rest_length = 2;  // [m]
const double bob_mass = 3;     // [kg]

/// A bob under the origin on a joint of rest_length, longer by `stretch` than that.
Scene hanging_bob(Kind kind, const std::optional<Softness>& softness, double stretch, double gravity,
                  double dt) {
  Scene scene({.gravity = {0, -gravity}, .dt = dt});
  const BodyId bob = scene.add(disc({0, -rest_length - stretch}, bob_mass));
  samples::hang(scene, bob, {0, 0}, {.length = rest_length, .kind = kind, .softness = softness});
  return scene;
}

/// How much longer than rest_length the joint is.
template <Scalar Real>
Real stretch_of(const World<Real>& world) {
  return world.bodies().pose[{1}].position.norm() - static_cast<Real>(rest_length);
}

template <Scalar Real>
Real tension(const World<Real>& world) {
  const VelocityProblem<Real>& problem = world.last_step().problem;
  return problem.rows.empty() ? Real(0) : std::abs(problem.impulse[0]) / problem.dt;
}

}  // namespace

// A19
TEST_CASE(
    "a spring of stiffness k and damping c is one of frequency sqrt(k / m) / 2 pi and ratio c / 2 sqrt(k "
    "m)") {
  const double stiffness = 120, damping = 7;
  const SwingSoftness swing{.frequency = std::sqrt(stiffness / bob_mass) / (2 * pi),
                            .damping_ratio = damping / (2 * std::sqrt(stiffness * bob_mass))};
  World by_constants(hanging_bob(Kind::spring, SpringSoftness{.stiffness = stiffness, .damping = damping},
                                 0.25, joint_gravity, joint_dt));
  World by_swing(hanging_bob(Kind::spring, swing, 0.25, joint_gravity, joint_dt));
  for (int step = 0; step < 100; ++step) {
    step_often(by_constants, 1, 1);
    step_often(by_swing, 1, 1);
    CHECK(std::abs(stretch_of(by_constants) - stretch_of(by_swing)) <= 1e-13);
  }
}

TEST_CASE("a spring between two free bodies swings with its frequency, whatever their masses") {
  // Equal and opposite: the relative motion of the reduced mass is that of one mass on the spring.
  Scene scene({.gravity = {0, 0}});
  const BodyId a = scene.add(disc({0, 0}, 1)), b = scene.add(disc({rest_length + 0.25, 0}, 7));
  DistanceJoint::Spec spring = samples::spring(rest_length, SwingSoftness{.frequency = 2});
  spring.a = a;
  samples::hang(scene, b, {0, 0}, spring);
  World world(scene);
  HandSwing swing{.x = 0.25, .omega = 2 * pi * 2};
  for (int step = 0; step < 10; ++step) {
    step_often(world, 1, 1);
    swing.step(joint_dt);
    const PerBody<Pose<double>>& pose = world.bodies().pose;
    CHECK(pose[{2}].position.x() - pose[{1}].position.x() - rest_length ==
          doctest::Approx(swing.x).epsilon(1e-12));
    CHECK(std::abs(pose[{1}].position.x() + 7 * pose[{2}].position.x() - 7 * (rest_length + 0.25)) <= 1e-13);
  }
}

TEST_CASE(
    "a damper without a spring slows a bob by 1 / (1 + q + q^2 / 2) a step, q = c dt / m, and no more") {
  for (const double damping : {20.0, 2e6}) {
    Scene scene = hanging_bob(Kind::spring, SpringSoftness{.damping = damping}, 0.25, 0, joint_dt);
    World world(scene);
    world.set_velocity({1}, {0, 1, 0});
    const double q = damping * joint_dt / bob_mass;
    for (int step = 1; step <= 20; ++step) {
      step_often(world, 1, 1);
      const double expected = std::pow(1 + q + q * q / 2, -step);
      CHECK(std::abs(world.bodies().velocity[{1}].y() - expected) <= 1e-13 * expected + 1e-16);
    }
  }
}

TEST_CASE("a spring too weak for the number type to tell from none leaves its bob in free fall") {
  World<float> world(
      hanging_bob(Kind::spring, SpringSoftness{.stiffness = 1e-44}, 0.25, joint_gravity, 1e-6));
  step_often(world, 1, 5);
  CHECK(world.bodies().velocity[{1}].y() == doctest::Approx(-joint_gravity * 1e-6));
}

TEST_CASE("a slack rope gives no force: its bob falls freely until it is taut, and then hangs") {
  World world(hanging_bob(Kind::rope, {}, -1, joint_gravity, joint_dt));  // 1 m of slack
  SequentialImpulse<double> solver({.iterations = 1});
  double stretch = -1, speed = 0;
  for (int step = 0; step < 60; ++step) {
    world.step(solver);
    const double before = stretch;
    speed += joint_gravity * joint_dt;
    if (stretch + speed * joint_dt > 0) speed = -stretch / joint_dt;  // the room that is left
    stretch += speed * joint_dt;
    CHECK(std::abs(stretch_of(world) - stretch) <= 64 * 2.3e-16 * (step + 1));
    if (stretch < 0) CHECK(tension(world) == 0);
    if (before < -0.5) CHECK(world.last_step().problem.rows.empty());  // no row beyond slack_margin
  }
  CHECK(std::abs(stretch) <= 1e-13);
  CHECK(tension(world) == doctest::Approx(bob_mass * joint_gravity).epsilon(1e-9));
}

TEST_CASE("a rope never pushes: a bob that is thrown inwards flies as if there were no rope") {
  World world(hanging_bob(Kind::rope, {}, 0, 0, joint_dt));
  world.set_velocity({1}, {0, 1, 0});
  step_often(world, 30, 5);
  CHECK(world.bodies().velocity[{1}].y() == 1);
  CHECK(stretch_of(world) == doctest::Approx(-30 * joint_dt));
}

TEST_CASE("a taut rope pulls with m (g + v^2 / r) at the bottom of a swing, to first order in dt") {
  // Let go from the side: v^2 = 2 g r at the bottom, which makes 3 m g.
  const auto error = [](double frequency) {
    Scene scene({.dt = 1 / frequency});
    const BodyId bob = scene.add(disc({rest_length, 0}, bob_mass));
    scene.join<DistanceJoint>(
        {.a = ground, .b = bob, .anchor_a = {0, 0}, .anchor_b = {rest_length, 0}, .kind = Kind::rope});
    World world(scene);
    double largest = 0;
    while (world.bodies().pose[{1}].position.x() > 0) {
      step_often(world, 1, 1);
      largest = std::max(largest, tension(world));
    }
    return std::abs(largest / (3 * bob_mass * joint_gravity) - 1);
  };
  // The rope turns by w dt in a step, w^2 = 2 g / r.
  const double omega = std::sqrt(2 * joint_gravity / rest_length);
  for (const double frequency : {240.0, 960.0, 3840.0}) CHECK(error(frequency) <= 1.5 * omega / frequency);
}

TEST_CASE("a rubber rope hangs m g / k longer than it is, and is slack above its length") {
  const double stiffness = 150;
  const Softness rubber = SpringSoftness{.stiffness = stiffness, .damping = 20};
  World world(hanging_bob(Kind::rope, rubber, 0, joint_gravity, joint_dt));
  step_often(world, 1200, 1);
  CHECK(stretch_of(world) == doctest::Approx(bob_mass * joint_gravity / stiffness).epsilon(1e-9));
  CHECK(snapshot(world).joints[0].drift == 0);  // that is what it is for
  World slack(hanging_bob(Kind::rope, rubber, -0.25, joint_gravity, joint_dt));
  step_often(slack, 5, 1);
  CHECK(tension(slack) == 0);
  CHECK(slack.bodies().velocity[{1}].y() == doctest::Approx(-joint_gravity * 5 * joint_dt).epsilon(1e-13));
}

TEST_CASE("a distance joint says of which kind it is") {
  const DistanceJoint::Spec rod{.a = {0}, .b = {1}, .length = 1};
  DistanceJoint::Spec rope = rod, spring = rod;
  rope.kind = Kind::rope;
  spring.kind = Kind::spring;
  spring.softness = SwingSoftness{};
  CHECK(DistanceJoint(rod, two_at_origin).name() == "rod");
  CHECK(DistanceJoint(rope, two_at_origin).name() == "rope");
  CHECK(DistanceJoint(spring, two_at_origin).name() == "spring");
}

TEST_CASE("springs and ropes are refused by name when they cannot be") {
  const auto refused = [](Kind kind, const std::optional<Softness>& softness, double slack_margin = 0) {
    return refusal_of<DistanceJoint>(
        {.b = {1}, .length = 1, .kind = kind, .softness = softness, .slack_margin = slack_margin});
  };
  const auto swing = [&](double frequency, double ratio) {
    return refused(Kind::spring, SwingSoftness{.frequency = frequency, .damping_ratio = ratio});
  };
  const auto constants = [&](double stiffness, double damping) {
    return refused(Kind::spring, SpringSoftness{.stiffness = stiffness, .damping = damping});
  };
  const std::string place = "DistanceJoint: softness ";
  const double inf = std::numeric_limits<double>::infinity(), nan = std::nan("");
  CHECK(refused(Kind::rod, SwingSoftness{}) == place + "must be left out for a rod, got one");
  CHECK(refused(Kind::spring, {}) == place + "must be given for a spring, got none");
  CHECK(refused(Kind::rope, SwingSoftness{}) == "");
  CHECK(refused(Kind::rope, {}, -1) == "DistanceJoint: slack_margin must be a finite number >= 0 m, got -1");
  CHECK(refused(Kind::rope, {}, inf) ==
        "DistanceJoint: slack_margin must be a finite number >= 0 m, got inf");
  CHECK(swing(0, 0) == place + "frequency must be from 1e-6 to 1e6 Hz, got 0");
  CHECK(swing(nan, 0) == place + "frequency must be from 1e-6 to 1e6 Hz, got nan");
  CHECK(swing(inf, 0) == place + "frequency must be from 1e-6 to 1e6 Hz, got inf");
  CHECK(swing(1, -1) == place + "damping_ratio must be from 0 to 1e30, got -1");
  CHECK(constants(-1, 0) == place + "stiffness must be from 0 to 1e30 N/m, got -1");
  CHECK(constants(1, nan) == place + "damping must be from 0 to 1e30 N s/m, got nan");
  CHECK(constants(0, 0) == place + "stiffness must be > 0 N/m where damping is 0 N s/m, got 0");
}
