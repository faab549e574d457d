// Floor 4. The big matrices of the paper's section 2, built as they are written there.
#pragma once

#include <Eigen/Core>

#include <cairn/constraints/row.hpp>

namespace cairn {

/// A matrix whose size is known at run time.
template <Scalar Real>
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
/// A column whose length is known at run time.
template <Scalar Real>
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;

/// Three numbers a body, n bodies, m rows. The ground has its columns too; its inverse mass is 0.
template <Scalar Real>
struct SystemMatrices {
  Matrix<Real> J;             // m x 3n, (6)
  Vector<Real> inverse_mass;  // 3n, the diagonal of M^-1 (2)
  Matrix<Real> A;             // m x m, J M^-1 J^T (15), with softness added on the diagonal [1/kg]
  Vector<Real> b;             // m, (zeta - J v_1) / dt (15) [m/s^2]
};

/// v of (1): all velocities of the problem in one column, 3n.
template <Scalar Real>
void system_velocity(const VelocityProblem<Real>& problem, Vector<Real>& velocity);

/// Everything that section 2 sets up, from velocities that hold gravity already: eq. (12) knows no external
/// force, so it must be in v_1.
template <Scalar Real>
SystemMatrices<Real> system_matrices(const VelocityProblem<Real>& problem);
/// The same into matrices that are there: nothing is allocated for a problem of the size of the last.
template <Scalar Real>
void system_matrices(const VelocityProblem<Real>& problem, SystemMatrices<Real>& system);

}  // namespace cairn
