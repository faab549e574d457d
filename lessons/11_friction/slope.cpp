// Lesson 11. A block on a slope, observed; and what two engines make of it.
#include "lesson.hpp"

namespace cairn::friction {

namespace {

double downhill_speed(const Slope& slope, const Snapshot& snapshot) {
  return slope.downhill().dot(snapshot.bodies[first_block].velocity.head<2>());
}

double downhill_way(const Slope& slope, const Snapshot& start, const Snapshot& now) {
  return slope.downhill().dot(now.bodies[first_block].pose.position -
                              start.bodies[first_block].pose.position);
}

List<Snapshot> cairn_run(const Scene& scene, const Slope& slope) {
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = slope.sweeps});
  List<Snapshot> frames = {snapshot(world)};
  for (int step = 1; step <= slope.steps; ++step) {
    world.step(solver);
    frames.push_back(snapshot(world));
  }
  return frames;
}

List<Snapshot> run_in(Engine engine, const Slope& slope, const Block& block) {
  const Scene scene = slope_scene(slope, block);
  return engine == Engine::cairn ? cairn_run(scene, slope) : box2d_run(scene, slope.steps, slope.sweeps);
}

}  // namespace

void look(const World<double>& world, Slide& slide) {
  slide.time.push_back(slide.frames.size() * slide.slope.dt);
  slide.frames.push_back(snapshot(world));
  slide.speed.push_back(downhill_speed(slide.slope, slide.frames.back()));
  slide.way.push_back(downhill_way(slide.slope, slide.frames.front(), slide.frames.back()));
}

void judge_rows(const World<double>& world, Slide& slide) {
  const VelocityProblem<double>& problem = world.last_step().problem;
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<double>& row = problem.rows[i];
    if (!row.bounds.is_friction()) continue;
    const double lambda = problem.impulse[i] / problem.dt;
    const double load = problem.impulse[row.bounds.normal_row] / problem.dt;
    slide.worst_cone = std::max(slide.worst_cone, std::abs(lambda) - row.bounds.friction * load);
    slide.largest_power = std::max(slide.largest_power, lambda * row_velocity(problem, row));
  }
}

void ask_box2d(Slide& slide) {
  if (!has_box2d()) return;
  const Slope& slope = slide.slope;
  slide.box2d_frames = box2d_run(slope_scene(slope, slide.block), slope.steps, slope.sweeps);
  for (const Snapshot& frame : slide.box2d_frames) slide.box2d_speed.push_back(downhill_speed(slope, frame));
}

double way_in(Engine engine, const Slope& slope, const Block& block) {
  const List<Snapshot> frames = run_in(engine, slope, block);
  return downhill_way(slope, frames.front(), frames.back());
}

double critical_angle(Engine engine, Slope slope, const Block& block, double low, double high) {
  while (high - low > 0.001 * pi / 180) {
    slope.angle = (low + high) / 2;
    // An angle d above the critical one gives g d (cos + mu sin) t^2 / 2: 1 mm in 2 s for 0.003 degrees.
    (way_in(engine, slope, block) > 1e-3 ? high : low) = slope.angle;
  }
  return (low + high) / 2;
}

// All that the lesson computes, before it tells or draws anything.

namespace {

constexpr double degree = pi / 180;

/// A slope on which the faster block has room until the end.
Slope long_enough(Slope slope, const Block& block) {
  const double time = slope.steps * slope.dt;
  const double way = coulomb(slope, block).acceleration * time * (time + slope.dt) / 2;
  slope.length = std::max(slope.length, block.from_top + way + 1);
  return slope;
}

Threshold make_threshold(const Slope& slope, double friction) {
  const double formula = std::atan(friction);
  const double low = std::max(0.5 * degree, formula - 4 * degree);
  const double high = formula + 4 * degree;
  const Block block = {.friction = friction};
  Threshold result = {.friction = friction, .formula = formula / degree};
  result.cairn = critical_angle(Engine::cairn, slope, block, low, high) / degree;
  if (has_box2d()) result.box2d = critical_angle(Engine::box2d, slope, block, low, high) / degree;
  return result;
}

}  // namespace

Study make_study(const StudySettings& settings) {
  const Block slippery = {.friction = settings.slippery};
  const Block rough = {.friction = settings.rough};
  const Block heavy = {.friction = settings.rough, .mass = settings.mass};
  const Slope slope = long_enough(settings.slope, slippery);
  Study study;
  study.settings = settings;
  study.settings.slope = slope;
  study.slippery = slide(slope, slippery);
  study.by_hand = sweeps_by_hand(slope, slippery);
  study.rough = slide(slope, rough);
  study.heavy = slide(slope, heavy);
  for (const double friction : {settings.slippery, settings.rough})
    study.thresholds.push_back(make_threshold(slope, friction));
  return study;
}

double first_force(const Study& study, CornerRow row) {
  return study.by_hand.back()[row] / study.settings.slope.dt;
}

double unfinished(const Slope& slope) {
  // A sweep over the four rows of a block leaves at most 0.65 of the error (measured for every mu up to 0.9
  // and every angle up to 40 degrees); the error begins as the g dt that one step of gravity gives.
  return slope.gravity * slope.dt * std::pow(0.7, slope.sweeps);
}

double rounding(const Slope& slope, double speed) {
  // In each step the velocity is rounded once for gravity, once for each of four rows of the warm start, and
  // a few times more in sweeps that hardly change it: 16 half ulps.
  const double largest = speed + slope.gravity * slope.dt;
  return 8 * epsilon * largest * slope.steps;
}

double blind_angle(const Slope& slope, double friction) {
  // d above the critical angle the way is g d (cos + mu sin) t^2 / 2, and tan = mu there; the bisection adds
  // 0.001.
  const double time = slope.steps * slope.dt;
  return 1e-3 / (slope.gravity * std::hypot(1.0, friction) * time * time / 2) / degree + 0.001;
}

}  // namespace cairn::friction
