// The solvers under test, and a stack for them.
#pragma once

#include "validation/case_solvers.hpp"

namespace cairn::testing {

using namespace cairn::cases;

/// n boxes of mass 1 kg on the ground, one normal row an interface, falling for one step: row j between j and
/// j + 1.
template <Scalar Real>
VelocityProblem<Real> hand_made_stack(int boxes, Real g, Real dt) {
  VelocityProblem<Real> problem;
  problem.dt = dt;
  problem.velocity.assign(boxes + 1, Vec3<Real>(0, -g * dt, 0));
  problem.inverse_mass.assign(boxes + 1, Vec3<Real>(1, 1, 6));
  problem.velocity[ground].setZero();
  problem.inverse_mass[ground].setZero();
  for (int i = 0; i < boxes; ++i) {
    ConstraintRow<Real> row;
    row.a = {i};
    row.b = {i + 1};
    row.jacobian_a = {0, -1, 0};
    row.jacobian_b = {0, 1, 0};
    row.bounds = Bounds<Real>::unilateral();
    problem.rows.push_back(row);
    problem.blocks.push_back({i, 1});
  }
  problem.impulse.assign(problem.rows.size(), Real(0));
  return problem;
}

}  // namespace cairn::testing
