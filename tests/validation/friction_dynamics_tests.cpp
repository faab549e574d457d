// What friction turns into heat, and what it does to a disc that is thrown with backspin.
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// What friction has done in a run.
struct FrictionAudit {
  double heat = 0;         // [J] taken from the bodies
  double heat_by_way = 0;  // [J] the same impulses times the way that was slid in their steps
  double gain = 0;         // [J] the most that friction gave to the bodies in any one step
};

/// Steps the world, and adds up the work of its friction rows. An impulse p that changes a sliding speed from
/// v- to v+ takes -p (v- + v+) / 2 out of the bodies, exactly; the way slid in that step is v+ dt.
FrictionAudit run_with_audit(World<double>& world, Solver<double>& solver, double seconds) {
  FrictionAudit audit;
  const int steps = static_cast<int>(std::lround(seconds / world.dt()));
  for (int step = 0; step < steps; ++step) {
    const std::vector<Vec3<double>> before = world.bodies().velocity;
    world.step(solver);
    const VelocityProblem<double>& problem = world.last_step().problem;
    double work = 0;
    for (std::size_t i = 0; i < problem.rows.size(); ++i) {
      const ConstraintRow<double>& row = problem.rows[i];
      if (!row.bounds.is_friction()) continue;
      const double after = row_velocity(problem, row);
      work += problem.impulse[i] * (row_velocity(problem, row, before) + after) / 2;
      audit.heat_by_way -= problem.impulse[i] * after;
    }
    audit.heat -= work;
    audit.gain = std::max(audit.gain, work);
  }
  return audit;
}

/// On a ground with the friction of the body, which lies on it.
World<double> thrown_on_ground(BodySpec body, double height, double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add_ground({.friction = body.friction});
  body.position = {0, height};
  scene.add(body);
  return World(scene);
}

const double backspin_radius = 0.5;    // [m]
const double backspin_friction = 0.2;  // mu
const double backspin_speed = 3;       // [m/s] v0

/// A disc that is thrown to the right at v0, and turns as if it rolled to the left at `rim` = R w0 [m/s].
World<double> disc_with_backspin(double rim, double frequency) {
  return thrown_on_ground({.shapes = {circle(backspin_radius)},
                           .velocity = {backspin_speed, 0},
                           .angular_velocity = rim / backspin_radius,
                           .mass = 2,
                           .inertia = backspin_radius * backspin_radius,  // m R^2 / 2
                           .friction = backspin_friction},
                          backspin_radius, frequency);
}

/// When it begins to roll [s]: the rim slides at v0 + R w0, and friction takes 3 mu g of that a second.
double rolling_begins(double rim) { return (backspin_speed + rim) / (3 * backspin_friction * test_gravity); }

}  // namespace

// B7
TEST_CASE("friction turns all of m v0^2 / 2 into heat, which is mu m g times the way slid, to first order") {
  const double v0 = 5, mu = 0.3, mass = 4;
  const BodySpec block{.shapes = {box(1, 0.5)}, .velocity = {v0, 0}, .mass = mass, .friction = mu};
  const double energy = mass * v0 * v0 / 2;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    World world = thrown_on_ground(block, 0.25, 60);
    const auto solver = make({.iterations = 50});
    const FrictionAudit audit = run_with_audit(world, *solver, 2);
    // 50 sweeps of a contact at two points leave rounding, which 120 steps add up.
    CHECK(audit.heat == doctest::Approx(energy).epsilon(1e-9));
    CHECK(audit.heat_by_way ==
          doctest::Approx(mu * mass * test_gravity * pose_of(world, {1}).position.x()).epsilon(1e-9));
    CHECK(audit.gain <= 1e-12 * energy);
  }
  check_first_order([&](double frequency) {
    World world = thrown_on_ground(block, 0.25, frequency);
    SequentialImpulse<double> solver({.iterations = 50});
    return run_with_audit(world, solver, 2).heat_by_way - energy;
  });
}

// B7
TEST_CASE("a disc that is thrown without spin loses a third of its energy until it rolls, and then no more") {
  const double v0 = 6, mu = 0.2, radius = 0.5;
  const BodySpec disc{.shapes = {circle(radius)}, .velocity = {v0, 0}, .mass = 1, .friction = mu};
  const double heat = v0 * v0 / 2 / 3;  // it rolls at 2/3 v0: (1 + 1/2) 4/9 of the energy is left
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    World world = thrown_on_ground(disc, radius, 60);
    const auto solver = make({});
    // It slips for v0 / (3 mu g) = 1 s, and rolls for the rest: rolling makes no heat.
    CHECK(run_with_audit(world, *solver, 1).heat == doctest::Approx(heat).epsilon(1e-9));
    CHECK(std::abs(run_with_audit(world, *solver, 2).heat) <= 1e-12 * heat);
  }
  check_first_order([&](double frequency) {
    World world = thrown_on_ground(disc, radius, frequency);
    SequentialImpulse<double> solver;
    return run_with_audit(world, solver, 3).heat_by_way - heat;  // mu m g times the way slipped
  });
}

// B9
TEST_CASE("a disc with backspin w0 comes to roll at (2 v0 - R w0) / 3, and returns iff R w0 > 2 v0") {
  const double v0 = backspin_speed;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double rim : {0.5 * v0, 1.9 * v0, 2 * v0, 2.1 * v0, 4 * v0}) {
      CAPTURE(rim);
      World world = disc_with_backspin(rim, 60);
      const auto solver = make({});
      run(world, *solver, rolling_begins(rim) + 0.1);
      const Vec3<double> v = velocity_of(world, {1});
      const double rolling = (2 * v0 - rim) / 3;
      // The discrete sums are exact, and the two rows of a disc do not act on each other.
      CHECK(std::abs(v.x() - rolling) <= 1e-9 * v0);
      CHECK(std::abs(v.z() * backspin_radius + rolling) <= 1e-9 * v0);
      const double x = pose_of(world, {1}).position.x();
      run(world, *solver, 1);
      CHECK(pose_of(world, {1}).position.x() - x == doctest::Approx(rolling).epsilon(1e-9));
    }
  }
}

// B9
TEST_CASE("a disc with backspin has come v0 t - mu g t^2 / 2 far when it begins to roll, to first order") {
  for (const double rim : {backspin_speed, 3 * backspin_speed}) {
    const double t = rolling_begins(rim);  // 1 s and 2 s: whole numbers of steps
    const double pull = backspin_friction * test_gravity;
    const double ideal = backspin_speed * t - pull * t * t / 2;
    const auto way = [=](double frequency) {
      World world = disc_with_backspin(rim, frequency);
      SequentialImpulse<double> solver;
      run(world, solver, t);
      return pose_of(world, {1}).position.x();
    };
    // The speed of a step is that at its end: friction acts for dt / 2 longer on every way.
    CHECK(std::abs(way(60) - (ideal - pull * t * test_dt / 2)) <= 1e-9);
    check_first_order([&](double frequency) { return way(frequency) - ideal; });
  }
}
