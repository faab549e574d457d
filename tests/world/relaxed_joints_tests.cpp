// Joints that no solver has solved to the end: what Baumgarte makes of their errors, and what the policy
// relaxed does, which scenes have where nothing is said.
#include <cairn/samples/samples.hpp>
#include "testing.hpp"

using namespace cairn;

namespace {

SceneSettings plain_baumgarte(int substeps = 1) {
  return {.substeps = substeps, .stabilization = {.policy = StabilizationPolicy::baumgarte}};
}

/// Slender rods of 1 m, one below the other, at rest and damped: nothing has a reason to move.
Scene hanging_rods(const SceneSettings& settings) {
  Scene scene(settings);
  const BodySpec rod = {
      .shapes = {box(0.05, 1)}, .position = {0, -0.5}, .damping = {.linear = 1, .angular = 1}};
  samples::add_chain(scene, 20, rod, {0, -1});
  return scene;
}

/// Links from a pin to the right, level; each stands `open` m away from the one before [m].
Scene level_chain(int links, double open, const SceneSettings& settings) {
  Scene scene(settings);
  samples::add_chain(scene, links, {.shapes = {box(1, 0.2)}, .position = {0.5, 0}}, {1, 0});
  for (int i = 0; i < links && open > 0; ++i) displace(scene, {i + 1}, {open * (i + 1), 0});
  return scene;
}

/// Discs in rows and columns, each pinned to those beside and above it; the upper corners are fixed.
Scene net_of_discs(int side, const SceneSettings& settings) {
  Scene scene(settings);
  const auto id = [side](int row, int column) { return BodyId{1 + row * side + column}; };
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const bool fixed = row == 0 && (column == 0 || column == side - 1);
      scene.add({.type = fixed ? BodyType::static_body : BodyType::dynamic,
                 .shapes = {circle(0.4)},
                 .position = {1.0 * column, -1.0 * row},
                 .filter = {.collides_with = 0}});
      if (column > 0)
        scene.join<RevoluteJoint>(
            {.a = id(row, column - 1), .b = id(row, column), .anchor = {column - 0.5, -1.0 * row}});
      if (row > 0)
        scene.join<RevoluteJoint>(
            {.a = id(row - 1, column), .b = id(row, column), .anchor = {1.0 * column, 0.5 - row}});
    }
  }
  return scene;
}

struct PassiveRun {
  double gain = 0;         // [J] of energy over the start, at most
  double last_speed = 0;   // [m/s] of the fastest body at the end
  double worst_error = 0;  // [m] of a joint, at any time
  double last_error = 0;   // [m]
};

PassiveRun run_passive(const Scene& scene, Solver<double>& solver, int steps) {
  World<double> world(scene);
  PassiveRun run;
  const double start = total_energy(snapshot(world));
  for (int step = 0; step < steps; ++step) {
    if (world.step(solver).not_finite) {
      run.gain = std::numeric_limits<double>::infinity();
      break;
    }
    run.gain = std::max(run.gain, total_energy(snapshot(world)) - start);
    run.last_error = worst_joint_drift(snapshot(world));
    run.worst_error = std::max(run.worst_error, run.last_error);
  }
  for (const Vec3<double>& v : world.bodies().velocity)
    run.last_speed = std::max(run.last_speed, v.head<2>().norm());
  return run;
}

/// Calls visit(solver, its name) for solvers that stop before their answer, and for one that does not.
template <typename Visit>
void with_each_solver(const Visit& visit) {
  SequentialImpulse<double> four({.iterations = 4}), ten({.iterations = 10});
  SequentialImpulse<double> easily_content({.iterations = 10, .tolerance = 0.5});
  BlockSequentialImpulse<double> block({.iterations = 10});
  AcceleratedProjectedGaussSeidel<double> accelerated({.iterations = 10});
  NewtonSolver<double> newton({.iterations = 50, .tolerance = 1e-6});
  for (Solver<double>* solver :
       std::initializer_list<Solver<double>*>{&four, &ten, &easily_content, &block, &accelerated, &newton}) {
    const std::string name = solver->name();
    CAPTURE(name);
    visit(*solver);
  }
}

/// [J] What gravity could give: all of the weight, from the highest place to the lowest that joints allow.
double weight_times_height(const Scene& scene, double height) {
  double mass = 0;
  for (const SceneBody& body : scene.bodies()) mass += body.mass;
  return mass * scene.settings().gravity.norm() * height;
}

}  // namespace

TEST_CASE("slender rods that hang at rest shake for ever under Baumgarte, and rest where nothing is said") {
  SequentialImpulse<double> ten({.iterations = 10});
  const PassiveRun shaken = run_passive(hanging_rods(plain_baumgarte()), ten, 600);
  const double most = 0.01 * weight_times_height(hanging_rods({}), 20);
  CHECK(shaken.gain > most);
  CHECK(shaken.last_speed > 0.5);
  for (const int substeps : {1, 4}) {
    with_each_solver([&](Solver<double>& solver) {
      const PassiveRun run = run_passive(hanging_rods({.substeps = substeps}), solver, 600);
      CHECK(run.gain <= most);
      CHECK(run.last_speed <= 0.01);
    });
  }
}

TEST_CASE("a net of discs explodes under Baumgarte in substeps, and gains nothing where nothing is said") {
  SequentialImpulse<double> ten({.iterations = 10});
  const double most = 0.01 * weight_times_height(net_of_discs(12, {}), 12);
  const PassiveRun exploded = run_passive(net_of_discs(12, plain_baumgarte(4)), ten, 60);
  CHECK(exploded.gain > 100 * most);
  for (const int substeps : {1, 4}) {
    with_each_solver([&](Solver<double>& solver) {
      const PassiveRun run = run_passive(net_of_discs(12, {.substeps = substeps}), solver, 60);
      CHECK(run.gain <= most);
    });
  }
}

TEST_CASE("a level chain of sixty links falls in four substeps without energy from nowhere") {
  const double most = 0.01 * weight_times_height(level_chain(60, 0, {}), 60);
  with_each_solver([&](Solver<double>& solver) {
    const PassiveRun run = run_passive(level_chain(60, 0, {.substeps = 4}), solver, 240);
    CHECK(run.gain <= most);
    CHECK(run.worst_error <= 0.05);  // a quarter of a link's thickness: past that a joint has failed
  });
}

TEST_CASE("joints that begin open are drawn together, and their bodies gain no more than what lifts them") {
  const double open = 0.7;
  const int links = 20;
  // A body is drawn to its place along its joints' gaps, and lifted by them at most.
  double lifted = 0;
  const Scene scene = level_chain(links, open, {});
  for (int i = 1; i <= links; ++i)
    lifted += scene.bodies()[{i}].mass * scene.settings().gravity.norm() * open * i;
  SequentialImpulse<double> ten({.iterations = 10});
  CHECK(run_passive(level_chain(links, open, plain_baumgarte()), ten, 240).gain > lifted);
  for (const int substeps : {1, 4}) {
    with_each_solver([&](Solver<double>& solver) {
      const PassiveRun run = run_passive(level_chain(links, open, {.substeps = substeps}), solver, 240);
      CHECK(run.gain <= lifted);
    });
  }
}

TEST_CASE("a rotor's pin stays shut under the policy relaxed, and its centre moves along chords") {
  for (const int rate : {60, 120, 240}) {
    Scene scene(
        {.gravity = {0, 0}, .dt = 1.0 / rate, .stabilization = {.policy = StabilizationPolicy::relaxed}});
    const double spin = 5;  // [rad/s]
    const BodyId disc = scene.add({.shapes = {circle(0.5)},
                                   .position = {1, 0},
                                   .velocity = {0, spin},
                                   .angular_velocity = spin,
                                   .mass = 1,
                                   .inertia = 0.125});
    scene.join<RevoluteJoint>({.a = ground, .b = disc, .anchor = {0, 0}});
    NewtonSolver<double> newton({.iterations = 50, .tolerance = 1e-12});
    World<double> world(scene);
    const double before = total_energy(snapshot(world));
    for (int step = 0; step < 4 * rate; ++step) world.step(newton);
    // What the first step leaves open goes by a share beta in each: 0.8^240 of it is left.
    CHECK(worst_joint_drift(snapshot(world)) <= 1e-14);
    // The centre moves along chords: beside its speed v along the tangent on which a step begins it has one
    // of v tan(w dt / 2) inwards. Its energy shows that after the first step, and does not change again.
    const double half_angle = spin / rate / 2, of_centre = 1 / (1 + 0.125);
    const double more = total_energy(snapshot(world)) / before - 1;
    CHECK(more == doctest::Approx(of_centre * half_angle * half_angle).epsilon(4 * half_angle));
  }
}
