// Gauss-Seidel with momentum: the same answers in fewer sweeps, and never by a risk.
#include "validation/problems.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

template <Scalar Real>
using Accelerated = AcceleratedProjectedGaussSeidel<Real>;

/// Boxes of 1 m and 1 kg with one of another mass [kg] on top, every second one 1 cm to the right, with
/// friction, at their first step.
VelocityProblem<double> tower_with_friction(int boxes, double top_mass) {
  Scene scene;
  scene.add_ground();
  const BodyId top = samples::add_staggered_stack(scene, boxes, 0.01).back();
  BodySpec heavy = scene.bodies()[top].spec;
  heavy.mass = top_mass;
  scene.change(top, heavy);
  return problem_after(scene, 0);
}

/// Four light boxes under a hundred times as heavy a one, nothing can tilt.
VelocityProblem<double> heavy_on_light() { return column<double>({1, 1, 1, 1, 100}); }

/// Sweeps until R_E is at most 1e-6.
template <typename SolverType>
int sweeps_to_a_millionth(const VelocityProblem<double>& start) {
  VelocityProblem<double> problem = start;
  const SolveReport report = SolverType({.iterations = 100000, .tolerance = 1e-6}).solve(problem);
  CHECK(report.converged);
  CHECK(residual(problem, residual_scale(start)).energy <= 1e-6);
  return report.iterations;
}

/// How many times as many sweeps SI takes.
double gain_over_si(const VelocityProblem<double>& start) {
  return static_cast<double>(sweeps_to_a_millionth<SequentialImpulse<double>>(start)) /
         sweeps_to_a_millionth<Accelerated<double>>(start);
}

/// f = p^T A p / 2 - b^T p [J] after every sweep, and how many sweeps changed nothing at all.
class EnergyWatcher final : public SolveObserver<double> {
 public:
  void before_solve(const VelocityProblem<double>& problem) override {
    system = system_matrices(problem);
    b = system.b * problem.dt;
    after_sweep(0, problem);
  }
  void after_sweep(int, const VelocityProblem<double>& problem) override {
    const Eigen::Map<const Vector<double>> p(problem.impulse.data(), problem.row_count());
    energy.push_back(0.5 * p.dot(system.A * p) - b.dot(p));
    largest_sum = std::max(largest_sum, p.cwiseAbs().dot(system.A.cwiseAbs() * p.cwiseAbs()));
    undone += problem.impulse == last;
    last = problem.impulse;
  }
  List<double> energy = {};
  double largest_sum = 0;  // [J] of the terms of p^T A p, which cancel each other almost
  int undone = 0;

 private:
  SystemMatrices<double> system;
  Vector<double> b;
  PerRow<double> last = {};
};

}  // namespace

TEST_CASE_TEMPLATE("the first sweep has no momentum yet: it is that of SI to the last bit", Real, float,
                   double, long double) {
  for (const RowOrder order : {RowOrder::as_written, RowOrder::reverse, RowOrder::shuffled}) {
    VelocityProblem<Real> problem = column<Real>({1, 3, 2}), si = problem;
    Accelerated<Real>({.iterations = 1, .order = order}).solve(problem);
    SequentialImpulse<Real>({.iterations = 1, .order = order}).solve(si);
    CHECK(problem.impulse == si.impulse);
    CHECK(problem.velocity == si.velocity);
  }
}

TEST_CASE_TEMPLATE("two boxes: momentum multiplies the last step by (k - 1) / (k + 2), and a sweep follows",
                   Real, float, double, long double) {
  const Real m = 1, M = 20;
  const Real q = M / (M + m), g_dt = static_cast<Real>(test_gravity) * static_cast<Real>(test_dt);
  VelocityProblem<Real> problem = column<Real>({m, M});
  ImpulseTrace<Real> trace;
  Accelerated<Real> solver({.iterations = 15});
  solver.solve(problem, &trace);
  CHECK(solver.restarts() == 0);
  // A sweep takes the upper impulse's error from e to q e, and the lower one carries m more.
  Real error = -M * g_dt, before = error;
  for (int k = 1; k <= 15; ++k) {
    const Real momentum = static_cast<Real>(k - 1) / static_cast<Real>(k + 2);
    const Real start = error + momentum * (error - before);
    before = error;
    error = q * start;
    const PerRow<Real>& impulse = trace.sweeps[k];
    const Real tolerance =
        64 * std::numeric_limits<Real>::epsilon() * static_cast<Real>(1 + k) * (m + M) * g_dt;
    CHECK(std::abs(impulse[0] - ((m + M) * g_dt + start)) <= tolerance);
    CHECK(std::abs(impulse[1] - (M * g_dt + error)) <= tolerance);
  }
}

TEST_CASE("stacks and heavy boxes get the weights that they must carry") {
  for (const List<double>& masses : {List<double>(50, 1.0), {1, 1000}, {1, 1, 1, 1, 100}, {100, 1, 100, 1}}) {
    VelocityProblem<double> problem = column(masses);
    Accelerated<double>({.iterations = 3000}).solve(problem);
    double weight = 0;  // [N s] above, from the top down
    for (int i = masses.size(); i-- > 0;) {
      weight += masses[i] * test_gravity * test_dt;
      // An impulse is known to about epsilon times the condition of A, at most 1e5 here.
      CHECK(problem.impulse[i] == doctest::Approx(weight).epsilon(1e-9));
    }
  }
}

TEST_CASE("with friction a tower gets the velocities of PGS") {
  VelocityProblem<double> problem = tower_with_friction(3, 1), pgs = problem;
  Accelerated<double>({.iterations = 1000}).solve(problem);
  ProjectedGaussSeidel<double>({.iterations = 10000}).solve(pgs);
  CHECK(largest_gap(problem.velocity, pgs.velocity) <= 1e-9 * test_gravity * test_dt);
}

// The ratios measured are 33, 42, 25, 93 and 23: a fifth of slack for other compilers' roundings.
TEST_CASE("tall stacks, and heavy boxes on light ones, take 20 to 100 times fewer sweeps than with SI") {
  CHECK(gain_over_si(stack<double>(50)) >= 26);
  CHECK(gain_over_si(column<double>({1, 1000})) >= 33);
  CHECK(gain_over_si(heavy_on_light()) >= 20);
  CHECK(gain_over_si(tower_with_friction(10, 1)) >= 74);
  CHECK(gain_over_si(tower_with_friction(2, 100)) >= 18);
}

TEST_CASE(
    "momentum that has grown too far is given up, the sweep undone to the last bit, and the energy falls") {
  for (const VelocityProblem<double>& start :
       {column<double>({1, 1000}), heavy_on_light(), stack<double>(30)}) {
    VelocityProblem<double> problem = start;
    EnergyWatcher watcher;
    Accelerated<double> solver({.iterations = 300});
    solver.solve(problem, &watcher);
    CHECK(solver.restarts() >= 1);
    CHECK(watcher.undone == solver.restarts());
    const double rounding = 64 * double_epsilon * watcher.largest_sum;
    for (int k = 1; k < watcher.energy.size(); ++k) {
      CHECK(watcher.energy[k] <= watcher.energy[k - 1] + rounding);
    }
  }
}

TEST_CASE("where momentum has no direction to follow, at most every second sweep is undone") {
  VelocityProblem<double> problem = column<double>({1, 1000});
  Accelerated<double> solver({.iterations = 1000, .order = RowOrder::alternating, .relaxation = 1.9});
  solver.solve(problem);
  CHECK(solver.restarts() > 100);
  CHECK(solver.restarts() <= 500);
}

TEST_CASE(
    "after every sweep every impulse is inside its bounds, friction inside those of the newest normal") {
  for (const double top_mass : {1.0, 100.0}) {
    VelocityProblem<double> problem = tower_with_friction(4, top_mass);
    for (const BodyId body : problem.velocity.indices()) problem.velocity[body].x() = body.index;
    SweepWatcher<double> watcher;
    Accelerated<double> solver({.iterations = 500});
    solver.solve(problem, &watcher);
    CHECK(solver.restarts() >= 1);
    CHECK(watcher.outside == 0);
  }
}

TEST_CASE("momentum ends with the solve: a used solver gives the bits of a new one") {
  VelocityProblem<double> other = heavy_on_light(), first = stack<double>(8), second = first;
  Accelerated<double> used({.iterations = 25}), fresh({.iterations = 25});
  used.solve(other);
  used.solve(first);
  fresh.solve(second);
  CHECK(first.impulse == second.impulse);
  CHECK(first.velocity == second.velocity);
}

TEST_CASE("a warm start that is twice too large is taken back") {
  VelocityProblem<double> problem = stack<double>(5);
  for (int i = 0; i < 5; ++i) problem.impulse[i] = 2 * (5 - i) * test_gravity * test_dt;
  Accelerated<double>({.iterations = 500}).solve(problem);
  for (int i = 0; i < 5; ++i) {
    const double weight = (5 - i) * test_gravity * test_dt;
    CHECK(problem.impulse[i] == doctest::Approx(weight).epsilon(1e-12));
  }
}

TEST_CASE("an undone sweep is no standstill, and momentum goes in no circle: patience waits for rounding") {
  VelocityProblem<double> problem = column<double>({1, 1000});
  const double scale = residual_scale(problem);
  Accelerated<double> solver({.iterations = 100000, .patience = 1});
  const SolveReport report = solver.solve(problem);
  CHECK(report.stop == Stop::stalled);
  CHECK(solver.restarts() >= 1);
  CHECK(residual(problem, scale).energy <= 1e-10);
}

TEST_CASE("accelerated PGS keeps two numbers a row and three a body") {
  VelocityProblem<double> problem = stack<double>(7);
  Accelerated<double> solver({.iterations = 3});
  CHECK(solver.memory() == 0);
  solver.solve(problem);
  CHECK(solver.memory() == (2 * 7 + 3 * 8) * sizeof(double));
  CHECK(solver.name() == "accelerated PGS");
}
