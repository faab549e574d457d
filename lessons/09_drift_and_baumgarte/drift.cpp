// The three worlds, what is noted of them, and how deep a ball may begin.
#include "lesson.hpp"

namespace cairn::drift {

namespace {

/// Equation (7) as it stands: without what Cairn adds to it where nobody asks otherwise, which are the cap
/// and the second solve.
SceneSettings scene_settings(double dt, double beta, double slop = 0) {
  return {.gravity = {0, -gravity},
          .dt = dt,
          .stabilization = {.policy = StabilizationPolicy::baumgarte,
                            .baumgarte = beta,
                            .slop = slop,
                            .max_speed = std::numeric_limits<double>::infinity()}};
}

double height_of(const World<double>& world) { return world.bodies().pose[{1}].position.y() - ball_radius; }

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

template <typename Run>
const Run& run_of(const List<Run>& runs, double beta) {
  for (const Run& run : runs) {
    if (run.beta == beta) return run;
  }
  throw std::logic_error("run_of: no run with this beta");
}

}  // namespace

World<double> rod_world(double dt, double beta, const Vec2<double>& start) {
  Scene scene(scene_settings(dt, beta));
  const BodyId body = scene.add({.shapes = {circle(0.12)}, .position = start, .mass = 1});
  scene.join<DistanceJoint>(
      {.a = ground, .b = body, .anchor_a = {0, 0}, .anchor_b = start, .length = rod_length});
  return World<double>(scene);
}

World<double> ball_world(const DriftSettings& settings, double slop) {
  SceneSettings rules = scene_settings(settings.dt, settings.beta, slop);
  // Wider than the way of one step, so that a falling ball stops at the surface and not below it.
  rules.speculative_margin = 2 * deepest_tried;
  Scene scene(rules);
  scene.add_ground({.material = {.friction = 0}});
  scene.add({.shapes = {circle(ball_radius)},
             .position = {0, ball_radius - settings.depth},
             .mass = 1,
             .material = {.friction = 0},
             .fixed_rotation = true});
  return World<double>(scene);
}

void record(BallRun& run, const World<double>& world) {
  const VelocityProblem<double>& problem = world.last_step().problem;
  const bool has_row = !problem.rows.empty();
  run.steps.push_back(snapshot(world));
  run.height.push_back(height_of(world));
  run.speed.push_back(world.bodies().velocity[{1}].y());
  run.zeta.push_back(has_row ? problem.rows[0].bias : 0);
  run.lambda.push_back(has_row ? problem.impulse[0] / problem.dt : 0);
  run.peak = std::max(run.peak, run.height.back());
}

List<double> ascending(List<double> values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

List<DepthLimit> find_limits(const DriftSettings& settings) {
  List<DepthLimit> limits;
  for (const double beta : ascending({0.1, 0.15, 0.2, 0.3, 0.5, 0.7, 1, settings.beta})) {
    if (limit_by_formula(settings.dt, beta) > 0.9 * deepest_tried) continue;
    limits.push_back(find_limit(settings.dt, beta));
  }
  return limits;
}

const RodRun& swing_of(const DriftRuns& all, double beta) { return run_of(all.swings, beta); }
const BallRun& ball_of(const DriftRuns& all, double beta) { return run_of(all.balls, beta); }

double limit_by_formula(double dt, double beta) { return gravity * dt * dt / (beta * beta); }

double hop_by_formula(const DriftSettings& settings) {
  // v = d / dt after the first step, and g dt less after every further one: n steps upwards.
  const double fall = gravity * settings.dt * settings.dt;
  const double n = std::floor(settings.depth / fall);
  return n * settings.depth - fall * n * (n + 1) / 2;
}

}  // namespace cairn::drift
