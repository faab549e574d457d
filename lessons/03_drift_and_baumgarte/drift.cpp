// Runs the three scenes with the library's own step and solver, and the same by hand where that is possible.
#include "drift.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace cairn::drift {

namespace {

/// One row, so one sweep is all it takes.
World<double> one_row_world(const Scene& scene) { return World<double>(scene); }

/// Equation (7) as it stands: without the cap that Cairn puts on it where nobody asks otherwise.
SceneSettings scene_settings(double dt, double beta, double slop = 0) {
  return {.gravity = {0, -gravity},
          .dt = dt,
          .stabilization = {
              .baumgarte = beta, .slop = slop, .max_speed = std::numeric_limits<double>::infinity()}};
}

/// A weight of 1 kg on a rod from the origin, `too_low` metres too far away in the direction `towards`.
Scene rod_scene(const SceneSettings& settings, const Vec2<double>& towards, double too_low) {
  Scene scene(settings);
  const BodyId body =
      scene.add({.shapes = {circle(0.12)}, .position = towards * (rod_length + too_low), .mass = 1});
  scene.join<DistanceJoint>({.a = ground,
                             .b = body,
                             .anchor_a = {0, 0},
                             .anchor_b = towards * (rod_length + too_low),
                             .length = rod_length});
  return scene;
}

/// How much too long the rod would be one step on: it moves by (zeta dt, v dt) along and across the rod.
double error_by_geometry(const SwingRun& run, double error, double across, double dt) {
  return std::hypot(rod_length + (1 - run.beta) * error, across * dt) - rod_length;
}

SwingRun run_swing(const DriftSettings& settings, double beta) {
  World<double> world = one_row_world(rod_scene(scene_settings(settings.dt, beta), {1, 0}, 0));
  SequentialImpulse<double> solver({.iterations = 1});
  SwingRun run{.beta = beta, .steps = {snapshot(world)}, .error = {0}};
  const int steps = static_cast<int>(std::lround(swing_time / settings.dt));
  for (int k = 1; k <= steps; ++k) {
    const Vec2<double> along = world.bodies().pose[1].position.normalized();
    world.step(solver);
    const Vec2<double> velocity = world.bodies().velocity[1].head<2>();
    const double across = along.x() * velocity.y() - along.y() * velocity.x();
    run.fastest = std::max(run.fastest, std::abs(across));
    const double expected = error_by_geometry(run, run.error.back(), across, settings.dt);
    run.steps.push_back(snapshot(world));
    run.error.push_back(world.bodies().pose[1].position.norm() - rod_length);
    run.gap = std::max(run.gap, std::abs(run.error.back() - expected));
  }
  run.energy = total_energy(run.steps.back());
  return run;
}

HangRun run_hang(const DriftSettings& settings, double beta) {
  World<double> world = one_row_world(rod_scene(scene_settings(settings.dt, beta), {0, -1}, hang_error));
  SequentialImpulse<double> solver({.iterations = 1});
  HangRun run{.beta = beta, .steps = {snapshot(world)}, .error = {hang_error}};
  for (int k = 1; k <= hang_steps; ++k) {
    world.step(solver);
    run.steps.push_back(snapshot(world));
    run.error.push_back(world.bodies().pose[1].position.norm() - rod_length);
  }
  return run;
}

World<double> ball_world(const DriftSettings& settings, double slop) {
  SceneSettings rules = scene_settings(settings.dt, settings.beta, slop);
  // Wider than the way of one step, so that a falling ball stops at the surface and not below it.
  rules.speculative_margin = 2 * deepest_tried;
  Scene scene(rules);
  scene.add_ground({.friction = 0});
  scene.add({.shapes = {circle(ball_radius)},
             .position = {0, ball_radius - settings.depth},
             .mass = 1,
             .friction = 0,
             .fixed_rotation = true});
  return one_row_world(scene);
}

/// One step of the ball on paper: gravity, and then at least the speed that (7) asks for.
struct HandBall {
  double height = 0;
  double speed = 0;
};
HandBall step_by_hand(const HandBall& ball, const DriftSettings& settings, double slop) {
  const double zeta = ball.height > 0 ? -ball.height / settings.dt
                                      : settings.beta * std::max(0.0, -ball.height - slop) / settings.dt;
  const double speed = std::max(ball.speed - gravity * settings.dt, zeta);
  return {ball.height + speed * settings.dt, speed};
}

double height_of(const World<double>& world) { return world.bodies().pose[1].position.y() - ball_radius; }

BallRun run_ball(const DriftSettings& settings, double slop, int steps) {
  World<double> world = ball_world(settings, slop);
  SequentialImpulse<double> solver({.iterations = 1});
  BallRun run{.beta = settings.beta,
              .slop = slop,
              .steps = {snapshot(world)},
              .height = {-settings.depth},
              .speed = {0},
              .zeta = {0},
              .lambda = {0},
              .peak = -settings.depth};
  HandBall by_hand{.height = -settings.depth};
  for (int k = 1; k <= steps; ++k) {
    world.step(solver);
    by_hand = step_by_hand(by_hand, settings, slop);
    const VelocityProblem<double>& problem = world.last_step().problem;
    run.steps.push_back(snapshot(world));
    run.height.push_back(height_of(world));
    run.speed.push_back(world.bodies().velocity[1].y());
    run.zeta.push_back(problem.rows.empty() ? 0 : problem.rows[0].bias);
    run.lambda.push_back(problem.rows.empty() ? 0 : problem.impulse[0] / problem.dt);
    run.peak = std::max(run.peak, run.height.back());
    run.gap = std::max(run.gap, std::abs(run.height.back() - by_hand.height));
  }
  return run;
}

/// Whether the ground pushes in the second step too.
bool is_held(const DriftSettings& settings) {
  World<double> world = ball_world(settings, 0);
  SequentialImpulse<double> solver({.iterations = 1});
  world.step(solver);
  world.step(solver);
  return world.last_step().problem.impulse[0] > 0;
}

DepthLimit find_limit(double dt, double beta) {
  double held = 0;
  double let_go = deepest_tried;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (held + let_go);
    (is_held({.dt = dt, .beta = beta, .depth = middle}) ? held : let_go) = middle;
  }
  return {.beta = beta, .formula = limit_by_formula(dt, beta), .measured = held};
}

/// In ascending order, each once.
std::vector<double> betas(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

template <typename Run>
const Run& run_of(const std::vector<Run>& runs, double beta) {
  for (const Run& run : runs) {
    if (run.beta == beta) return run;
  }
  throw std::logic_error("run_of: no run with this beta");
}

}  // namespace

DriftRuns run_drift(const DriftSettings& settings) {
  DriftRuns all{.settings = settings};
  for (const double beta : betas({0, settings.beta, 1})) all.swings.push_back(run_swing(settings, beta));
  for (const double beta : betas({settings.beta, 1, 1.8, 2.1})) {
    all.hangs.push_back(run_hang(settings, beta));
  }
  // The longest flight, up and down, and time to calm down.
  const int steps = 30 + static_cast<int>(2 * settings.depth / (gravity * settings.dt * settings.dt));
  for (const double beta : betas({0.1, settings.beta, 0.5, 1})) {
    all.balls.push_back(run_ball({settings.dt, beta, settings.depth}, 0, steps));
  }
  // Not deeper than the ground can hold it.
  const double depth =
      std::min(settings.depth, slop_tried + 0.9 * limit_by_formula(settings.dt, settings.beta));
  all.with_slop = run_ball({settings.dt, settings.beta, depth}, slop_tried, 200);
  for (const double beta : betas({0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1, settings.beta})) {
    if (limit_by_formula(settings.dt, beta) > 0.9 * deepest_tried) continue;
    all.limits.push_back(find_limit(settings.dt, beta));
  }
  return all;
}

const SwingRun& swing_of(const DriftRuns& all, double beta) { return run_of(all.swings, beta); }
const HangRun& hang_of(const DriftRuns& all, double beta) { return run_of(all.hangs, beta); }
const BallRun& ball_of(const DriftRuns& all, double beta) { return run_of(all.balls, beta); }

double limit_by_formula(double dt, double beta) { return gravity * dt * dt / (beta * beta); }

double hop_by_formula(const DriftSettings& settings) {
  // v = d / dt after the first step, and g dt less after every further one: n steps upwards.
  const double fall = gravity * settings.dt * settings.dt;
  const double n = std::floor(settings.depth / fall);
  return n * settings.depth - fall * n * (n + 1) / 2;
}

}  // namespace cairn::drift
