// Impacts that bodies pass on.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

// Of speeds of 1 m/s that a sequence of impacts leaves, each to 64 roundings.
const double exact = 1e-11;

struct Row {
  List<double> masses = {1, 1, 1, 1, 1};
  List<double> speeds = {1, 0, 0, 0, 0};
  double restitution = 1;
  Impacts impacts = Impacts::sequence;
  Vec2<double> gravity = {0, 0};
  double size = 1;  // [m]
};

/// Balls that touch in a row, the first of which come in.
Scene balls(const Row& row) {
  Scene scene({.gravity = row.gravity, .impacts = row.impacts});
  for (const int i : row.masses.indices()) {
    scene.add({.shapes = {circle(row.size / 2)},
               .position = {i * row.size, 0},
               .velocity = {row.speeds[i] * row.size, 0},
               .mass = row.masses[i],
               .material = {.friction = 0, .restitution = row.restitution}});
  }
  return scene;
}

List<double> speeds_after(const Row& row, Solver<double>&& solver, int steps = 3) {
  World<double> world(balls(row));
  take_steps(world, solver, steps);
  List<double> speeds;
  for (int i = 1; i <= row.masses.size(); ++i) speeds.push_back(velocity_of(world, {i}).x() / row.size);
  return speeds;
}

List<double> speeds_after(const Row& row) {
  return speeds_after(row, SequentialImpulse<double>({.iterations = 10}));
}

void check_near(const List<double>& got, const List<double>& expected, double within = exact) {
  REQUIRE(got.size() == expected.size());
  for (const int i : got.indices()) {
    CAPTURE(i);
    CHECK(std::abs(got[i] - expected[i]) <= within);
  }
}

}  // namespace

TEST_CASE("touching balls: as many go out as come in, under every solver") {
  const Row one, two = {.speeds = {1, 1, 0, 0, 0}}, three = {.speeds = {1, 1, 1, 0, 0}};
  const auto check = [&](auto&& make, double within) {
    check_near(speeds_after(one, make()), {0, 0, 0, 0, 1}, within);
    check_near(speeds_after(two, make()), {0, 0, 0, 1, 1}, within);
    check_near(speeds_after(three, make()), {0, 0, 1, 1, 1}, within);
  };
  check([] { return SequentialImpulse<double>({.iterations = 1}); }, exact);
  check([] { return SequentialImpulse<double>({.iterations = 10}); }, exact);
  check([] { return SparseProjectedGaussSeidel<double>({.iterations = 10}); }, exact);
  check([] { return NewtonSolver<double>({.iterations = 50, .tolerance = 1e-12}); }, 1e-9);
  check([] { return WideSequentialImpulse<double>({.iterations = 10}); }, 1e-5);
}

TEST_CASE("at once, the same row parts as a whole: the law that a scene has unless it asks for a sequence") {
  const List<double> speeds = speeds_after({.impacts = Impacts::at_once});
  CHECK(speeds[4] < 0.9);
  CHECK(speeds[3] > 0.1);
  CHECK(SceneSettings().impacts == Impacts::at_once);
}

TEST_CASE("a ball between two that come in at one speed stays, and those leave at theirs") {
  check_near(speeds_after({.masses = {1, 1, 1}, .speeds = {1, 0, -1}}), {-1, 0, 1});
  check_near(speeds_after({.masses = {1, 3, 1}, .speeds = {1, 0, -1}}), {-1, 0, 1});
}

TEST_CASE("a ball that strikes two of other masses: two impacts, one after the other") {
  // v2 = 2 m1/(m1 + m2), and then the same from the second to the third.
  const double v1 = (1.0 - 2.0) / 3, v2 = 2.0 / 3, v3 = v2 * 2 * 2.0 / (2 + 4),
               v2_end = v2 * (2.0 - 4) / (2 + 4);
  check_near(speeds_after({.masses = {1, 2, 4}, .speeds = {1, 0, 0}}), {v1, v2_end, v3});
}

TEST_CASE("with e < 1 each impact loses its own: (1 + e)/2 is passed on, and (1 - e)/2 kept") {
  const double e = 0.5, on = (1 + e) / 2, kept = (1 - e) / 2;
  const List<double> speeds = speeds_after({.masses = {1, 1}, .speeds = {1, 0}, .restitution = e});
  check_near(speeds, {kept, on});
  const List<double> row = speeds_after({.masses = {1, 1, 1}, .speeds = {1, 0, 0}, .restitution = e});
  double momentum = 0, energy = 0;
  for (const double v : row) momentum += v, energy += v * v;
  CHECK(momentum == doctest::Approx(1).epsilon(exact));
  CHECK(energy < 1);
  CHECK(row[2] == doctest::Approx(on * on).epsilon(1e-9));
}

TEST_CASE("a sequence keeps energy and momentum, of any masses, tiny and huge") {
  for (const double size : {1e-3, 1.0, 1e3}) {
    for (const List<double>& masses : {List<double>{1, 1000, 1, 1e-3, 1}, List<double>{1e-6, 1, 1e6, 1, 1e-6},
                                       List<double>{5, 4, 3, 2, 1}}) {
      const Row row = {.masses = masses, .size = size};
      const List<double> speeds = speeds_after(row);
      double momentum = 0, energy = 0;
      for (const int i : masses.indices()) {
        momentum += masses[i] * speeds[i];
        energy += masses[i] * speeds[i] * speeds[i];
      }
      CHECK(momentum == doctest::Approx(masses[0]).epsilon(1e-9));
      CHECK(energy == doctest::Approx(masses[0]).epsilon(1e-9));
    }
  }
}

TEST_CASE("a sequence goes through joints: a ball strikes a rod of two balls as one body of their mass") {
  for (const StabilizationPolicy policy :
       {StabilizationPolicy::relaxed, StabilizationPolicy::soft, StabilizationPolicy::baumgarte,
        StabilizationPolicy::split_impulse}) {
    CAPTURE(static_cast<int>(policy));
    Scene scene({.gravity = {0, 0}, .stabilization = {.policy = policy}, .impacts = Impacts::sequence});
    const auto ball = [&scene](double x, double speed) {
      return scene.add({.shapes = {circle(0.5)},
                        .position = {x, 0},
                        .velocity = {speed, 0},
                        .mass = 1,
                        .material = {.friction = 0, .restitution = 1}});
    };
    ball(0, 1);
    const BodyId near = ball(1, 0), far = ball(3, 0);
    ball(4, 0);
    scene.join<DistanceJoint>({.a = near, .b = far, .anchor_a = {1, 0}, .anchor_b = {3, 0}});
    World<double> world(scene);
    take_steps(world, 3, 50);
    // 1 kg on 2 kg: -1/3 and 2/3; 2 kg on 1 kg: 2/9 and 8/9.
    CHECK(velocity_of(world, {1}).x() == doctest::Approx(-1.0 / 3).epsilon(1e-9));
    CHECK(velocity_of(world, {2}).x() == doctest::Approx(2.0 / 9).epsilon(1e-9));
    CHECK(velocity_of(world, {4}).x() == doctest::Approx(8.0 / 9).epsilon(1e-9));
  }
}

TEST_CASE(
    "as many balls go out as come in by every policy, with gaps that close within a step, and in float") {
  for (const StabilizationPolicy policy :
       {StabilizationPolicy::none, StabilizationPolicy::relaxed, StabilizationPolicy::soft,
        StabilizationPolicy::baumgarte, StabilizationPolicy::split_impulse}) {
    CAPTURE(static_cast<int>(policy));
    Scene scene({.gravity = {0, 0}, .stabilization = {.policy = policy}, .impacts = Impacts::sequence});
    for (int i = 0; i < 5; ++i) {
      scene.add({.shapes = {circle(0.5)},
                 .position = {i - (i < 2 ? 0.021 : 0), 0},
                 .velocity = {i < 2 ? 1.0 : 0.0, 0},
                 .mass = 1,
                 .material = {.friction = 0, .restitution = 1}});
    }
    const World<double> world = world_after(scene, 10);
    const World<float> single = world_after<float>(scene, 10);
    for (int i = 1; i <= 5; ++i) {
      CHECK(std::abs(velocity_of(world, {i}).x() - (i > 3 ? 1 : 0)) <= 1e-9);
      CHECK(std::abs(velocity_of(single, {i}).x() - (i > 3 ? 1 : 0)) <= 1e-4);
    }
  }
}

TEST_CASE("a ball breaks a rack of ten: energy and momentum stay, and so does the mirror image") {
  Scene scene({.gravity = {0, 0}, .impacts = Impacts::sequence});
  const auto ball = [&scene](const Vec2<double>& place, double speed) {
    return scene.add({.shapes = {circle(0.5)},
                      .position = place,
                      .velocity = {speed, 0},
                      .mass = 1,
                      .material = {.friction = 0, .restitution = 1}});
  };
  const BodyId cue = ball({-1, 0}, 5);
  List<std::pair<BodyId, BodyId>> mirrored;
  for (int row = 0; row < 4; ++row) {
    List<BodyId> balls;
    for (int k = 0; k <= row; ++k) balls.push_back(ball({row * std::sqrt(0.75), k - row / 2.0}, 0));
    for (int k = 0; k <= row; ++k) mirrored.push_back({balls[k], balls[row - k]});
  }
  World<double> world(scene);
  take_steps(world, 60, 20);
  double momentum = velocity_of(world, cue).x(), energy = velocity_of(world, cue).squaredNorm();
  CHECK(std::abs(velocity_of(world, cue).y()) <= 1e-9);
  for (const auto& [one, other] : mirrored) {
    const Vec3<double>&v = velocity_of(world, one), &w = velocity_of(world, other);
    momentum += v.x();
    energy += v.squaredNorm();
    CHECK(std::abs(v.x() - w.x()) <= 1e-9);
    CHECK(std::abs(v.y() + w.y()) <= 1e-9);
  }
  CHECK(momentum == doctest::Approx(5).epsilon(1e-9));
  CHECK(energy == doctest::Approx(25).epsilon(1e-9));
}

TEST_CASE("a row of a hundred balls passes one on") {
  Row row = {.masses = List<double>(100, 1.0), .speeds = List<double>(100, 0.0)};
  row.speeds[0] = 1;
  const List<double> speeds = speeds_after(row);
  CHECK(std::abs(speeds[99] - 1) <= 1e-9);
  for (int i = 0; i < 99; ++i) CHECK(std::abs(speeds[i]) <= 1e-9);
}

TEST_CASE("a ball that bounces alone does as without a sequence, bit by bit") {
  const auto end = [](Impacts impacts) {
    Scene scene({.impacts = impacts});
    scene.add_ground();
    scene.add({.shapes = {circle(0.5)}, .position = {0, 3}, .material = {.restitution = 0.8}});
    return world_after(scene, 120);
  };
  CHECK(
      (pose_of(end(Impacts::sequence), {1}).position - pose_of(end(Impacts::at_once), {1}).position).norm() <=
      1e-12);
}

TEST_CASE("what rests on others while one is struck keeps its load") {
  Scene scene({.impacts = Impacts::sequence});
  scene.add_ground();
  for (int i = 0; i < 4; ++i)
    scene.add(
        {.shapes = {box(1, 1)}, .position = {0, 0.5 + i}, .material = {.restitution = i == 3 ? 0.5 : 0}});
  World<double> world(scene);
  world.set_velocity({4}, {0, -3, 0});
  take_steps(world, 120, 20);
  for (int i = 1; i <= 4; ++i) {
    CHECK(std::abs(pose_of(world, {i}).position.y() - (i - 0.5)) <= 0.02);
    CHECK(std::abs(velocity_of(world, {i}).y()) <= 0.02);
  }
}

TEST_CASE(
    "a slow elastic ball goes to and fro for ever without gravity, and the threshold goes with sqrt(g L)") {
  Scene scene({.gravity = {0, 0}});
  for (const double x : {-2.0, 2.0}) {
    scene.add({.type = BodyType::static_body,
               .shapes = {box(1, 3)},
               .position = {x, 0},
               .material = {.friction = 0, .restitution = 1}});
  }
  scene.add({.shapes = {circle(0.5)}, .velocity = {0.4, 0}, .material = {.friction = 0, .restitution = 1}});
  CHECK(std::abs(velocity_of(world_after(scene, 3600), {3}).x()) == doctest::Approx(0.4).epsilon(1e-9));
  for (const double size : {1.0 / 64, 1.0, 64.0}) {
    const Plan plan = make_plan(balls({.gravity = {0, -10}, .size = size}));
    // What falls through L / 80 under g.
    CHECK(*plan.settings.restitution_threshold ==
          doctest::Approx(std::sqrt(2 * 10 * plan.length / 80)).epsilon(1e-9));
  }
}

TEST_CASE("a scene without rebounds plans for no sequence, and the threshold of rebounds is explained") {
  CHECK_FALSE(make_plan(balls({.restitution = 0})).extras.impact_sequence);
  CHECK(make_plan(balls({})).extras.impact_sequence);
  CHECK(explain(make_plan(balls({}))).find("impacts") != std::string::npos);
  CHECK(explain(make_plan(balls({}))).find("does not rebound") == std::string::npos);
  CHECK(explain(make_plan(balls({.gravity = {0, -10}}))).find("more slowly than 0.5 m/s does not rebound") !=
        std::string::npos);
}
