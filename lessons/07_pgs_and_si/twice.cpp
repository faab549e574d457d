// A random problem, and what both solvers of the library make of it.
#include "lesson.hpp"

#include "lessons/kit/random.hpp"

namespace cairn::twice {

namespace {

Vec3<double> random_vector(Random& random, double size) {
  const double x = random.between(-size, size);
  const double y = random.between(-size, size);
  return {x, y, random.between(-size, size)};
}

template <Scalar Real>
VelocityProblem<Real> cast(const VelocityProblem<double>& problem) {
  VelocityProblem<Real> result;
  result.dt = static_cast<Real>(problem.dt);
  result.blocks = problem.blocks;
  for (const ConstraintRow<double>& row : problem.rows) {
    ConstraintRow<Real> copy;
    copy.a = row.a;
    copy.b = row.b;
    copy.jacobian_a = row.jacobian_a.template cast<Real>();
    copy.jacobian_b = row.jacobian_b.template cast<Real>();
    copy.bias = static_cast<Real>(row.bias);
    if (row.bounds.is_unilateral()) copy.bounds = Bounds<Real>::unilateral();
    result.rows.push_back(copy);
  }
  for (const Vec3<double>& m : problem.inverse_mass) result.inverse_mass.push_back(m.template cast<Real>());
  for (const Vec3<double>& v : problem.velocity) result.velocity.push_back(v.template cast<Real>());
  for (const double p : problem.impulse) result.impulse.push_back(static_cast<Real>(p));
  return result;
}

/// All impulses after every sweep, in the solver's own precision.
template <Scalar Real>
class ImpulseHistory final : public SolveObserver<Real> {
 public:
  void before_solve(const VelocityProblem<Real>& problem) override { history_.push_back(problem.impulse); }
  void after_sweep(int, const VelocityProblem<Real>& problem) override {
    history_.push_back(problem.impulse);
  }
  const List<PerRow<Real>>& history() const { return history_; }

 private:
  List<PerRow<Real>> history_;
};

template <Scalar Real>
PrecisionRun compare(const std::string& name, const VelocityProblem<double>& problem, int sweeps) {
  VelocityProblem<Real> for_pgs = cast<Real>(problem);
  VelocityProblem<Real> for_si = for_pgs;
  ImpulseHistory<Real> pgs;
  ImpulseHistory<Real> si;
  ProjectedGaussSeidel<Real>({.iterations = sweeps}).solve(for_pgs, &pgs);
  SequentialImpulse<Real>({.iterations = sweeps}).solve(for_si, &si);
  PrecisionRun run{.name = name, .epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon())};
  for (int k = 0; k < pgs.history().size(); ++k) {
    Real largest = 0;
    for (int i = 0; i < pgs.history()[k].size(); ++i) {
      largest = std::max(largest, std::abs(pgs.history()[k][i] - si.history()[k][i]));
      run.scale = std::max(run.scale, static_cast<double>(std::abs(si.history()[k][i])) / problem.dt);
    }
    run.difference.push_back(static_cast<double>(largest) / problem.dt);
  }
  const PerRow<Real>&last_pgs = for_pgs.impulse, &last_si = for_si.impulse;
  for (int i = 0; i < last_pgs.size(); ++i) {
    if (std::abs(last_pgs[i] - last_si[i]) > std::abs(last_pgs[run.row] - last_si[run.row])) run.row = i;
  }
  const Real dt = for_pgs.dt;
  run.pgs = all_digits(last_pgs[run.row] / dt, std::numeric_limits<Real>::max_digits10);
  run.si = all_digits(last_si[run.row] / dt, std::numeric_limits<Real>::max_digits10);
  return run;
}

List<PerRow<double>> lambdas(const SweepRecorder<double>& recorder, double dt) {
  List<PerRow<double>> result;
  for (const SweepRecord& sweep : recorder.sweeps()) {
    result.push_back(sweep.impulse);
    for (double& value : result.back()) value /= dt;
  }
  return result;
}

/// How far the velocities of SI are from (26), over all of its row updates.
double identity_error(const VelocityProblem<double>& problem, const List<RowRecord>& updates) {
  PerRow<double> eta(problem.row_count(), 0.0);
  double largest = 0;
  for (const RowRecord& record : updates) {
    eta[record.update.row] = record.update.impulse_after;
    VelocityProblem<double> twin = problem;
    for (int i = 0; i < eta.size(); ++i) apply_impulse(twin, twin.rows[i], eta[i]);
    const PerBody<Vec3<double>>& expected = twin.velocity;
    for (const BodyId body : expected.indices()) {
      largest = std::max(largest, (record.velocity[body] - expected[body]).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

/// Random masses, velocities and rows, each between two bodies; every second row is one-sided (lambda >= 0).
VelocityProblem<double> random_problem(const TwiceSettings& settings) {
  Random random(settings.seed);
  VelocityProblem<double> problem;
  problem.dt = settings.dt;
  for (int i = 0; i < settings.bodies; ++i) {
    const double inverse = random.between(0.5, 2);  // masses of 0.5 to 2 kg
    problem.inverse_mass.push_back({inverse, inverse, random.between(1, 10)});
    problem.velocity.push_back(random_vector(random, 1));
  }
  for (int i = 0; i < settings.rows; ++i) {
    ConstraintRow<double> row;
    row.a = {random.below(settings.bodies)};
    row.b = {(row.a.index + 1 + random.below(settings.bodies - 1)) % settings.bodies};
    row.jacobian_a = random_vector(random, 1);
    row.jacobian_b = random_vector(random, 1);
    row.bias = random.between(-0.1, 0.1);
    if (i % 2 == 1) row.bounds = Bounds<double>::unilateral();
    problem.blocks.push_back({problem.row_count(), 1});
    problem.rows.push_back(row);
    problem.impulse.push_back(0);
  }
  return problem;
}

/// [%] The largest error of any lambda after asked_sweeps, of the largest lambda.
template <typename Solver>
double off_after_asked(VelocityProblem<double> problem, const PerRow<double>& right) {
  Solver({.iterations = asked_sweeps}).solve(problem);
  double error = 0, largest = 0;
  for (int i = 0; i < right.size(); ++i) {
    error = std::max(error, std::abs(problem.impulse[i] - right[i]));
    largest = std::max(largest, std::abs(right[i]));
  }
  return 100 * error / largest;
}

/// Largest difference of any lambda [N] after as many sweeps of SI, and of PGS that visits the last row
/// first.
double backwards(VelocityProblem<double> problem, int sweeps) {
  VelocityProblem<double> reversed = problem;
  std::ranges::reverse(reversed.rows);
  SequentialImpulse<double>({.iterations = sweeps}).solve(problem);
  ProjectedGaussSeidel<double>({.iterations = sweeps}).solve(reversed);
  const int rows = problem.row_count();
  double largest = 0;
  for (int i = 0; i < rows; ++i)
    largest = std::max(largest, std::abs(problem.impulse[i] - reversed.impulse[rows - 1 - i]));
  return largest / problem.dt;
}

/// How far each is from where both end.
void ask(TwiceRun& run) {
  VelocityProblem<double> settled = run.problem;
  SequentialImpulse<double>({.iterations = 20000}).solve(settled);
  run.pgs_off = off_after_asked<ProjectedGaussSeidel<double>>(run.problem, settled.impulse);
  run.si_off = off_after_asked<SequentialImpulse<double>>(run.problem, settled.impulse);
  for (const int sweeps : {1, 10, 100, 1000}) run.backwards.push_back(backwards(run.problem, sweeps));
  run.exact = settled.impulse;
  for (double& lambda : run.exact) lambda /= run.problem.dt;
}

}  // namespace

std::string all_digits(long double value, int digits) {
  const std::string text = fmt::format("{:#.{}g}", value, digits);  // with the zeros at its end
  return text.front() == '-' ? "−" + text.substr(1) : text;
}

TwiceRun solve_with_the_library(const TwiceSettings& settings) {
  TwiceRun run{.settings = settings, .problem = random_problem(settings)};
  run.system = system_matrices(run.problem);
  SweepRecorder<double> pgs;
  SweepRecorder<double> si(SweepRecorder<double>::Detail::rows);
  VelocityProblem<double> for_pgs = run.problem;
  VelocityProblem<double> for_si = run.problem;
  ProjectedGaussSeidel({.iterations = settings.sweeps}).solve(for_pgs, &pgs);
  SequentialImpulse({.iterations = settings.sweeps}).solve(for_si, &si);
  run.pgs = lambdas(pgs, settings.dt);
  run.si = lambdas(si, settings.dt);
  run.identity_error = identity_error(run.problem, si.rows());
  for (int i = 0; i < for_si.row_count(); ++i) {
    run.at_bound += for_si.rows[i].bounds.is_unilateral() && for_si.impulse[i] == 0;
  }
  run.precisions = {compare<float>("float", run.problem, settings.sweeps),
                    compare<double>("double", run.problem, settings.sweeps),
                    compare<long double>("long double", run.problem, settings.sweeps)};
  VelocityProblem<double> again = run.problem;
  again.impulse = for_si.impulse;
  run.warm = compare<double>("double, warm", again, settings.sweeps);
  ask(run);
  return run;
}

double rounding_bound(const PrecisionRun& run, int sweeps) { return 64 * run.epsilon * (1 + sweeps); }

}  // namespace cairn::twice
