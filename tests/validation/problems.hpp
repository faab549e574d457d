// Problems written by hand, row by row, and worlds stepped for a while: what the validation tests share.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "../solvers/solver_list.hpp"
#include "measure/recorder.hpp"
#include "world/world.hpp"

namespace cairn::testing {

inline constexpr double test_gravity = 10;   // [m/s^2] g, the default of a scene
inline constexpr double test_dt = 1.0 / 60;  // [s], the default of a scene
inline constexpr double double_epsilon = std::numeric_limits<double>::epsilon();

/// A problem with the ground and nothing else.
template <Scalar Real>
VelocityProblem<Real> empty_problem(Real dt = static_cast<Real>(test_dt)) {
  VelocityProblem<Real> problem;
  problem.dt = dt;
  problem.velocity = {Vec3<Real>::Zero()};
  problem.inverse_mass = {Vec3<Real>::Zero()};
  return problem;
}

/// Adds a body of the given mass [kg] and inertia [kg m^2].
template <Scalar Real>
BodyId add_body(VelocityProblem<Real>& problem, Real mass, Real inertia, const Vec3<Real>& velocity) {
  problem.velocity.push_back(velocity);
  problem.inverse_mass.push_back({1 / mass, 1 / mass, 1 / inertia});
  return {problem.body_count() - 1};
}

/// Adds a row as a block of its own, without an impulse to start from, and returns its place.
template <Scalar Real>
int add_row(VelocityProblem<Real>& problem, const ConstraintRow<Real>& row) {
  problem.blocks.push_back({problem.row_count(), 1});
  problem.rows.push_back(row);
  problem.impulse.push_back(0);
  return problem.row_count() - 1;
}

/// The row of two bodies that meet, or are tied, along y: j v = v_b - v_a.
template <Scalar Real>
ConstraintRow<Real> vertical_row(BodyId a, BodyId b, const Bounds<Real>& bounds) {
  ConstraintRow<Real> row;
  row.a = a;
  row.b = b;
  row.jacobian_a = {0, -1, 0};
  row.jacobian_b = {0, 1, 0};
  row.bounds = bounds;
  return row;
}

/// A contact of the ground with body `b` at arm (x, y) from its centre: the normal is up.
template <Scalar Real>
ConstraintRow<Real> floor_row(BodyId b, Real x) {
  ConstraintRow<Real> row;
  row.b = b;
  row.jacobian_b = {0, 1, x};
  row.bounds = Bounds<Real>::unilateral();
  return row;
}

/// The friction that goes with row `normal`, at height y from the centre of `b`: the tangent points right.
template <Scalar Real>
ConstraintRow<Real> floor_friction_row(BodyId b, Real y, Real friction, int normal) {
  ConstraintRow<Real> row;
  row.b = b;
  row.jacobian_b = {1, 0, -y};
  row.bounds = Bounds<Real>::coulomb(friction, normal);
  return row;
}

/// Boxes on the ground, one on the other, from the lowest mass up, that have fallen for one step: row j is
/// the contact under box j + 1. One normal row an interface, as nothing can tilt.
template <Scalar Real>
VelocityProblem<Real> column(const std::vector<Real>& masses) {
  VelocityProblem<Real> problem = empty_problem<Real>();
  const Real fall = -static_cast<Real>(test_gravity) * problem.dt;
  BodyId below = ground;
  for (const Real mass : masses) {
    const BodyId box = add_body<Real>(problem, mass, mass / 6, {0, fall, 0});
    add_row(problem, vertical_row<Real>(below, box, Bounds<Real>::unilateral()));
    below = box;
  }
  return problem;
}

/// n equal boxes.
template <Scalar Real>
VelocityProblem<Real> stack(int n) {
  return column<Real>(std::vector<Real>(static_cast<std::size_t>(n), Real(1)));
}

/// Beads of 1 kg on a line, each tied to the next by a rod, at rest but for the first, which was struck.
/// Rows: n - 1.
inline VelocityProblem<double> free_chain(int n) {
  VelocityProblem<double> problem = empty_problem<double>();
  BodyId last = add_body<double>(problem, 1, 1, {0, 1, 0});
  for (int i = 1; i < n; ++i) {
    const BodyId bead = add_body<double>(problem, 1, 1, {0, 0, 0});
    add_row(problem, vertical_row<double>(last, bead, Bounds<double>::equality()));
    last = bead;
  }
  return problem;
}

/// All impulses after each sweep, in the scalar they were computed in. Sweep 0 is the start.
template <Scalar Real>
class ImpulseTrace final : public SolveObserver<Real> {
 public:
  void before_solve(const VelocityProblem<Real>& problem) override { sweeps = {problem.impulse}; }
  void after_sweep(int, const VelocityProblem<Real>& problem) override { sweeps.push_back(problem.impulse); }
  std::vector<std::vector<Real>> sweeps = {};
};

/// By how much one sweep shrinks the residual R_E, averaged from sweep `first` to sweep `last`.
inline double measured_rate(const SolverMaker<double>& make, VelocityProblem<double> problem, int first,
                            int last) {
  SweepRecorder<double> recorder;
  make({.iterations = last})->solve(problem, &recorder);
  const double before = recorder.sweeps()[static_cast<std::size_t>(first)].residual_energy;
  const double after = recorder.sweeps()[static_cast<std::size_t>(last)].residual_energy;
  return std::pow(after / before, 1.0 / (last - first));
}

/// Steps the world for about this long [s]: a whole number of steps.
template <Scalar Real>
void run(World<Real>& world, Solver<Real>& solver, double seconds) {
  const int steps = static_cast<int>(std::lround(seconds / world.dt()));
  for (int i = 0; i < steps; ++i) world.step(solver);
}

/// A body's velocity and position in the world, by id.
template <Scalar Real>
const Vec3<Real>& velocity_of(const World<Real>& world, BodyId body) {
  return world.bodies().velocity[static_cast<std::size_t>(body.index)];
}
template <Scalar Real>
const Pose<Real>& pose_of(const World<Real>& world, BodyId body) {
  return world.bodies().pose[static_cast<std::size_t>(body.index)];
}

/// Checks that an error, given the steps per second, shrinks in proportion to dt: order 0.8 to 1.2 over three
/// halvings from 1/60 s.
inline void check_first_order(const std::function<double(double)>& error) {
  double coarse = std::abs(error(60));
  for (const double frequency : {120.0, 240.0, 480.0}) {
    const double fine = std::abs(error(frequency));
    CAPTURE(frequency);
    CHECK(std::log2(coarse / fine) >= 0.8);
    CHECK(std::log2(coarse / fine) <= 1.2);
    coarse = fine;
  }
}

}  // namespace cairn::testing
