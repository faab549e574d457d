// Jacobi's method on a tower with friction: split masses, the order of rows, and what an observer sees.
#include <numeric>

#include "validation/problems.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Boxes of 1 m and 1 kg, each 2 cm beside the one below, with friction, at their first step.
VelocityProblem<double> crooked_tower(int boxes) {
  Scene scene;
  scene.add_ground();
  samples::add_staggered_stack(scene, boxes, 0.02);
  return problem_after(scene, 0);
}

/// The largest difference that reversing the rows, or dealing them like cards, makes after 20 sweeps, over
/// the largest impulse.
double effect_of_order(Solver<double>& solver, const VelocityProblem<double>& start) {
  VelocityProblem<double> straight = start;
  solver.solve(straight);
  const double largest = *std::max_element(straight.impulse.begin(), straight.impulse.end());
  PerRow<int> backwards(start.row_count()), dealt(start.row_count());
  std::iota(backwards.begin(), backwards.end(), 0);
  std::reverse(backwards.begin(), backwards.end());
  for (int i = 0; i < dealt.size(); ++i) dealt[i] = i * 7 % dealt.size();
  double effect = 0;
  for (const PerRow<int>& place : {backwards, dealt}) {
    VelocityProblem<double> other = reordered(start, place);
    solver.solve(other);
    for (int i = 0; i < place.size(); ++i) {
      const double gap = other.impulse[i] - straight.impulse[place[i]];
      effect = std::max(effect, std::abs(gap) / largest);
    }
  }
  return effect;
}

/// One sweep as the paper of 2012 tells it: each row gets bodies of its own with 1 / n of the mass, and the
/// velocity of a body is the average of its parts'.
void sweep_over_parts(VelocityProblem<double>& problem) {
  PerBody<int> parts(problem.body_count(), 0);
  for (const ConstraintRow<double>& row : problem.rows) {
    if (row.jacobian_a != Vec3<double>::Zero()) ++parts[row.a];
    if (row.jacobian_b != Vec3<double>::Zero()) ++parts[row.b];
  }
  VelocityProblem<double> light = problem;
  for (const BodyId body : parts.indices()) light.inverse_mass[body] *= std::max(parts[body], 1);

  const PerRow<double> before = problem.impulse;
  PerBody<Vec3<double>> sum(problem.body_count(), Vec3<double>::Zero());
  for (int i = 0; i < problem.row_count(); ++i) {
    const ConstraintRow<double>& row = problem.rows[i];
    light.velocity = problem.velocity;
    const double wish = (row.bias - row_velocity(light, row)) / inverse_effective_mass(light, row);
    const double after = row.bounds.clamp(before[i] + wish, before);
    apply_impulse(light, row, after - before[i]);
    problem.impulse[i] = after;
    for (const BodyId body : sum.indices()) sum[body] += light.velocity[body] - problem.velocity[body];
  }
  for (const BodyId body : sum.indices()) problem.velocity[body] += sum[body] / std::max(parts[body], 1);
}

/// Sees whether the problem that comes with a row is that of the sweep's beginning.
class BeginningWatcher final : public SolveObserver<double> {
 public:
  bool watches_rows() const override { return true; }
  void before_solve(const VelocityProblem<double>& problem) override { begin(problem); }
  void after_row(const RowUpdate<double>& update, const VelocityProblem<double>& problem) override {
    const int i = update.row;
    const Bounds<double>& bounds = problem.rows[i].bounds;
    in_order = in_order && i == after.size();
    unchanged = unchanged && problem.impulse == impulse && problem.velocity == velocity;
    clamped = clamped && update.impulse_before == impulse[i] &&
              update.impulse_after == bounds.clamp(impulse[i] + update.corrective, impulse);
    after.push_back(update.impulse_after);
  }
  void after_sweep(int, const VelocityProblem<double>& problem) override {
    applied = applied && problem.impulse == after;
    begin(problem);
  }
  bool in_order = true, unchanged = true, clamped = true, applied = true;

 private:
  void begin(const VelocityProblem<double>& problem) {
    impulse = problem.impulse;
    velocity = problem.velocity;
    after.clear();
  }
  PerRow<double> impulse = {}, after = {};
  PerBody<Vec3<double>> velocity = {};
};

}  // namespace

TEST_CASE("mass splitting is what it says: parts solved alone, and their velocities averaged") {
  VelocityProblem<double> problem = crooked_tower(4), parts = problem;
  Jacobi<double>({.iterations = 20}, Splitting::mass).solve(problem);
  for (int sweep = 0; sweep < 20; ++sweep) sweep_over_parts(parts);
  const double largest = *std::max_element(problem.impulse.begin(), problem.impulse.end());
  for (int i = 0; i < parts.impulse.size(); ++i) {
    CHECK(std::abs(problem.impulse[i] - parts.impulse[i]) <= 64 * 21 * double_epsilon * largest);
  }
}

TEST_CASE("a crooked tower with friction: split masses come to rest where plain Jacobi never does") {
  VelocityProblem<double> split = crooked_tower(10), plain = split;
  const double scale = residual_scale(split);
  const SolveReport report =
      Jacobi<double>({.iterations = 20000, .tolerance = 1e-3}, Splitting::mass).solve(split);
  CHECK(report.converged);
  Jacobi<double>({.iterations = 20000}).solve(plain);
  CHECK(!(residual(plain, scale).energy <= 1));  // no better than doing nothing
}

TEST_CASE("the order of rows changes nothing but rounding for Jacobi, and the answer for Gauss-Seidel") {
  const VelocityProblem<double> tower = crooked_tower(5);
  Jacobi<double> split({.iterations = 20}, Splitting::mass), damped({.iterations = 20, .relaxation = 0.125});
  SequentialImpulse<double> si({.iterations = 20});
  CHECK(effect_of_order(split, tower) <= 64 * 21 * double_epsilon);
  CHECK(effect_of_order(damped, tower) <= 64 * 21 * double_epsilon);
  CHECK(effect_of_order(si, tower) >= 0.01);
}

TEST_CASE("the order in the settings is of no concern to Jacobi") {
  for (const RowOrder order : {RowOrder::reverse, RowOrder::alternating, RowOrder::shuffled}) {
    VelocityProblem<double> as_written = crooked_tower(3), other = as_written;
    Jacobi<double>({.iterations = 20}, Splitting::mass).solve(as_written);
    Jacobi<double>({.iterations = 20, .order = order}, Splitting::mass).solve(other);
    CHECK(other.impulse == as_written.impulse);
  }
}

TEST_CASE(
    "an observer of Jacobi sees the sweep's beginning with every row, and all of it applied at the end") {
  VelocityProblem<double> problem = crooked_tower(3);
  BeginningWatcher watcher;
  Jacobi<double>({.iterations = 10}, Splitting::mass).solve(problem, &watcher);
  CHECK(watcher.in_order);
  CHECK(watcher.unchanged);
  CHECK(watcher.clamped);
  CHECK(watcher.applied);
}
