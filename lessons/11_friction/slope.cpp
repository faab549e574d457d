// Lesson 11. A block on a slope, observed; and what two engines make of it.
#include "lesson.hpp"

namespace cairn::friction {

namespace {

double downhill_speed(const Slope& slope, const Snapshot& snapshot) {
  return slope.downhill().dot(snapshot.bodies[first_block].velocity.head<2>());
}

double downhill_way(const Slope& slope, const Snapshot& start, const Snapshot& now,
                    BodyId body = first_block) {
  return slope.downhill().dot(now.bodies[body].pose.position - start.bodies[body].pose.position);
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
  const Scene scene = slope_scene(slope, {block});
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
  slide.box2d_frames = box2d_run(slope_scene(slope, {slide.block}), slope.steps, slope.sweeps);
  for (const Snapshot& frame : slide.box2d_frames) slide.box2d_speed.push_back(downhill_speed(slope, frame));
}

Contest contest(const Slope& slope, const List<Block>& blocks) {
  const List<Snapshot> frames = cairn_run(slope_scene(slope, blocks), slope);
  Contest result;
  result.frames = {frames.front(), frames.back()};
  for (int i = 0; i < blocks.size(); ++i) {
    result.ways.push_back(downhill_way(slope, frames.front(), frames.back(), {first_block.index + i}));
  }
  return result;
}

double way_in(Engine engine, const Slope& slope, const Block& block) {
  const List<Snapshot> frames = run_in(engine, slope, block);
  return downhill_way(slope, frames.front(), frames.back());
}

double acceleration_in(Engine engine, const Slope& slope, const Block& block) {
  const List<Snapshot> frames = run_in(engine, slope, block);
  const int half = frames.size() / 2;
  const double gained = downhill_speed(slope, frames.back()) - downhill_speed(slope, frames[half]);
  return gained / ((frames.size() - 1 - half) * slope.dt);
}

double critical_angle(Engine engine, Slope slope, const Block& block, double low, double high) {
  while (high - low > 0.001 * pi / 180) {
    slope.angle = (low + high) / 2;
    // An angle d above the critical one gives g d (cos + mu sin) t^2 / 2: 1 mm in 2 s for 0.003 degrees.
    (way_in(engine, slope, block) > 1e-3 ? high : low) = slope.angle;
  }
  return (low + high) / 2;
}

}  // namespace cairn::friction
