// Lesson 12. Blocks: solve what belongs together in one go.
//
// A joint writes two or three rows, and all of them act on the same two bodies: what one row corrects, the
// next one spoils. Instead of dividing by A_ii, row after row, sequential impulses may solve with the small
// square of A that belongs to the joint. The loop stays as it is; only the step in it grows from a number to
// a block. Where does that save sweeps, where does it not, and where does it hold what rows cannot?
#include "lesson.hpp"

#include <Eigen/LU>

namespace cairn::blocks {

int sweeps_by_hand(const SystemMatrices<double>& system, const Vector<double>& exact, int size) {
  const Matrix<double>& A = system.A;
  const Vector<double>& b = system.b;
  // [block]
  List<Eigen::PartialPivLU<Matrix<double>>> joints;  // A_BB of each joint, factorized once a step
  for (Eigen::Index first = 0; first < b.size(); first += size)
    joints.emplace_back(A.block(first, first, size, size));

  Vector<double> lambda = Vector<double>::Zero(b.size());
  for (int sweep = 1; sweep <= most_sweeps; ++sweep) {
    for (int joint = 0; joint < joints.size(); ++joint) {
      const int first = joint * size;
      const Vector<double> missing = (b - A * lambda).segment(first, size);  // (zeta_B - J_B v) / dt
      const Vector<double> correction = joints[joint].solve(missing);        // size 1: divided by A_ii, (22)
      lambda.segment(first, size) += correction;
    }
    if ((lambda - exact).lpNorm<Eigen::Infinity>() <= goal * exact.lpNorm<Eigen::Infinity>()) return sweep;
  }
  // [/block]
  return most_sweeps;
}

// A rod as thin as the formulas have it, I = m l^2 / 12, but drawn with some width.
Scene rod_scene(const BlocksSettings& settings) {
  Scene scene({.gravity = {0, -gravity}, .dt = settings.dt});
  const double angle = settings.angle * pi / 180;
  const Vec2<double> middle = Vec2<double>(std::cos(angle), std::sin(angle)) * (rod_length / 2);
  const BodyId rod = scene.add({.shapes = {box(rod_length, 0.12)},
                                .position = middle,
                                .angle = angle,
                                .mass = 1,
                                .inertia = rod_length * rod_length / 12});
  scene.join<RevoluteJoint>({.a = ground, .b = rod, .anchor = {0, 0}});
  return scene;
}

RodRun run_rod(const BlocksSettings& settings) {
  const World<double> world(rod_scene(settings));
  VelocityProblem<double> problem = world.velocity_problem();
  problem.impulse[1] = rod_weight * settings.dt;
  RodRun run{.start = snapshot(world), .system = system_matrices(problem)};
  VelocityProblem<double> by_rows = problem;
  SweepRecorder<double> rows(SweepRecorder<double>::Detail::rows);
  SequentialImpulse<double>({.iterations = 6}).solve(by_rows, &rows);

  VelocityProblem<double> by_block = problem;
  SweepRecorder<double> block;
  BlockSequentialImpulse<double>({.iterations = 6}).solve(by_block, &block);
  record_rows(rows, problem, run);
  run.by_block = pairs_of(block, settings.dt);
  add_formulas(settings, run);
  return run;
}

BobRun run_bob(const BlocksSettings& settings, Solver<double>& solver, Snapshot& last) {
  World<double> world = bob_world(settings);
  BobRun run{.largest_energy = -std::numeric_limits<double>::infinity()};
  const int steps = static_cast<int>(std::lround(settings.pin_seconds / settings.dt));
  for (int step = 0; step <= steps; ++step) {
    if (step > 0) world.step(solver);
    last = snapshot(world);
    const Vec2<double> position = last.bodies[{1}].pose.position;
    run.path.push_back(position);
    run.energy.push_back(total_energy(last));
    run.largest_energy = std::max(run.largest_energy, run.energy.back());
    run.largest_stretch = std::max(run.largest_stretch, std::abs(position.norm() - 1));
  }
  return run;
}

namespace {

void run(Lesson& lesson) {
  const BlocksSettings settings = settings_of(lesson);
  const BlocksRuns all = run_blocks(settings);
  print_scene(lesson, settings);
  lesson.predict();
  print_runs(lesson, all);
  const Savings savings = count_savings(all);
  print_savings(lesson, all, savings);
  const ChainRun& asked = all.chains[welded_ten];
  lesson.answer({share_left(asked)}, 5,
                fmt::format("{} of {} sweeps are left. A block saves what the rows of its own joint couple. "
                            "What couples one joint with another stays.",
                            asked.blocks.sweeps, asked.rows.sweeps));
  check_runs(lesson, all);
  check_savings(lesson, all, savings);
  lesson.film(blocks_shots(all));
  lesson.data(sweeps_table(all));
  lesson.fingerprint(all.last);
}

}  // namespace
}  // namespace cairn::blocks

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), cairn::blocks::run, argc, argv); }
