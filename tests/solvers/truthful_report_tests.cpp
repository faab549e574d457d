// What every solver must do besides, for every scalar: come to the one answer there is, keep bounds between
// sweeps, and say truthfully why it stopped.
#include "solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A box that slides on two feet with friction, a lid tied to its top, and a motor between the two, of which
/// the force is limited: every kind of bounds, and one answer for the velocities.
template <Scalar Real>
VelocityProblem<Real> box_with_a_lid() {
  VelocityProblem<Real> problem = box_on_feet<Real>({Real(-0.5), Real(0.5)}, {2, Real(-0.2), 0}, Real(0.3));
  problem.dt = Real(0.02);
  const BodyId lid = add_body<Real>(problem, 2, Real(1) / 3, {0, Real(-0.2), 0});
  ConstraintRow<Real> row = vertical_row<Real>({1}, lid, Bounds<Real>::equality());
  add_row(problem, row);
  row.jacobian_a = {-1, 0, 0};
  row.jacobian_b = {1, 0, 0};
  row.bounds = Bounds<Real>::at_most(Real(0.1));
  row.bias = 1;
  add_row(problem, row);
  return problem;
}

/// Jacobi's friction is bounded by the normal impulse that the sweep began with: at a standstill it is
/// inside.
template <Scalar Real>
List<SolverMaker<Real>> solvers_in_turn() {
  List<SolverMaker<Real>> solvers = all_solvers<Real>();
  solvers.push_back(maker<AcceleratedProjectedGaussSeidel<Real>, Real>());
  return solvers;
}

}  // namespace

TEST_CASE_TEMPLATE("where the velocities are unique, every solver finds them from any start", Real, float,
                   double) {
  const VelocityProblem<Real> cold = box_with_a_lid<Real>();
  // Known in advance: feet and lid rest vertically; friction takes 0.3 of the weight of 1 kg and 2 kg that
  // falls at 0.2 m/s off the box, the motor 0.1 N s more, which the lid gains.
  const Real friction = Real(0.3) * Real(0.2) * 3;
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    for (const Real start : {Real(0), Real(0.05), Real(0.4)}) {
      VelocityProblem<Real> problem = cold;
      for (int i = 0; i < problem.impulse.size(); ++i) {
        problem.impulse[i] = problem.rows[i].bounds.clamp(start, problem.impulse);
      }
      make({.iterations = 3000})->solve(problem);
      const PerBody<Vec3<Real>> expected = {
          Vec3<Real>::Zero(), {2 - friction - Real(0.1), 0, 0}, {Real(0.1) / 2, 0, 0}};
      // Speeds of 2 m/s and spins of up to 12 rad/s, rounded a few times in each sweep; sweeps contract.
      CHECK(largest_gap(problem.velocity, expected) <= 256 * std::numeric_limits<Real>::epsilon() * 2);
    }
  }
}

TEST_CASE_TEMPLATE("a velocity that is not a number leaves none in the residual, whatever row it is in", Real,
                   float, double, long double) {
  for (const BodyId body : {BodyId{1}, BodyId{2}}) {
    VelocityProblem<Real> problem = box_with_a_lid<Real>();
    const Real scale = residual_scale(problem);
    problem.velocity[body].x() = std::numeric_limits<Real>::quiet_NaN();
    const Residual<Real> found = residual(problem, scale);
    CHECK(std::isnan(found.velocity));
    CHECK(std::isnan(found.energy));
  }
}

TEST_CASE_TEMPLATE("every impulse is inside its bounds after every sweep", Real, float, double) {
  for (const SolverMaker<Real>& make : solvers_in_turn<Real>()) {
    VelocityProblem<Real> problem = box_with_a_lid<Real>();
    problem.impulse = {2, 1, 0, 0, -1, Real(0.1)};  // inside them, and far from the answer
    SweepWatcher<Real> watcher;
    make({.iterations = 30})->solve(problem, &watcher);
    CHECK(watcher.sweeps == 30);
    CHECK(watcher.outside == 0);
  }
}

TEST_CASE_TEMPLATE("no rows and no sweeps are no work, in every scalar", Real, float, double) {
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    VelocityProblem<Real> empty;
    empty.velocity = {Vec3<Real>(1, 2, 3)};
    empty.inverse_mass = {Vec3<Real>(1, 1, 1)};
    make({})->solve(empty);
    CHECK(empty.velocity[{0}] == Vec3<Real>(1, 2, 3));

    VelocityProblem<Real> problem = box_with_a_lid<Real>();
    problem.impulse = {Real(0.25), 0, Real(0.5), 0, 1, 0};
    const PerRow<Real> warm = problem.impulse;
    const SolveReport report = make({.iterations = 0})->solve(problem);
    CHECK(report.iterations == 0);
    CHECK(report.stop == Stop::sweeps);
    CHECK_FALSE(report.converged);
    CHECK(problem.impulse == warm);
    // The box gets 0.25 and 0.5 at feet 0.5 m from its middle, and passes 1 N s on to the lid.
    const PerBody<Vec3<Real>> expected = {
        Vec3<Real>::Zero(), {2, Real(-0.2) - Real(0.25), Real(0.75)}, {0, Real(0.3), 0}};
    CHECK(largest_gap(problem.velocity, expected) <= 16 * std::numeric_limits<Real>::epsilon() * 2);
  }
}

TEST_CASE_TEMPLATE("every solver says truthfully why it stopped, and after which sweep", Real, float,
                   double) {
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    const VelocityProblem<Real> start = box_with_a_lid<Real>();
    const Real scale = residual_scale(start);
    VelocityProblem<Real> cut_short = start;
    const SolveReport sweeps = make({.iterations = 3, .tolerance = 1e-5, .patience = 5})->solve(cut_short);
    CHECK(sweeps.stop == Stop::sweeps);
    CHECK(sweeps.iterations == 3);
    CHECK_FALSE(sweeps.converged);
    CHECK(residual(cut_short, scale).energy > Real(1e-5));

    VelocityProblem<Real> arrived = start;
    SweepWatcher<Real> watcher;
    const SolveReport tolerance = make({.iterations = 100000, .tolerance = 1e-5})->solve(arrived, &watcher);
    CHECK(tolerance.stop == Stop::tolerance);
    CHECK(tolerance.converged);
    CHECK(tolerance.iterations == watcher.sweeps);
    // Judged on velocities that the solver kept by its own sums: the last rounding may differ.
    CHECK(residual(arrived, scale).energy <= Real(1e-5) + 64 * epsilon);

    VelocityProblem<Real> at_rest = start;
    const SolveReport stalled = make({.iterations = 100000, .patience = 4})->solve(at_rest);
    CHECK(stalled.stop == Stop::stalled);
    CHECK_FALSE(stalled.converged);  // none was asked for
    CHECK(stalled.iterations < 100000);
    CHECK(residual(at_rest, scale).energy <= 1000 * epsilon);
    // Its last sweep changed nothing but 16 roundings of impulses that are below 1 N s here.
    CHECK(stalled.largest_change <= static_cast<double>(16 * epsilon));
  }
}

TEST_CASE_TEMPLATE("an observer changes neither velocities nor the report", Real, float, double) {
  for (const SolverMaker<Real>& make : all_solvers<Real>(Iterates::any)) {
    VelocityProblem<Real> alone = box_with_a_lid<Real>(), watched = alone;
    SweepWatcher<Real> watcher;
    const SolverSettings settings = {.iterations = 1000, .tolerance = 1e-4, .patience = 3};
    const SolveReport without = make(settings)->solve(alone);
    const SolveReport with = make(settings)->solve(watched, &watcher);
    CHECK(with.iterations == without.iterations);
    CHECK(with.stop == without.stop);
    CHECK(with.largest_change == without.largest_change);
    CHECK(watched.impulse == alone.impulse);
    CHECK(largest_gap(watched.velocity, alone.velocity) == 0);
  }
}
