// The same problems for SequentialImpulse and for BlockSequentialImpulse.
#include "lesson.hpp"

#include <Eigen/Cholesky>

namespace cairn::blocks {

namespace {

const double beta = 0.2;  // as Stabilization has it

/// `links` of 1 kg in a line at `angle` [rad] above the horizontal, each joined to the one before it.
template <typename Joint>
Scene line_of(int links, double length, double height, double angle, double dt) {
  Scene scene(
      {.gravity = {0, -gravity}, .dt = dt, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  const Vec2<double> along = {std::cos(angle), std::sin(angle)};
  BodyId last = ground;
  for (int i = 0; i < links; ++i) {
    const BodyId link = scene.add({.shapes = {box(length, height)},
                                   .position = along * (length * (i + 0.5)),
                                   .angle = angle,
                                   .mass = 1,
                                   .inertia = (length * length + height * height) / 12});
    scene.join<Joint>({.a = last, .b = link, .anchor = along * (length * i)});
    last = link;
  }
  return scene;
}

double error_of(const PerRow<double>& impulse, const Vector<double>& exact, double dt) {
  double error = 0;
  for (int i = 0; i < impulse.size(); ++i) error = std::max(error, std::abs(impulse[i] / dt - exact(i)));
  return error / exact.lpNorm<Eigen::Infinity>();
}

/// Looks at every sweep until the goal is reached.
class GoalObserver final : public SolveObserver<double> {
 public:
  GoalObserver(const Matrix<double>& A, const Vector<double>& exact, ChainSolve& solve)
      : A_(A), exact_(exact), solve_(solve) {}
  void before_solve(const VelocityProblem<double>& problem) override { look(problem); }
  void after_sweep(int, const VelocityProblem<double>& problem) override {
    if (solve_.error.back() > goal) look(problem);
  }

 private:
  void look(const VelocityProblem<double>& problem) {
    solve_.error.push_back(error_of(problem.impulse, exact_, problem.dt));
    Vector<double> error = -exact_;
    for (int i = 0; i < problem.row_count(); ++i) error(i) += problem.impulse[i] / problem.dt;
    if (solve_.by_energy < 0 && error.dot(A_ * error) <= goal * goal * exact_.dot(A_ * exact_))
      solve_.by_energy = solve_.error.size() - 1;
  }
  const Matrix<double>& A_;
  const Vector<double>& exact_;
  ChainSolve& solve_;
};

ChainSolve solve_chain(VelocityProblem<double> problem, const Vector<double>& exact, Solver<double>& solver) {
  ChainSolve solve;
  const Matrix<double> A = system_matrices(problem).A;
  GoalObserver observer(A, exact, solve);
  solver.solve(problem, &observer);
  solve.sweeps = solve.error.size() - 1;
  return solve;
}

/// 12 multiply-adds a row and sweep, and one more for each row of its block; a row alone is a block of one.
void count_work(int rows, int size, ChainRun& run) {
  run.rows.work = (12LL + 1) * rows * run.rows.sweeps;
  run.blocks.work = (12LL + size) * rows * run.blocks.sweeps;
}

ChainRun run_chain(const std::string& name, const Scene& scene, int size, int most = most_sweeps) {
  const World<double> world(scene);
  const VelocityProblem<double> problem = world.velocity_problem();
  const SystemMatrices<double> system = system_matrices(problem);
  const Vector<double> exact = system.A.ldlt().solve(system.b);
  ChainRun run{.name = name, .start = snapshot(world), .problem = problem, .A = system.A};
  SequentialImpulse<double> rows({.iterations = most});
  BlockSequentialImpulse<double> blocks({.iterations = most});
  run.rows = solve_chain(problem, exact, rows);
  run.blocks = solve_chain(problem, exact, blocks);
  if (most == most_sweeps) {
    run.dense_sweeps = sweeps_by_hand(system, exact, 1);
    run.dense_block_sweeps = sweeps_by_hand(system, exact, size);
  }
  count_work(problem.row_count(), size, run);
  return run;
}

List<ChainRun> run_chains(double dt) {
  List<ChainRun> chains;
  for (const int beams : {1, 2, 3, 5}) {
    chains.push_back(run_chain(fmt::format("{} beam{}, welded", beams, beams == 1 ? "" : "s"),
                               line_of<WeldJoint>(beams, beam_length, beam_height, 0, dt), 3));
  }
  chains.push_back(run_chain("10 beams on pins, at 45°",
                             line_of<RevoluteJoint>(10, beam_length, beam_height, pi / 4, dt), 2));
  chains.push_back(
      run_chain("10 beams, welded", line_of<WeldJoint>(10, beam_length, beam_height, 0, dt), 3, 100000));
  return chains;
}

}  // namespace

List<Pair> pairs_of(const SweepRecorder<double>& recorder, double dt) {
  List<Pair> lambda;
  for (const SweepRecord& sweep : recorder.sweeps())
    lambda.push_back({sweep.impulse[0] / dt, sweep.impulse[1] / dt});
  return lambda;
}

void record_rows(const SweepRecorder<double>& recorder, const VelocityProblem<double>& problem, RodRun& run) {
  run.by_rows = pairs_of(recorder, problem.dt);
  Pair lambda = run.by_rows[0];
  for (const RowRecord& record : recorder.rows()) {
    RodUpdate update{.sweep = record.update.sweep, .row = record.update.row};
    update.jv = record.update.row_velocity;
    update.corrective = record.update.corrective / problem.dt;
    update.before = lambda;
    lambda[update.row] = record.update.impulse_after / problem.dt;
    update.after = lambda;
    update.slip = {row_velocity(problem, problem.rows[0], record.velocity),
                   row_velocity(problem, problem.rows[1], record.velocity)};
    run.updates.push_back(update);
  }
}

void add_formulas(const BlocksSettings& settings, RodRun& run) {
  const Matrix<double>& A = run.system.A;
  run.rate = A(0, 1) * A(0, 1) / (A(0, 0) * A(1, 1));
  const double angle = settings.angle * pi / 180;
  run.formula = {gravity * 0.75 * std::sin(angle) * std::cos(angle),
                 gravity * (1 - 0.75 * std::cos(angle) * std::cos(angle))};
}

World<double> bob_world(const BlocksSettings& settings) {
  Scene scene({.gravity = {0, -gravity},
               .dt = settings.dt,
               .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  const BodyId bob = scene.add({.shapes = {circle(0.1)},
                                .position = {std::sin(settings.start_angle), -std::cos(settings.start_angle)},
                                .mass = 1,
                                .inertia = settings.inertia});
  scene.join<RevoluteJoint>({.a = ground, .b = bob, .anchor = {0, 0}});
  return World<double>(scene);
}

BlocksRuns run_blocks(const BlocksSettings& settings) {
  BlocksRuns all{.settings = settings, .rod = run_rod(settings), .chains = run_chains(settings.dt)};
  all.bob_A = system_matrices(bob_world(settings).velocity_problem()).A;
  const Matrix<double>& A = all.bob_A;
  all.bob_rate = A(0, 1) * A(0, 1) / (A(0, 0) * A(1, 1));
  SequentialImpulse<double> rows({.iterations = settings.sweeps});
  BlockSequentialImpulse<double> block({.iterations = settings.sweeps});
  Snapshot lost;
  all.bob_rows = run_bob(settings, rows, lost);
  all.bob_block = run_bob(settings, block, all.last);
  return all;
}

// Semi-implicit Euler keeps H - (dt / 2) v . grad V, but for dt^2, so that H itself sways by
// (dt / 2) m g w sin(angle) while the bob swings with w <= w_0 = sqrt(2 g (1 - cos a)).
double energy_sway(const BlocksSettings& settings) {
  const double fastest = std::sqrt(2 * gravity * (1 - std::cos(settings.start_angle)));
  return settings.dt / 2 * gravity * fastest * std::sin(settings.start_angle);
}

// A step leads along the tangent, off the circle by (w dt)^2 / 2 at most, and Baumgarte takes the share beta
// of that back in every step. The sway may add to m w^2 / 2.
double stretch_bound(const BlocksSettings& settings) {
  const double w_squared = 2 * gravity * (1 - std::cos(settings.start_angle)) + 2 * energy_sway(settings);
  return w_squared * settings.dt * settings.dt / (2 * beta);
}

// What the stretch can lift is that times the pull m (g + w^2) of the pin.
double energy_bound(const BlocksSettings& settings) {
  const double w_squared = 2 * gravity * (1 - std::cos(settings.start_angle)) + 2 * energy_sway(settings);
  return -gravity * std::cos(settings.start_angle) + energy_sway(settings) +
         stretch_bound(settings) * (gravity + w_squared);
}

}  // namespace cairn::blocks
