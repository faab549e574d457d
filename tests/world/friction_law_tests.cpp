// Friction as it is taught: static beside kinetic, and rolling resistance.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

// Sums of 60 steps, each solved to a few roundings.
const double sums = 1e-9;

/// A block of 2 kg that rests on a slope of this angle [rad], which is a turned gravity on level ground.
Scene block_on_slope(double angle, const Material& material, const SceneSettings& given = {}) {
  SceneSettings settings = given;
  settings.gravity = {10 * std::sin(angle), -10 * std::cos(angle)};
  Scene scene(settings);
  scene.add_ground({.material = material});
  scene.add({.shapes = {box(1, 0.5)}, .position = {0, 0.25}, .mass = 2, .material = material});
  return scene;
}

/// A disc of radius 0.5 m that rolls to the right without slip at `speed` [m/s], in this gravity.
Scene rolling_disc(double speed, double resistance, const Vec2<double>& gravity = {0, -10}) {
  Scene scene({.gravity = gravity});
  scene.add_ground();
  scene.add({.shapes = {circle(0.5)},
             .position = {0, 0.5},
             .velocity = {speed, 0},
             .angular_velocity = -speed / 0.5,
             .mass = 2,
             .material = {.rolling_resistance = resistance}});
  return scene;
}

template <Scalar Real = double>
Vec3<Real> velocity_after(const Scene& scene, int steps, Solver<Real>&& solver) {
  World<Real> world(scene);
  take_steps(world, solver, steps);
  return velocity_of(world, {1});
}

SequentialImpulse<double> sweeps(int count = 60) { return SequentialImpulse<double>({.iterations = count}); }

const Material two_coefficients = {.friction = 0.3, .static_friction = 0.6};

/// Steps until the block above slides under a pull of `tangent` times its weight: until it is faster than
/// mu g dt m/m_t, where m/m_t = 1 + m (0.25 m)^2 / I. They have mu_s.
double steps_to_slide(double tangent) {
  const double effective = 1 + 0.0625 * 12 / (1 + 0.25);
  return std::floor(0.3 * effective / (tangent - 0.6)) + 1;
}

}  // namespace

TEST_CASE("a block that sticks holds up to mu_s, and slides at g (sin - mu cos) above it") {
  for (const FrictionRows rows : {FrictionRows::per_point, FrictionRows::per_manifold}) {
    for (const StabilizationPolicy policy :
         {StabilizationPolicy::relaxed, StabilizationPolicy::soft, StabilizationPolicy::baumgarte,
          StabilizationPolicy::split_impulse}) {
      CAPTURE(static_cast<int>(policy));
      const SceneSettings settings = {.stabilization = {.policy = policy}, .friction_rows = rows};
      const double below = std::atan(0.59), above = std::atan(0.65);
      const Scene holds = block_on_slope(below, two_coefficients, settings);
      const Scene slides = block_on_slope(above, two_coefficients, settings);
      const double lost = steps_to_slide(0.65) * 10 * std::cos(above) * (0.6 - 0.3) / 60;
      const double speed = 10 * (std::sin(above) - 0.3 * std::cos(above)) - lost;  // after 1 s
      const auto check = [&](auto&& make) {
        CHECK(std::abs(velocity_after(holds, 120, make()).x()) <= 1e-6);
        CHECK(velocity_after(slides, 60, make()).x() == doctest::Approx(speed).epsilon(1e-6));
      };
      check([] { return SequentialImpulse<double>({.iterations = 60}); });
      check([] { return SparseProjectedGaussSeidel<double>({.iterations = 60}); });
      check([] { return NewtonSolver<double>({.iterations = 50, .tolerance = 1e-12}); });
    }
  }
}

TEST_CASE("lanes know of static friction, too") {
  const double above = std::atan(0.65);
  const auto wide = [] { return WideSequentialImpulse<double>({.iterations = 60}); };
  CHECK(std::abs(velocity_after(block_on_slope(std::atan(0.59), two_coefficients), 120, wide()).x()) <= 1e-5);
  const double lost = steps_to_slide(0.65) * 10 * std::cos(above) * (0.6 - 0.3) / 60;
  CHECK(velocity_after(block_on_slope(above, two_coefficients), 60, wide()).x() ==
        doctest::Approx(10 * (std::sin(above) - 0.3 * std::cos(above)) - lost).epsilon(1e-5));
}

TEST_CASE("a block that is thrown slides at mu g, stops, and then sticks with mu_s") {
  // Level ground, then a pull of 0.5 g: between the two coefficients.
  Scene scene = block_on_slope(0, two_coefficients);
  World<double> world(scene);
  world.set_velocity({1}, {1, 0, 0});
  SequentialImpulse<double> solver({.iterations = 60});
  take_steps(world, solver, 10);
  CHECK(velocity_of(world, {1}).x() == doctest::Approx(1 - 0.3 * 10 * 10 / 60).epsilon(sums));
  take_steps(world, solver, 20);
  CHECK(std::abs(velocity_of(world, {1}).x()) <= sums);
  const auto pull = [&world](double acceleration) {
    world.edit([&](Scene& edited) {
      SceneSettings settings = edited.settings();
      settings.gravity = {acceleration, -10};
      edited.set_settings(settings);
    });
  };
  pull(5);
  take_steps(world, solver, 60);
  CHECK(std::abs(velocity_of(world, {1}).x()) <= sums);
  pull(7);  // over mu_s
  take_steps(world, solver, 60);
  const double speed = velocity_of(world, {1}).x();
  CHECK(speed == doctest::Approx(7 - 3 - steps_to_slide(0.7) * 0.3 * 10 / 60).epsilon(1e-6));
  pull(5);  // under mu_s, but it slides
  take_steps(world, solver, 60);
  CHECK(velocity_of(world, {1}).x() == doctest::Approx(speed + 5 - 3).epsilon(1e-6));
}

TEST_CASE("a slope that is tilted slowly lets go at atan(mu_s)") {
  World<double> world(block_on_slope(0, two_coefficients));
  SequentialImpulse<double> solver({.iterations = 60});
  const double rate = 0.1;  // [rad/s]
  int step = 0;
  for (; std::abs(velocity_of(world, {1}).x()) < 1e-3 && step < 600; ++step) {
    const double angle = rate * step / 60;
    world.edit([&](Scene& edited) {
      SceneSettings settings = edited.settings();
      settings.gravity = {10 * std::sin(angle), -10 * std::cos(angle)};
      edited.set_settings(settings);
    });
    take_steps(world, solver, 1);
  }
  // It reaches 1 mm/s 0.04 s later, when the slope has turned by 0.004.
  CHECK(rate * step / 60 == doctest::Approx(std::atan(0.6)).epsilon(0.02));
}

TEST_CASE("static friction holds tiny and huge blocks, heavy on light, and in float") {
  for (const double size : {1e-3, 1.0, 1e3}) {
    for (const double mass : {1e-3, 1.0, 1e4}) {
      CAPTURE(size);
      CAPTURE(mass);
      const double angle = std::atan(0.5);
      Scene scene({.gravity = {10 * std::sin(angle), -10 * std::cos(angle)}});
      scene.add_ground({.half_width = 50 * size, .thickness = size, .material = two_coefficients});
      scene.add({.shapes = {box(2 * size, size)},
                 .position = {0, 0.5 * size},
                 .mass = 1,
                 .material = two_coefficients});
      scene.add({.shapes = {box(2 * size, size)},
                 .position = {0, 1.5 * size},
                 .mass = mass,
                 .material = two_coefficients});
      // Sweeps leave a heavy block on a light one with speeds at which it slides in truth.
      World<double> world(scene);
      NewtonSolver<double> newton({.iterations = 50, .tolerance = 1e-9});
      take_steps(world, newton, 120);
      CHECK(std::abs(pose_of(world, {2}).position.x()) <= 1e-3 * size);
      if (mass > 1) continue;
      World<float> single(scene);
      take_steps(single, 120, 100);
      CHECK(std::abs(pose_of(single, {2}).position.x()) <= 1e-2 * size);
    }
  }
}

TEST_CASE("a stack sticks on a slope between its two coefficients, however few sweeps a step has") {
  const double angle = std::atan(0.45);
  Scene scene({.gravity = {10 * std::sin(angle), -10 * std::cos(angle)}});
  scene.add_ground({.material = two_coefficients});
  for (int i = 0; i < 4; ++i)
    scene.add({.shapes = {box(3, 0.4)}, .position = {0, 0.2 + 0.4 * i}, .material = two_coefficients});
  const auto check = [&](Solver<double>&& solver) {
    World<double> world(scene);
    take_steps(world, solver, 300);
    CHECK(std::abs(pose_of(world, {4}).position.x()) <= 0.005);
  };
  check(SequentialImpulse<double>({.iterations = 10}));
  check(SparseProjectedGaussSeidel<double>({.iterations = 10}));
  check(WideSequentialImpulse<double>({.iterations = 10}));
  check(NewtonSolver<double>({.iterations = 20}));
}

TEST_CASE("a disc that rolls is slowed by mu_r g r / (r^2 + I/m), under every solver") {
  const double resistance = 0.03, r = 0.5;
  const double slowing = resistance * 10 * r / (r * r + r * r / 2);
  const auto check = [&](auto&& make, double within) {
    const Vec3<double> v = velocity_after(rolling_disc(2, resistance), 60, make());
    CHECK(v.x() == doctest::Approx(2 - slowing).epsilon(within));
    CHECK(v.z() * r == doctest::Approx(-(2 - slowing)).epsilon(within));
  };
  check([] { return sweeps(); }, sums);
  check([] { return SparseProjectedGaussSeidel<double>({.iterations = 60}); }, sums);
  check([] { return NewtonSolver<double>({.iterations = 50, .tolerance = 1e-12}); }, sums);
  check([] { return BlockSequentialImpulse<double>({.iterations = 60}); }, sums);
  check([] { return ReferenceSolver<double>(); }, sums);
  check([] { return WideSequentialImpulse<double>({.iterations = 60}); }, 1e-5);
}

TEST_CASE("a disc rests on a slope up to atan(mu_r / r), and rolls above it") {
  const auto speed_on = [](double angle) {
    const Scene scene = rolling_disc(0, 0.05, {10 * std::sin(angle), -10 * std::cos(angle)});
    return velocity_after(scene, 60, sweeps()).x();
  };
  CHECK(std::abs(speed_on(std::atan(0.099))) <= 1e-9);
  const double angle = std::atan(0.2);
  CHECK(speed_on(angle) ==
        doctest::Approx(10 * (std::sin(angle) - 0.1 * std::cos(angle)) / 1.5).epsilon(sums));
}

TEST_CASE("rolling resistance stops a disc for good, and gives no row to what lies on two points") {
  const Vec3<double> v = velocity_after(rolling_disc(0.5, 0.05), 180, sweeps());
  CHECK(std::abs(v.x()) <= sums);
  CHECK(std::abs(v.z()) <= sums);
  Scene scene;
  scene.add_ground();
  scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5}, .material = {.rolling_resistance = 0.1}});
  CHECK(problem_after(scene, 1).row_count() == 4);
  CHECK(problem_after(rolling_disc(0, 0.1), 1).row_count() == 3);
  CHECK(problem_after(rolling_disc(0, 0), 1).row_count() == 2);
  CHECK(problem_after(rolling_disc(0, 0), 1).rolling_resistance.empty());
}

TEST_CASE("a scene plans for no more of this than it has, and says so") {
  const Plan plain = make_plan(block_on_slope(0, {}));
  CHECK_FALSE(plain.extras.static_friction);
  CHECK_FALSE(plain.extras.rolling_resistance);
  CHECK(plain.contacts_without_rows());
  for (const char* word : {"static", "rolling", "mixing", "impacts"})
    CHECK(explain(plain).find(word) == std::string::npos);
  const Plan both = make_plan(block_on_slope(0, two_coefficients));
  CHECK(both.extras.static_friction);
  CHECK(both.contacts_without_rows());
  CHECK(explain(both).find("static") != std::string::npos);
  const Plan rolling = make_plan(rolling_disc(0, 0.1));
  CHECK_FALSE(rolling.contacts_without_rows());
  CHECK(explain(rolling).find("rolling") != std::string::npos);
  Scene one_rubs({.mixing = {.friction = MixingRule::maximum}});
  one_rubs.add_ground({.material = {.friction = 0}});
  one_rubs.add({.shapes = {circle(1)}, .position = {0, 1}});
  CHECK(make_plan(one_rubs).friction);
  CHECK(explain(make_plan(one_rubs)).find("mixing") != std::string::npos);
}

TEST_CASE("who slides is known to a copy and after an edit, bit by bit") {
  const double angle = std::atan(0.5);
  World<double> world(block_on_slope(angle, two_coefficients));
  world.set_velocity({1}, {1, 0, 0});
  SequentialImpulse<double> solver({.iterations = 10});
  take_steps(world, solver, 20);
  World<double> copy = world, edited = world;
  edited.edit([](Scene& scene) { scene.add({.shapes = {circle(1)}, .position = {0, 100}}); });
  edited.edit([](Scene& scene) { scene.remove(BodyId{2}); });
  take_steps(world, solver, 60);
  take_steps(copy, solver, 60);
  take_steps(edited, solver, 60);
  CHECK(velocity_of(world, {1}).x() > 2);
  CHECK(same_motion(world, copy));
  CHECK(same_motion(world, edited));
}
