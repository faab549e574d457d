// One run of a scene under a setting.
#include <cairn/study/trial.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/scenes/scene_file.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/study/contestant.hpp>
#include <cairn/study/jitter.hpp>
#include <cairn/world/world.hpp>

using namespace cairn;

namespace {

const double trial_dt = 1.0 / 64;  // [s] exact, so that sums of it are

/// A disc of 1 kg that falls from (0, 0), touching nothing.
Scene falling_disc() {
  Scene scene;
  scene.add({.shapes = {circle(0.5)}, .mass = 1});
  return scene;
}

/// n discs on the ground, side by side: n contact points, 2 n rows.
Scene resting_discs(int discs) {
  Scene scene;
  scene.add_ground({.half_width = 2.0 * discs + 1});
  for (int i = 0; i < discs; ++i) scene.add({.shapes = {circle(0.5)}, .position = {2.0 * i, 0.5}});
  return scene;
}

/// A disc on three pins above each other. Of their three equal rows along y, plain Jacobi gives the same
/// correction three times: every sweep makes -2 times the error of it.
Scene disc_on_three_pins() {
  Scene scene;
  const BodyId disc = scene.add({.shapes = {circle(1)}});
  for (const double y : {-0.5, 0.0, 0.5}) {
    scene.join<RevoluteJoint>({.a = ground, .b = disc, .anchor = {0, y}});
  }
  return scene;
}

}  // namespace

TEST_CASE("a run is as long as it was asked for, and shows the start and every step") {
  int seen = 0;
  double last = -1;
  TrialOptions options{.seconds = 1};
  options.observer = [&](const Snapshot& now) {
    CHECK(now.step == seen);
    seen += 1;
    last = now.time;
  };
  const TrialResult result = run_trial(falling_disc(), {.dt = trial_dt}, options);
  CHECK(result.status == TrialStatus::ok);
  CHECK(result.steps == 64);
  CHECK(result.seconds == 1);
  CHECK(seen == 65);
  CHECK(last == 1);
}

TEST_CASE("energy that a falling disc loses to the integration is g dt / 2 of its speed, of the scale") {
  // Semi-implicit Euler falls g dt^2 n (n + 1) / 2 and reaches g dt n: m g^2 dt t / 2 is missing. The scale
  // is what it had above where it has come: m g times its fall.
  const TrialResult result = run_trial(falling_disc(), {.dt = trial_dt}, {.seconds = 1});
  const double fall = 10 * trial_dt * trial_dt * 64 * 65 / 2;  // [m]
  CHECK(result.energy_scale == doctest::Approx(10 * fall).epsilon(1e-14));
  CHECK(result.energy_loss == doctest::Approx(0.5 * 100 * trial_dt / (10 * fall)).epsilon(1e-12));
  CHECK(result.energy_gain == 0);
  CHECK(result.farthest == doctest::Approx(10 * trial_dt * trial_dt * 64 * 65 / 2).epsilon(1e-12));
}

TEST_CASE(
    "a scene without time to settle stands until the step after which a body is too far from its start") {
  // After n steps it has fallen g dt^2 n (n + 1) / 2: beyond 10 dt^2 45 from n = 10 on.
  const double distance = 10 * trial_dt * trial_dt * 45 * 1.0001;
  const TrialResult result = run_trial(falling_disc(), {.dt = trial_dt},
                                       {.seconds = 0.5, .stand_distance = distance, .settle_seconds = 0});
  REQUIRE(result.fell_at.has_value());
  CHECK(*result.fell_at == 10 * trial_dt);
  CHECK(result.stands_until == 10 * trial_dt);
  CHECK_FALSE(result.stands());
  const TrialResult shorter =
      run_trial(falling_disc(), {.dt = trial_dt},
                {.seconds = 9 * trial_dt, .stand_distance = distance, .settle_seconds = 0});
  CHECK(shorter.stands());
  CHECK(shorter.stands_until == 9 * trial_dt);
}

TEST_CASE("only steps are timed, by the clock that was given") {
  int readings = 0;
  TrialOptions options{.seconds = 0.5};
  options.clock = [&] { return 0.25 * readings++; };  // every reading a quarter of a second later
  const TrialResult result = run_trial(falling_disc(), {.dt = trial_dt}, options);
  CHECK(readings == 2 * 32 + 2);  // and what comes before the first
  CHECK(result.step_seconds == 0.25 * 32);
  CHECK(result.cost() == 16);

  readings = 0;
  options.time_limit = 2;  // more than it after 9 steps
  const TrialResult late = run_trial(falling_disc(), {.dt = trial_dt}, options);
  CHECK(late.status == TrialStatus::timeout);
  CHECK(late.steps == 9);
  CHECK(thread_cpu_seconds() > 0);
}

TEST_CASE("row updates are rows times sweeps, over substeps and the second solves of a policy") {
  const auto updates = [](const Setting& setting) {
    return run_trial(resting_discs(3), setting, {.seconds = 5 * setting.dt}).row_updates;
  };
  CHECK(updates({.sweeps = {.iterations = 7}}) == 5 * 6 * 7 * 2);
  CHECK(updates({.sweeps = {.iterations = 7}, .substeps = 3}) == 5 * 6 * 7 * 3 * 2);
  CHECK(updates({.sweeps = {.iterations = 7},
                 .substeps = 3,
                 .stabilization = {.policy = StabilizationPolicy::soft}}) == 5 * 6 * 7 * 3 * 2);
  CHECK(updates({.sweeps = {.iterations = 7},
                 .stabilization = {.policy = StabilizationPolicy::split_impulse}}) == 5 * 6 * 7 * 2);
  CHECK(updates({.sweeps = {.iterations = 7}, .stabilization = {.policy = StabilizationPolicy::baumgarte}}) ==
        5 * 6 * 7);
}

TEST_CASE("the same run has the same hash, and any other has another") {
  const Scene stack = scene_entry("stack").make();
  const TrialOptions options{.seconds = 0.5};
  const std::uint64_t hash = run_trial(stack, {}, options).state_hash;
  CHECK(run_trial(stack, {}, options).state_hash == hash);
  CHECK(run_trial(stack, {.sweeps = {.iterations = 11}}, options).state_hash != hash);
  CHECK(run_trial(stack, {.scalar = Precision::single_precision}, options).state_hash != hash);
  CHECK(run_trial(jittered(stack, 1e-6, 1), {}, options).state_hash != hash);
}

TEST_CASE("the hash is FNV-1a over poses and velocities, byte by byte") {
  // The ground and one body at rest at the origin: 12 zeros of 8 bytes. A byte of 0 only multiplies.
  Scene scene;
  scene.add({.shapes = {circle(1)}});
  std::uint64_t expected = 14695981039346656037U;
  for (int i = 0; i < 12 * 8; ++i) expected *= 1099511628211U;
  CHECK(make_contestant(scene, {})->state_hash() == expected);
}

TEST_CASE("R_E is measured where it is asked for, and is that of the solves of the run") {
  const Scene stack = scene_entry("stack").make();
  CHECK_FALSE(run_trial(stack, {}, {.seconds = 0.1}).worst_residual.has_value());
  const TrialOptions options{.seconds = 1, .residual = ResidualMeasure::every_step};
  const TrialResult few = run_trial(stack, {.sweeps = {.iterations = 5}}, options);
  const TrialResult exact = run_trial(
      stack, {.solver = "accelerated", .sweeps = {.iterations = 100000, .tolerance = 1e-9}}, options);
  CHECK(*exact.worst_residual <= 1e-9);
  CHECK(*few.mean_residual > 1e-3);  // 184 sweeps would bring it to 1e-2
  CHECK(*few.worst_residual >= *few.mean_residual);
  // Measuring changes nothing.
  CHECK(few.state_hash == run_trial(stack, {.sweeps = {.iterations = 5}}, {.seconds = 1}).state_hash);
  // No impulses at all: 1 by definition.
  const TrialResult none = run_trial(stack, {.sweeps = {.iterations = 0}},
                                     {.seconds = 1.0 / 60, .residual = ResidualMeasure::every_step});
  CHECK(*none.worst_residual == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("a solver that diverges is a result: what became of it, and when") {
  // Speeds of g dt = 1/6 m/s times 2^60, and times 2^2000: beyond the largest double, 2^1024.
  const auto run = [](const char* solver, int sweeps) {
    const Setting setting{.solver = solver, .sweeps = {.iterations = sweeps}};
    return run_trial(disc_on_three_pins(), setting, {.seconds = 1});
  };
  const TrialResult fast = run("jacobi", 60);
  CHECK(fast.status == TrialStatus::diverged);
  CHECK(fast.steps == 1);
  CHECK_FALSE(fast.stands());
  const TrialResult not_a_number = run("jacobi", 2000);
  CHECK(not_a_number.status == TrialStatus::nan);
  CHECK(not_a_number.steps == 1);
  CHECK(std::isinf(not_a_number.farthest));
  CHECK(not_a_number.worst_penetration == 0);  // of the steps before
  CHECK(run("jacobi-split", 60).status == TrialStatus::ok);
}

TEST_CASE("a run diverges by energy that nothing explains, and not by speed") {
  Scene scene({.gravity = {0, 0}});
  scene.add({.shapes = {circle(1)}, .velocity = {0, 1e9}, .angular_velocity = 2094});
  CHECK(run_trial(scene, {}, {}).status == TrialStatus::ok);
  const TrialResult result = run_trial(scene, {}, {.most_energy = 0.99});
  CHECK(result.status == TrialStatus::diverged);
  CHECK(result.steps == 1);
  CHECK(status_text(result.status) == "diverged");
  // Jacobi makes g dt = 1/6 m/s downwards (-2)^n times as much in n sweeps, upwards where n is odd. The scale
  // is what a fall through the diagonal gives, sqrt(8) m: 752 m/s are a hundred times as fast, and 2^11 / 6
  // is less, 2^13 / 6 more.
  const auto after = [](int sweeps) {
    const Setting setting{.solver = "jacobi", .sweeps = {.iterations = sweeps}};
    return run_trial(disc_on_three_pins(), setting, {.seconds = setting.dt}).status;
  };
  CHECK(after(11) == TrialStatus::ok);
  CHECK(after(13) == TrialStatus::diverged);
}

TEST_CASE("what a motor and a body that moves by itself give is explained") {
  // 1 kg m^2 comes to 2000 rad/s: 2 MJ in a scene that has nothing else.
  Scene driven({.gravity = {0, 0}});
  const BodyId rotor = driven.add({.shapes = {circle(0.05)}, .mass = 1, .inertia = 1});
  driven.join<RevoluteJoint>({.b = rotor, .motor = RevoluteJoint::Motor{.speed = 2000, .max_torque = 1e5}});
  CHECK(run_trial(driven, {}, {.seconds = 1}).status == TrialStatus::ok);
  // An elastic ball meets a wall that comes at 500 m/s: 1000 m/s.
  Scene met({.gravity = {0, 0}, .dt = 1e-4});
  met.add({.type = BodyType::kinematic, .shapes = {box(1, 4)}, .velocity = {500, 0}});
  met.add({.shapes = {circle(0.5)}, .position = {1.2, 0}, .material = {.restitution = 1}});
  const TrialResult result = run_trial(met, {.dt = 1e-4}, {.seconds = 0.01});
  CHECK(result.status == TrialStatus::ok);
  CHECK(result.farthest > 1);
}

TEST_CASE("a problem too large for the solver is a refusal, with its reason") {
  const int discs = solver_entry("pgs").max_rows / 2 + 1;
  const TrialResult result = run_trial(resting_discs(discs), {.solver = "pgs"}, {.seconds = 0.1});
  CHECK(result.status == TrialStatus::refused);
  CHECK(result.steps == 0);
  CHECK_FALSE(result.reason.empty());
}

TEST_CASE("too many shapes in one place are a refusal, whoever steps them") {
  Scene scene;
  for (int i = 0; i < 1500; ++i) scene.add({.shapes = {circle(1)}});
  for (const std::string solver : {"si", "box2d"}) {
    if (solver == "box2d" && !has_box2d()) continue;
    const TrialResult result = run_trial(scene, {.solver = solver}, {.seconds = 0.1});
    CHECK(result.status == TrialStatus::refused);
    CHECK(result.reason.find("more than 1000000 pairs of shapes") != std::string::npos);
  }
}

TEST_CASE("options out of range and settings that nothing runs under are refused by exceptions") {
  const Scene scene = falling_disc();
  CHECK_THROWS_AS(run_trial(scene, {.solver = "sj"}), std::invalid_argument);
  CHECK_THROWS_AS(run_trial(scene, {.dt = -1}), std::invalid_argument);
  CHECK_THROWS_AS(run_trial(scene, {}, {.seconds = -1}), std::invalid_argument);
  CHECK_THROWS_AS(run_trial(scene, {}, {.seconds = NAN}), std::invalid_argument);
  CHECK_THROWS_AS(run_trial(scene, {}, {.stand_distance = -1}), std::invalid_argument);
  CHECK_THROWS_AS(run_trial(scene, {}, {.settle_seconds = -1}), std::invalid_argument);
  CHECK_THROWS_AS(run_trial(scene, {}, {.penetration_every = 0}), std::invalid_argument);
  CHECK_THROWS_AS(run_trial(scene, {}, {.most_energy = NAN}), std::invalid_argument);
  CHECK_THROWS_AS(run_trial(scene, {}, {.time_limit = -1}), std::invalid_argument);
}

TEST_CASE("what an observer throws is its own, and no refusal") {
  TrialOptions options;
  options.observer = [](const Snapshot&) { throw std::invalid_argument("seen enough"); };
  CHECK_THROWS_WITH(run_trial(falling_disc(), {}, options), "seen enough");
}

TEST_CASE("a trial steps as a world does that is stepped by hand") {
  Scene scene = scene_entry("pyramid").make();
  const Setting setting{.sweeps = {.iterations = 8}, .dt = 1.0 / 120, .substeps = 2};
  Snapshot last;
  TrialOptions options{.seconds = 0.25};
  options.observer = [&](const Snapshot& now) { last = now; };
  run_trial(scene, setting, options);
  SceneSettings settings = scene.settings();
  settings.dt = 1.0 / 120;
  settings.substeps = 2;
  scene.set_settings(settings);
  World world(scene);
  SequentialImpulse<double> solver({.iterations = 8});
  for (int step = 0; step < 30; ++step) world.step(solver);
  for (const BodyId body : last.bodies.indices()) {
    CHECK(last.bodies[body].velocity == world.bodies().velocity[body]);
    CHECK(last.bodies[body].pose.position == world.bodies().pose[body].position);
  }
}

TEST_CASE("a small weight on a far pin holds where a scene file names no solver") {
  const SceneEntry hung = read_scene_text(
      "[[body]]\nname = \"bob\"\nbox = [0.1, 0.1]\nmass = 1\nposition = [1, 0]\n"
      "[[joint]]\ntype = \"revolute\"\nb = \"bob\"\nanchor = [0, 0]\n",
      "pendulum.toml");
  Setting setting = hung.setting;
  CHECK(setting.substeps == 4);
  setting.substeps = 1;
  const TrialResult result = run_trial(hung.make(), setting, {.seconds = 2});
  CHECK(result.failures.empty());
  // A step along the tangent at the lowest point, at sqrt(2 g r), leaves the arc by (v dt)^2 / (2 r).
  CHECK(result.worst_drift <= 10 * setting.dt * setting.dt);
}
