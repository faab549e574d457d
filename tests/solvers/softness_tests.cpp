// Soft rows: j v + gamma * impulse = bias.
#include <doctest/doctest.h>

#include <cmath>

#include "solver_list.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A soft row that pulls a mass to x = 0 with angular frequency omega and damping ratio zeta, by implicit
/// Euler: gamma = 1 / (dt (c + dt k)), bias = -k x / (c + dt k). Source: E. Catto, Soft Constraints (2011).
VelocityProblem<double> soft_spring(double x, double v, double mass, double omega, double zeta, double dt) {
  const double k = mass * omega * omega;     // [N/m]
  const double c = 2 * mass * zeta * omega;  // [N s/m]
  VelocityProblem<double> problem;
  problem.dt = dt;
  problem.velocity = {Vec3<double>::Zero(), Vec3<double>(v, 0, 0)};
  problem.inverse_mass = {Vec3<double>::Zero(), Vec3<double>(1 / mass, 1 / mass, 0)};
  ConstraintRow<double> row;
  row.b = {1};
  row.jacobian_b = {1, 0, 0};
  row.softness = 1 / (dt * (c + dt * k));
  row.bias = -x * k / (c + dt * k);
  problem.rows = {row};
  problem.blocks = {{0, 1}};
  problem.impulse = {0};
  return problem;
}

}  // namespace

TEST_CASE("a soft row moves a mass exactly as implicit Euler moves a damped spring") {
  const double omega = 2 * pi * 2, dt = 1.0 / 60;
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double zeta : {0.0, 0.5, 2.0}) {
      double x = 0.1, v = 0;
      for (int step = 0; step < 10; ++step) {
        VelocityProblem<double> problem = soft_spring(x, v, 3, omega, zeta, dt);
        make({.iterations = 1})->solve(problem);
        const double expected =
            (v - dt * omega * omega * x) / (1 + 2 * zeta * omega * dt + dt * dt * omega * omega);
        CHECK(problem.velocity[{1}].x() == doctest::Approx(expected).epsilon(1e-13));
        v = problem.velocity[{1}].x();
        x += dt * v;
      }
    }
  }
}

TEST_CASE("the accumulated impulse of a soft row counts: more sweeps change nothing") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    VelocityProblem<double> once = soft_spring(0.1, 1, 1, 10, 0.5, 0.02);
    VelocityProblem<double> often = once;
    make({.iterations = 1})->solve(once);
    make({.iterations = 50})->solve(often);
    CHECK(often.impulse[0] == doctest::Approx(once.impulse[0]).epsilon(64 * 51 * 2.2e-16));
  }
}
