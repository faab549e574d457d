// What becomes of an overlap under each policy: the table of the pop, each line against its formula.
#include <cairn/samples/samples.hpp>
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double pop_depth = 0.1;     // [m]
const double pop_dt = 1.0 / 256;  // [s], exact in binary
const double pop_gravity = 10;    // [m/s^2]
const double pop_radius = 0.5;    // [m]
const double uncapped = std::numeric_limits<double>::infinity();
const double pop_rounding = 1e-13;  // [m] a few hundred steps, each with a rounding of 1e-16 m

/// A ball that begins so deep in the ground, at rest, without slop and friction.
World<double> sunken_ball(const Stabilization& stabilization, int substeps = 1) {
  Scene scene(
      {.gravity = {0, -pop_gravity}, .dt = pop_dt, .substeps = substeps, .stabilization = stabilization});
  scene.add_ground({.material = {.friction = 0}});
  scene.add({.shapes = {circle(pop_radius)}, .position = {0, pop_radius - pop_depth}, .mass = 1});
  return World(scene);
}

struct PopPath {
  List<double> room = {};    // [m] above the ground, after every step; negative in overlap
  List<double> speed = {};   // [m/s] upwards
  double apex = -pop_depth;  // [m]
};

PopPath watch_pop(const Stabilization& stabilization, int steps, int substeps = 1) {
  World<double> world = sunken_ball(stabilization, substeps);
  SequentialImpulse<double> solver;
  PopPath path;
  for (int step = 0; step < steps; ++step) {
    world.step(solver);
    path.room.push_back(world.bodies().pose[{1}].position.y() - pop_radius);
    path.speed.push_back(world.bodies().velocity[{1}].y());
    path.apex = std::max(path.apex, path.room.back());
  }
  return path;
}

}  // namespace

TEST_CASE("without stabilization an overlap stays as it is, and gains no speed") {
  const PopPath path = watch_pop({.policy = StabilizationPolicy::none, .slop = 0}, 256);
  for (int i = 0; i < path.room.size(); ++i) {
    CHECK(std::abs(path.room[i] + pop_depth) <= pop_rounding);
    CHECK(std::abs(path.speed[i]) <= pop_rounding);
  }
}

TEST_CASE("Baumgarte throws an overlap out at beta d / dt, up to (beta d / dt)^2 / 2g - d above rest") {
  const PopPath path =
      watch_pop({.policy = StabilizationPolicy::baumgarte, .slop = 0, .max_speed = uncapped}, 512);
  const double speed = 0.2 * pop_depth / pop_dt;  // 5.12 m/s
  CHECK(std::abs(path.speed[0] - speed) <= pop_rounding);
  // The flight is that of semi-implicit Euler, which is late by half a step; the ball begins it in overlap.
  const double apex = speed * speed / (2 * pop_gravity) - pop_depth;
  CHECK(std::abs(path.apex - apex) <= speed * pop_dt);
}

TEST_CASE("an overlap below g dt^2 / beta^2 creeps out by beta a step, and does not fly off") {
  const double beta = 0.2, fall = pop_gravity * pop_dt * pop_dt;  // [m] g dt^2
  // The next step asks for beta (1 - beta) d / dt; the body has beta d / dt - g dt.
  for (const double share : {0.5, 0.99, 1.01, 1.5}) {
    const double d = share * fall / (beta * beta);
    Scene scene(
        {.gravity = {0, -pop_gravity},
         .dt = pop_dt,
         .stabilization = {.policy = StabilizationPolicy::baumgarte, .slop = 0, .max_speed = uncapped}});
    scene.add_ground({.material = {.friction = 0}});
    scene.add({.shapes = {circle(pop_radius)}, .position = {0, pop_radius - d}, .mass = 1});
    const double creeping = -d * (1 - beta) * (1 - beta), flying = -d * (1 - beta) + beta * d - fall;
    CHECK(pose_of(world_after(scene, 2), {1}).position.y() - pop_radius ==
          doctest::Approx(share < 1 ? creeping : flying).epsilon(1e-9));
  }
}

TEST_CASE("a cap on the speed of recovery caps the pop") {
  const double cap = 0.5;  // [m/s]
  const PopPath path =
      watch_pop({.policy = StabilizationPolicy::baumgarte, .slop = 0, .max_speed = cap}, 512);
  for (const double speed : path.speed) CHECK(speed <= cap + pop_rounding);
  CHECK(path.apex <= cap * cap / (2 * pop_gravity) + cap * pop_dt);
  // It does come out: at the end a fifth of the overlap goes in every step, for hundreds of steps.
  CHECK(path.apex > -pop_rounding);
}

TEST_CASE("a cap on Baumgarte lifts a ball out of the ground and no higher, however short the step") {
  const double speed = std::sqrt(pop_gravity * pop_depth / 2);  // 0.71 m/s, half of a fall through the depth
  for (const double dt : {1e-3, 1e-4, 1e-5}) {
    World<double> world = sunken_ball({.policy = StabilizationPolicy::baumgarte, .slop = 0});
    world.set_dt(dt);
    SequentialImpulse<double> solver;
    double highest = -pop_depth, fastest = 0;
    // At v = sqrt(g d / 2) all the way the rest of the depth goes in 2 sqrt(2 d / g): d' = -v.
    const double rise = 2 * std::sqrt(2 * pop_depth / pop_gravity);  // [s]
    for (int step = 0; step < static_cast<int>(1.2 * rise / dt); ++step) {
      world.step(solver);
      highest = std::max(highest, world.bodies().pose[{1}].position.y() - pop_radius);
      fastest = std::max(fastest, world.bodies().velocity[{1}].y());
    }
    CHECK(fastest <= speed * (1 + 1e-12));
    // The first step goes v dt, where continuous flight would go v dt - g dt^2 / 2.
    CHECK(std::abs(highest) <= speed * dt);
  }
}

TEST_CASE("two solves take a share beta of an overlap back in every step, and leave no speed at all") {
  for (const auto policy : {StabilizationPolicy::split_impulse, StabilizationPolicy::relaxed}) {
    const PopPath path = watch_pop({.policy = policy, .slop = 0, .max_speed = uncapped}, 128);
    double room = -pop_depth;
    for (int i = 0; i < path.room.size(); ++i) {
      room *= 0.8;
      CHECK(std::abs(path.room[i] - room) <= pop_rounding);
      CHECK(std::abs(path.speed[i]) <= pop_rounding);
    }
  }
}

TEST_CASE("a soft contact moves as its spring does, and the relaxing solve takes the speed out again") {
  const Stabilization soft = {.policy = StabilizationPolicy::soft};  // whose slop springs do not keep
  const PopPath path = watch_pop(soft, 256);
  const double omega = 2 * pi * soft.soft.frequency;
  const double divisor = 1 + 2 * soft.soft.damping_ratio * omega * pop_dt + omega * omega * pop_dt * pop_dt;
  double room = -pop_depth;
  for (int i = 0; i < path.room.size(); ++i) {
    // Implicit Euler from rest, as gravity leaves it: v' = (v - h w^2 C) / (1 + 2 z w h + w^2 h^2).
    const double v = (-pop_gravity * pop_dt - pop_dt * omega * omega * room) / divisor;
    room += pop_dt * std::max(v, -pop_gravity * pop_dt);
    CHECK(std::abs(path.room[i] - room) <= 1e-12);
    CHECK(std::abs(path.speed[i]) <= pop_rounding);
  }
  // It comes to rest where the spring carries it, g / w^2 below the surface.
  CHECK(path.room.back() == doctest::Approx(-pop_gravity / (omega * omega)).epsilon(0.05));
}

TEST_CASE("under the policy soft joints give way as springs of their own") {
  const Stabilization soft = {.policy = StabilizationPolicy::soft};
  const int substeps = 4;
  Scene scene({.gravity = {0, -pop_gravity}, .dt = pop_dt, .substeps = substeps, .stabilization = soft});
  const BodyId bob = scene.add({.shapes = {circle(0.1)}, .position = {0, -1}});
  scene.join<DistanceJoint>({.a = ground, .b = bob, .anchor_a = {0, 0}, .anchor_b = {0, -1}});
  World<double> world = world_after(scene, 400);
  const double below = -1 - world.bodies().pose[bob].position.y();
  // At rest the row carries m g at k = m w^2; what is left of the way there shrinks by more than half a step.
  CHECK(below == doctest::Approx(spring_sag(soft.joint_soft, pop_dt / substeps, pop_gravity)).epsilon(1e-9));
  CHECK(below < spring_sag(soft.soft, pop_dt / substeps, pop_gravity) / 2);
}

TEST_CASE("a joint with a spring of its own gives way by it under the policy soft, and under no other") {
  const SwingSoftness own = {.frequency = 20, .damping_ratio = 1};
  for (const StabilizationPolicy policy : {StabilizationPolicy::soft, StabilizationPolicy::baumgarte}) {
    const Stabilization stabilization = {.policy = policy};
    Scene scene({.gravity = {0, -pop_gravity}, .dt = pop_dt, .stabilization = stabilization});
    List<BodyId> bobs;
    for (const double x : {0.0, 1.0, 2.0}) {
      bobs.push_back(scene.add({.shapes = {circle(0.1)}, .position = {x, -1}}));
      const JointId rod =
          scene.join<DistanceJoint>({.a = ground, .b = bobs.back(), .anchor_a = {x, 0}, .anchor_b = {x, -1}});
      if (x == 1) scene.change(rod, own);
    }
    World<double> world = world_after(scene, 400);
    const bool gives_way = policy == StabilizationPolicy::soft;
    CAPTURE(gives_way);
    for (int i = 0; i < 3; ++i) {
      CAPTURE(i);
      const double below = -1 - world.bodies().pose[bobs[i]].position.y();
      const SwingSoftness& spring = i == 1 ? own : stabilization.joint_soft;
      // At rest the row carries m g at k = m w^2; under Baumgarte only rounding is left.
      const double sag = gives_way ? spring_sag(spring, pop_dt, pop_gravity) : 0;
      CHECK(std::abs(below - sag) <= 1e-9);
    }
  }
}

TEST_CASE("a joint's spring out of range, or of no joint, is refused") {
  Scene scene;
  const JointId rod =
      scene.join<DistanceJoint>({.b = scene.add({.shapes = {circle(1)}}), .anchor_a = {0, 2}});
  CHECK_THROWS_AS(scene.change(rod, {.frequency = 0}), std::invalid_argument);
  CHECK_THROWS_AS(scene.change({1}, {.frequency = 5}), std::invalid_argument);
  CHECK_FALSE(scene.joints().hold(0).soft);
}

TEST_CASE("n substeps are n steps of dt / n, bit for bit") {
  const Stabilization policies[] = {{},
                                    {.policy = StabilizationPolicy::soft},
                                    {.policy = StabilizationPolicy::split_impulse},
                                    {.policy = StabilizationPolicy::none}};
  for (const Stabilization& stabilization : policies) {
    World<double> whole = sunken_ball(stabilization, 4);
    World<double> parts = sunken_ball(stabilization);
    parts.set_dt(pop_dt / 4);
    SequentialImpulse<double> solver;
    for (int step = 0; step < 64; ++step) {
      const StepReport report = whole.step(solver);
      CHECK(report.sweeps >= 40);
      for (int k = 0; k < 4; ++k) parts.step(solver);
      REQUIRE(whole.bodies().pose[{1}].position == parts.bodies().pose[{1}].position);
      REQUIRE(whole.bodies().velocity[{1}] == parts.bodies().velocity[{1}]);
    }
    CHECK(whole.clock().time == 64 * pop_dt);
    CHECK(whole.clock().steps == 64);
    CHECK(snapshot(whole).dt == pop_dt / 4);
  }
}

TEST_CASE("a stack of ten stands ten seconds under every policy that takes errors back") {
  struct Setting {
    StabilizationPolicy policy;
    int substeps;  // springs that are soft enough for 1 / 60 s are too soft for the weight of ten boxes
  };
  const Setting settings[] = {{StabilizationPolicy::baumgarte, 1},
                              {StabilizationPolicy::split_impulse, 1},
                              {StabilizationPolicy::soft, 4}};
  // The spring of a lowest contact point, 30 Hz on 1 / (1 + 0.5^2 * 6) kg, and all the weight on one point.
  const double sag = 10 * 10 / (std::pow(2 * pi * 30, 2) / 2.5);
  for (const Setting& setting : settings) {
    CAPTURE(static_cast<int>(setting.policy));
    const Scene stack =
        samples::stack(10, {.substeps = setting.substeps, .stabilization = {.policy = setting.policy}});
    const World<double> world = world_after(stack, 600);
    const double give = setting.policy == StabilizationPolicy::soft ? sag : 0;
    CHECK(worst_penetration(snapshot(world)) <= 2 * 0.005 + give);  // slop, and as much for ten sweeps
    const PerBody<Pose<double>>& pose = world.bodies().pose;
    CHECK(std::abs(pose.back().position.y() - 9.5) <= 10 * (2 * 0.005 + give));
    for (int i = 2; i < pose.size(); ++i) {
      CHECK(std::abs(pose[{i}].position.x() - pose[{i - 1}].position.x()) <= 0.05);  // it leans, and holds
    }
  }
}

TEST_CASE("a swinging joint drifts without stabilization, and is held by split impulses and springs") {
  const auto drift_after = [](StabilizationPolicy policy) {
    Scene scene({.stabilization = {.policy = policy}});
    const BodyId rod = scene.add({.shapes = {box(2, 0.2)}, .position = {1, 0}});
    scene.join<RevoluteJoint>({.a = ground, .b = rod, .anchor = {0, 0}});
    World<double> world(scene);
    SequentialImpulse<double> solver({.iterations = 20});
    double worst = 0;
    for (int step = 0; step < 300; ++step) {
      world.step(solver);
      worst = std::max(worst, worst_joint_drift(snapshot(world)));
    }
    return worst;
  };
  // Each step runs off the circle by L w^2 dt^2 / 2, where w^2 = 2 g (m L / I) <= 15 / s^2 at the lowest
  // point: unheld that adds up, and held it stands at what is taken back by a share of it.
  const double run_off = 1.0 * 15 / 3600 / 2;
  CHECK(drift_after(StabilizationPolicy::none) > 20 * run_off);
  CHECK(drift_after(StabilizationPolicy::split_impulse) <= run_off / 0.2);
  const double swing = 2 * pi * 0.25;  // w h of a spring at a quarter of the steps
  const double share = swing * swing / (1 + 2 * 10 * swing + swing * swing);
  CHECK(drift_after(StabilizationPolicy::soft) <= run_off / share);
}

/// How many boxes of 1 m and 1 kg may stand on each other on springs of so many Hz. Leaning by the angles
/// t_i, box by box, they have the energy sum k_i (t_i - t_{i-1})^2 / 2 - sum m g h (n - i + 1/2) t_i^2 / 2,
/// which must rise in every direction: all pivots of its matrix are above 0. Two points, half a metre from
/// the middle, have the stiffness w^2 / A each, A = 2 (1 + 6 / 4) / kg between boxes, and half of it on the
/// ground.
int tallest_on_springs(double frequency) {
  const double omega = 2 * pi * frequency, between = omega * omega / 5 / 2;  // [N m / rad]
  for (int n = 1;; ++n) {
    double pivot = std::numeric_limits<double>::infinity();
    for (int i = 1; i <= n && pivot > 0; ++i) {
      const double below = i == 1 ? 2 * between : between, above = i < n ? between : 0;
      pivot = below + above - pop_gravity * (n - i + 0.5) - between * between / pivot;
    }
    if (pivot <= 0) return n - 1;
  }
}

TEST_CASE(
    "a tower on springs buckles above the height that A. G. Greenhill gives a column of their stiffness") {
  const int tallest = tallest_on_springs(30);
  const double bending = std::pow(2 * pi * 30, 2) / 5 / 2;  // [N m^2] EI of a box of 1 m
  CHECK(std::abs(tallest - std::cbrt(7.837 * bending / pop_gravity)) < 1.5);
  // The towers begin with a lean of 1 cm, which takes a box from what a straight one could be.
  for (const int boxes : {tallest - 2, tallest + 2}) {
    Scene scene({.substeps = 4, .stabilization = {.policy = StabilizationPolicy::soft}});
    scene.add_ground();
    samples::add_staggered_stack(scene, boxes, 0.02);
    World<double> world(scene);
    AcceleratedProjectedGaussSeidel<double> solver({.iterations = 30});
    for (int step = 0; step < 180; ++step) world.step(solver);
    const bool leans = std::abs(world.bodies().pose.back().position.x()) > 0.1;
    CHECK(leans == (boxes > tallest));
  }
}
