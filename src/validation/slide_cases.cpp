// Floor 8. A block that slides to a halt, and what friction turns into heat.
#include <algorithm>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/world/world.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

/// On a ground with the friction of the body, which lies on it.
Scene thrown_on_ground(BodySpec body, double height, double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add_ground({.material = {.friction = body.material.friction}});
  body.position = {0, height};
  scene.add(body);
  return scene;
}

const double slide_speed = 5;       // [m/s] v0
const double slide_friction = 0.3;  // mu
const double slide_mass = 4;        // [kg]

Scene sliding_block(double frequency) {
  return thrown_on_ground({.shapes = {box(1, 0.5)},
                           .velocity = {slide_speed, 0},
                           .mass = slide_mass,
                           .material = {.friction = slide_friction}},
                          0.25, frequency);
}

// Every step takes mu g dt from the speed, and goes as far as the speed that is left: v0 dt/2 less in all.
ValidationResult stopping_distance(const EngineMaker& make) {
  const double ideal = slide_speed * slide_speed / (2 * slide_friction * standard_gravity);
  ValidationResult result;
  const Snapshot end = run_scene(make, sliding_block(60), 50, 2);
  const std::string reason = "the sums are exact; 50 sweeps of a contact at two points leave rounding";
  result.add(measured("way until it stops at 60 Hz", end.bodies.back().pose.position.x(), "m")
                 .by("v0^2/(2 mu g) - v0 dt/2", ideal - slide_speed * standard_dt / 2)
                 .within(1e-9, reason));
  result.add(measured("speed when it has stopped", end.bodies.back().velocity.cwiseAbs().maxCoeff(), "m/s")
                 .zero_within(1e-9, reason));
  result.convergence = converges("way until it stops, to v0^2/(2 mu g)", [&](double frequency) {
    return run_scene(make, sliding_block(frequency), 50, 2).bodies.back().pose.position.x() - ideal;
  });
  return result;
}

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
  const auto steps = std::lround(seconds / world.clock().dt);
  for (long step = 0; step < steps; ++step) {
    const PerBody<Vec3<double>> before = world.bodies().velocity;
    world.step(solver);
    const VelocityProblem<double>& problem = world.last_step().problem;
    double work = 0;
    for (int i = 0; i < problem.row_count(); ++i) {
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

const std::string heat_of_all_solvers = ", worst of all Gauss-Seidel solvers";

void add_block_heat(List<Measured>& numbers) {
  const double energy = slide_mass * slide_speed * slide_speed / 2;
  List<double> heats, differences, gains;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    World<double> world(sliding_block(60));
    const FrictionAudit audit = run_with_audit(world, *make({.iterations = 50}), 2);
    heats.push_back(audit.heat);
    gains.push_back(audit.gain);
    const double way = world.bodies().pose.back().position.x();
    differences.push_back(audit.heat_by_way - slide_friction * slide_mass * standard_gravity * way);
  }
  const std::string sweeps = "50 sweeps of a contact at two points leave rounding, which 120 steps add up";
  numbers.push_back(
      measured("heat of a block that slides to a halt" + heat_of_all_solvers, farthest(energy, heats), "J")
          .by("m v0^2/2", energy)
          .within(1e-9 * energy, sweeps));
  numbers.push_back(measured("sum of impulse times way, less the heat of the way" + heat_of_all_solvers,
                             farthest(0, differences), "J")
                        .by("sum p v dt - mu m g d = 0", 0)
                        .within(1e-9 * energy, sweeps));
  numbers.push_back(measured("most that friction gave to the block in a step" + heat_of_all_solvers,
                             farthest(0, gains), "J")
                        .zero_within(1e-12 * energy, "friction never pushes on; rounding of the energy"));
}

const double audit_disc_speed = 6;  // [m/s] v0
const double audit_disc_mu = 0.2;

// A disc rolls at 2/3 v0 in the end: (1 + 1/2) 4/9 of its energy is left. It slips for v0/(3 mu g) = 1 s.
void add_disc_heat(List<Measured>& numbers) {
  const double radius = 0.5, heat = audit_disc_speed * audit_disc_speed / 6;
  const BodySpec disc{.shapes = {circle(radius)},
                      .velocity = {audit_disc_speed, 0},
                      .mass = 1,
                      .material = {.friction = audit_disc_mu}};
  List<double> slipping, rolling;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    World<double> world(thrown_on_ground(disc, radius, 60));
    const std::unique_ptr<Solver<double>> solver = make({.iterations = 10});
    slipping.push_back(run_with_audit(world, *solver, 1).heat);
    rolling.push_back(run_with_audit(world, *solver, 2).heat);
  }
  numbers.push_back(
      measured("heat of a disc thrown without spin, until it rolls" + heat_of_all_solvers,
               farthest(heat, slipping), "J")
          .by("m v0^2/6", heat)
          .within(1e-9 * heat, "the sums are exact; the rows of a disc do not act on each other"));
  numbers.push_back(
      measured("heat of the rolling that follows" + heat_of_all_solvers, farthest(0, rolling), "J")
          .zero_within(1e-12 * heat, "rolling does not slide; rounding of the energy"));
}

ValidationResult friction_heat(const EngineMaker&) {
  ValidationResult result;
  add_block_heat(result.numbers);
  add_disc_heat(result.numbers);
  const double energy = slide_mass * slide_speed * slide_speed / 2;
  result.convergence = converges("mu m g times the way of the block, to m v0^2/2", [&](double frequency) {
    World<double> world(sliding_block(frequency));
    const std::unique_ptr<Solver<double>> solver = all_solvers<double>().front()({.iterations = 50});
    return run_with_audit(world, *solver, 2).heat_by_way - energy;
  });
  return result;
}

const double belt_speed = 2;       // [m/s] s
const double belt_friction = 0.4;  // mu

/// At rest at first.
Scene block_on_belt(double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add_ground({.material = {.friction = belt_friction, .surface_speed = belt_speed}});
  scene.add({.shapes = {box(1, 0.5)},
             .position = {0, 0.25},
             .mass = slide_mass,
             .material = {.friction = belt_friction}});
  return scene;
}

// Every step adds mu g dt to the speed, and goes as far as the speed that it has then: s dt / 2 more in all.
ValidationResult belt(const EngineMaker& make) {
  const double seconds = 2, ideal = belt_speed * seconds -
                                    belt_speed * belt_speed / (2 * belt_friction * standard_gravity);
  ValidationResult result;
  const Snapshot end = run_scene(make, block_on_belt(60), 50, seconds);
  const std::string reason = "the sums are exact; 50 sweeps of a contact at two points leave rounding";
  result.add(measured("way in 2 s at 60 Hz", end.bodies.back().pose.position.x(), "m")
                 .by("s t - s^2/(2 mu g) + s dt/2", ideal + belt_speed * standard_dt / 2)
                 .within(1e-9, reason));
  result.add(measured("speed when it keeps up", end.bodies.back().velocity.x(), "m/s")
                 .by("s", belt_speed)
                 .within(1e-9, reason));
  result.convergence = converges("way in 2 s, to s t - s^2/(2 mu g)", [&](double frequency) {
    return run_scene(make, block_on_belt(frequency), 50, seconds).bodies.back().pose.position.x() - ideal;
  });
  return result;
}

}  // namespace

void add_slide_cases(ValidationCases& cases) {
  cases.push_back({.id = "B6",
                   .title = "A block that slides at v0 stops after v0^2 / (2 mu g), less v0 dt / 2",
                   .asks = Asks::any_engine,
                   .run = stopping_distance});
  cases.push_back({.id = "B7",
                   .title = "Friction turns into heat what a body loses, which is mu m g times the way slid",
                   .run = friction_heat});
  cases.push_back({.id = "B44",
                   .title = "A block laid on a belt keeps up after s / (mu g), s^2 / (2 mu g) behind",
                   .asks = Asks::any_engine,
                   .run = belt});
}

}  // namespace cairn
