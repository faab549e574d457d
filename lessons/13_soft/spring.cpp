// The engine's runs, and the same springs by hand.
#include "lesson.hpp"

#include <Eigen/Cholesky>
#include <complex>

namespace cairn::soft {

namespace {

int steps_in(double time, double dt) { return static_cast<int>(std::lround(time / dt)); }

/// Steps until a soft row has forgotten all but 1e-13 of where it began. An oscillation keeps the share
/// 1 / sqrt(1 + 2 zeta z + z^2) of itself in a step, z = w dt; without one, the slower of its two parts does.
/// Near critical damping these two have a factor of 1 + w t in front, less than 40 at the end: hence 1e-15.
int steps_to_rest(const SoftSettings& settings) {
  const double z = angular_frequency(settings.frequency) * settings.dt;
  const double determinant = 1 / (1 + 2 * settings.damping * z + z * z);
  const double half_trace = (1 + settings.damping * z) * determinant;
  const double under_root = half_trace * half_trace - determinant;
  const double kept = under_root > 0 ? half_trace + std::sqrt(under_root) : std::sqrt(determinant);
  return 10 + static_cast<int>(std::ceil(std::log(1e-15) / std::log(kept)));
}

void run_to_rest(SoftRuns& all) {
  World<double> world(weight_scene(all.settings, beta_of(all.settings)));
  SoftRows solver(gamma_of(all.settings), {.iterations = 1});
  const int steps = steps_to_rest(all.settings);
  for (int step = 0; step < steps; ++step) world.step(solver);
  all.rest_error = world.bodies().pose[{1}].position.y() - half_height - rest_length;
  all.rest_lambda = world.last_step().problem.impulse[0] / all.settings.dt;
}

List<StiffRun> run_stiff(const SoftSettings& settings) {
  List<StiffRun> runs;
  for (const double frequency : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 200.0, 1e6}) {
    SoftSettings stiff = settings;
    stiff.frequency = frequency;
    const WeightRun run = run_weight(stiff, gamma_of(stiff), beta_of(stiff), steps_in(seconds, settings.dt));
    runs.push_back({.frequency = frequency,
                    .gamma = run.gamma,
                    .beta = run.beta,
                    .sag = settings.mass * gravity / stiffness(stiff),
                    .error = run.error});
  }
  return runs;
}

Scene column_scene(const SoftSettings& settings) {
  Scene scene({.gravity = {0, -gravity},
               .dt = settings.dt,
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = beta_of(settings)}});
  BodyId below = ground;
  for (int i = 1; i <= column_weights; ++i) {
    const Vec2<double> place(0, rest_length * i);
    const BodyId weight = scene.add(
        {.shapes = {box(0.5, 0.5)}, .position = place, .mass = settings.mass, .fixed_rotation = true});
    scene.join<DistanceJoint>({.a = below,
                               .b = weight,
                               .anchor_a = {0, rest_length * (i - 1)},
                               .anchor_b = place,
                               .length = rest_length});
    below = weight;
  }
  return scene;
}

List<List<double>> sweeps_of(Solver<double>& solver, VelocityProblem<double> problem) {
  SweepRecorder<double> recorder;
  solver.solve(problem, &recorder);
  List<List<double>> lambdas;
  for (const SweepRecord& sweep : recorder.sweeps()) {
    List<double>& lambda = lambdas.emplace_back();
    for (const double impulse : sweep.impulse) lambda.push_back(impulse / problem.dt);
  }
  return lambdas;
}

ColumnRun run_column(const SoftSettings& settings, double gamma) {
  const World<double> world(column_scene(settings));
  VelocityProblem<double> problem = world.velocity_problem();
  for (ConstraintRow<double>& row : problem.rows) row.softness = gamma;
  const SystemMatrices<double> system = system_matrices(problem);
  ColumnRun run{.start = snapshot(world), .gamma = gamma, .A = system.A};
  ProjectedGaussSeidel<double> pgs({.iterations = column_sweeps});
  SequentialImpulse<double> si({.iterations = column_sweeps});
  run.by_pgs = sweeps_of(pgs, problem);
  run.by_si = sweeps_of(si, problem);
  return run;
}

/// The larger absolute value of the two numbers with this sum and product.
double larger_root(double sum, double product) {
  const std::complex<double> root = std::sqrt(std::complex<double>(sum * sum / 4 - product));
  return std::max(std::abs(sum / 2 + root), std::abs(sum / 2 - root));
}

Growth growth_at(double frequency, const SoftSettings& settings) {
  const double z = angular_frequency(frequency) * settings.dt;
  const double resisting = 1 + 2 * settings.damping * z + z * z;
  return {.frequency = frequency,
          .row = larger_root(2 * (1 + settings.damping * z) / resisting, 1 / resisting),
          .force = larger_root(2 - 2 * settings.damping * z - z * z, 1 - 2 * settings.damping * z)};
}

}  // namespace

double gamma_of(const SoftSettings& settings) {
  const SwingSoftness swing{settings.frequency, settings.damping};
  return 1 / settings.mass / softness_divisor(swing, settings.dt);
}

double beta_of(const SoftSettings& settings) {
  const SwingSoftness swing{settings.frequency, settings.damping};
  return return_rate(swing, settings.dt) * settings.dt;
}

void record(WeightRun& run, const World<double>& world) {
  run.steps.push_back(snapshot(world));
  const SnapshotBody& weight = run.steps.back().bodies[{1}];
  run.error.push_back(weight.pose.position.y() - half_height - rest_length);
  run.speed.push_back(weight.velocity.y());
}

double angular_frequency(double frequency) { return 2 * pi * frequency; }

double stiffness(const SoftSettings& settings) {
  const double w = angular_frequency(settings.frequency);
  return settings.mass * w * w;
}

double damping_constant(const SoftSettings& settings) {
  return 2 * settings.mass * settings.damping * angular_frequency(settings.frequency);
}

double exact_error(const SoftSettings& settings, double t) {
  const double w = angular_frequency(settings.frequency);
  const double rest = -gravity / (w * w);
  const double begin = -settings.pressed - rest;
  const std::complex<double> root = std::sqrt(std::complex<double>(settings.damping * settings.damping - 1));
  if (std::abs(root) < 1e-6) return rest + begin * (1 + w * t) * std::exp(-w * t);
  const std::complex<double> slow = w * (root - settings.damping);
  const std::complex<double> fast = -w * (root + settings.damping);
  const std::complex<double> swing = (slow * std::exp(fast * t) - fast * std::exp(slow * t)) / (slow - fast);
  return rest + begin * swing.real();
}

List<double> by_implicit_euler(const SoftSettings& settings, int steps) {
  const double w = angular_frequency(settings.frequency);
  const double h = settings.dt;
  double v = 0;
  List<double> error = {-settings.pressed};
  for (int step = 0; step < steps; ++step) {
    const double pull = gravity + w * w * error.back();
    v = (v - h * pull) / (1 + 2 * settings.damping * w * h + w * w * h * h);
    error.push_back(error.back() + h * v);
  }
  return error;
}

double swing_energy(const SoftSettings& settings, double error, double speed) {
  const double k = stiffness(settings);
  const double out = error + settings.mass * gravity / k;
  return (settings.mass * speed * speed + k * out * out) / 2;
}

SoftRuns run_soft(const SoftSettings& settings) {
  SoftRuns all{.settings = settings};
  const int steps = steps_in(seconds, settings.dt);
  all.spring = run_weight(settings, gamma_of(settings), beta_of(settings), steps);
  all.rigid = run_weight(settings, 0, beta_of(settings), steps);
  run_to_rest(all);
  all.stiff = run_stiff(settings);
  all.rigid_column = run_column(settings, 0);
  all.soft_column = run_column(settings, gamma_of(settings));
  for (int i = 0; i <= 60; ++i) all.growth.push_back(growth_at(0.1 * std::pow(10, i / 20.0), settings));
  SoftSettings harsh = settings;
  harsh.frequency = harsh_hertz;
  all.harsh_row = run_weight(harsh, gamma_of(harsh), beta_of(harsh), harsh_steps).error;
  all.harsh_force = by_force(harsh, harsh_steps);
  return all;
}

}  // namespace cairn::soft
