// Lesson 09. A row asks for a velocity, so an error in positions stays for ever, unless the row asks for a
// velocity that takes it back: ζ of (7), a share β of the error in every step. Three scenes have an error to
// get rid of: a ball inside the ground, a pendulum that leaves its circle in every step, and a weight that
// hangs too low. The ground can only push, so the ball may keep the speed that took it out. The rod of the
// other two holds in both directions.
#include "lesson.hpp"

namespace {

using namespace cairn;
using namespace cairn::drift;

struct HandBall {
  double height = 0;  // [m] c: of its lowest point above the ground
  double speed = 0;   // [m/s] upwards: j v
  double zeta = 0;    // [m/s]
  double lambda = 0;  // [N]
};

/// A step of a ball of 1 kg on the ground, by hand.
void step_by_hand(HandBall& ball, double dt, double beta, double slop) {
  // [row]
  const double depth = -ball.height;
  if (depth < 0)
    ball.zeta = depth / dt;  // above the ground: it may come down to it within the step, and no further
  else
    ball.zeta = beta * std::max(0.0, depth - slop) / dt;  // (7), for what is deeper than the slop

  ball.speed -= gravity * dt;                                  // v₁: gravity first
  ball.lambda = std::max(0.0, (ball.zeta - ball.speed) / dt);  // (22) with j M⁻¹ jᵀ = 1/kg; it cannot pull
  ball.speed += ball.lambda * dt;                              // v₂
  ball.height += ball.speed * dt;
  // [/row]
}

BallRun run_ball(const DriftSettings& settings, double slop, int steps) {
  World<double> world = ball_world(settings, slop);
  SequentialImpulse<double> solver({.iterations = 1});  // one row, so one sweep is all it takes
  HandBall ball{.height = -settings.depth};
  BallRun run{.beta = settings.beta, .slop = slop, .peak = ball.height};
  record(run, world);
  for (int k = 1; k <= steps; ++k) {
    world.step(solver);
    step_by_hand(ball, settings.dt, settings.beta, slop);
    record(run, world);
    run.gap = std::max(run.gap, std::abs(run.height.back() - ball.height));
  }
  return run;
}

/// A weight on a rod that begins at `start`, in steps of the library.
RodRun run_rod(double dt, double beta, const Vec2<double>& start, int steps) {
  World<double> world = rod_world(dt, beta, start);
  SequentialImpulse<double> solver({.iterations = 1});
  RodRun run{.beta = beta, .steps = {snapshot(world)}, .error = {start.norm() - rod_length}};
  for (int k = 1; k <= steps; ++k) {
    const Vec2<double> along = world.bodies().pose[{1}].position.normalized();
    world.step(solver);
    const double across = cross(along, Vec2<double>(world.bodies().velocity[{1}].head<2>()));
    // The weight goes straight on: by ζ Δt = −β c along the rod, and by v Δt across it.
    const double expected = std::hypot(rod_length + (1 - beta) * run.error.back(), across * dt) - rod_length;
    run.steps.push_back(snapshot(world));
    run.error.push_back(world.bodies().pose[{1}].position.norm() - rod_length);
    run.gap = std::max(run.gap, std::abs(run.error.back() - expected));
    run.fastest = std::max(run.fastest, std::abs(across));
  }
  run.energy = total_energy(run.steps.back());
  return run;
}

DriftRuns run_drift(const DriftSettings& settings) {
  const auto [dt, own, depth] = settings;
  DriftRuns all{.settings = settings};
  const int swing_steps = static_cast<int>(std::lround(swing_time / dt));
  for (const double beta : ascending({0, own, 1}))
    all.swings.push_back(run_rod(dt, beta, {rod_length, 0}, swing_steps));
  for (const double beta : ascending({own, 1, 1.8, 2.1}))
    all.hangs.push_back(run_rod(dt, beta, {0, -rod_length - hang_error}, hang_steps));
  // The longest flight, up and down, and time to calm down.
  const int steps = 30 + static_cast<int>(2 * depth / (gravity * dt * dt));
  for (const double beta : ascending({0.1, own, 0.5, 1}))
    all.balls.push_back(run_ball({dt, beta, depth}, 0, steps));
  // Not deeper than the ground can hold it.
  const double held = std::min(depth, slop_tried + 0.9 * limit_by_formula(dt, own));
  all.with_slop = run_ball({dt, own, held}, slop_tried, 200);
  all.limits = find_limits(settings);
  return all;
}

void run(Lesson& lesson) {
  const DriftRuns all =
      run_drift({.dt = lesson.real("dt"), .beta = lesson.real("beta"), .depth = lesson.real("depth")});
  print_scenes(lesson, all);
  lesson.predict();
  lesson.print();
  print_balls(lesson, all);
  print_limits(lesson, all);
  print_swings(lesson, all);
  print_hangs(lesson, all);
  const double hop = hop_by_formula(all.settings);
  lesson.answer(
      {hop}, 0.1 * hop + 0.005,
      "The speed that takes the error back is still there when the error is gone. A rod would take it "
      "away in the next step. The ground cannot pull, so only gravity does.");
  check_balls(lesson, all);
  check_limits(lesson, all);
  check_rods(lesson, all);
  lesson.film(drift_shots(all));
  lesson.data(balls_table(all));
  lesson.fingerprint(ball_of(all, all.settings.beta).steps.back());
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(card(), run, argc, argv); }
