// Floor 8. Problems written by hand, and the simplest of them: boxes on each other.
#pragma once

#include <cairn/constraints/row.hpp>
#include <cairn/validation/case_constants.hpp>

namespace cairn::cases {

/// A problem with the ground and nothing else.
template <Scalar Real>
VelocityProblem<Real> empty_problem(Real dt = static_cast<Real>(standard_dt)) {
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

/// Boxes on the ground, one on the other, from the lowest mass up, that have fallen for one step under
/// `gravity` [m/s^2]: row j is the contact under box j + 1. One normal row an interface, as nothing can tilt.
template <Scalar Real>
VelocityProblem<Real> column(const List<Real>& masses, Real gravity = static_cast<Real>(standard_gravity),
                             Real dt = static_cast<Real>(standard_dt)) {
  VelocityProblem<Real> problem = empty_problem<Real>(dt);
  BodyId below = ground;
  for (const Real mass : masses) {
    const BodyId box = add_body<Real>(problem, mass, mass / 6, {0, -gravity * dt, 0});
    add_row(problem, vertical_row<Real>(below, box, Bounds<Real>::unilateral()));
    below = box;
  }
  return problem;
}

}  // namespace cairn::cases
