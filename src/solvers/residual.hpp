// Floor 4. How far an answer is from solving its problem.
#pragma once

#include <cairn/constraints/row.hpp>

namespace cairn {

/// For row i let w_i = j v + softness * impulse - bias, and let
///   e_i = impulse_i - clamp(impulse_i - w_i / A_ii)   [N s]
/// be the change that row still asks for: 0 for every row exactly at a solution. A_ii e_i is a velocity
/// error.
template <Scalar Real>
struct Residual {
  Real energy = 0;             // R_E = sqrt(sum A_ii e_i^2) / scale: 1 with no impulses at all, 0 when solved
  Real velocity = 0;           // r_inf = max |A_ii e_i| [m/s; rad/s for rows on angles]
  Real velocity_equality = 0;  // the same over joints,
  Real velocity_normal = 0;    // over contact normals (and other one-sided rows),
  Real velocity_friction = 0;  // and over friction rows [m/s]
};

/// The scale of R_E [sqrt(J)]: sqrt(sum A_ii e_i^2) at impulse 0, over all rows but friction. `problem` must
/// hold the velocities that the step starts from. Never below 1e-12 of the velocity's own kinetic norm, so
/// that a system with nothing to do has a residual of 0 rather than a quotient of round-offs. Scaling as in
/// Solfec's merit function (T. Koziara, 2008): energy left over energy at the start.
template <Scalar Real>
Real residual_scale(const VelocityProblem<Real>& problem);

/// What no scale of R_E is below [sqrt(J)].
template <Scalar Real>
Real least_scale(const VelocityProblem<Real>& problem);

/// What a row has in the sum of the scale [J]: A_ii e_i^2 at impulse 0; of friction, which has nothing to
/// lean on there, 0.
template <Scalar Real>
Real starting_energy(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row);

/// What a row with an impulse [N s] has in the sum of R_E [J]: A_ii e_i^2; 0 for a row whose bodies nothing
/// can move.
template <Scalar Real>
Real correction_energy(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row, Real impulse);

/// w_i of row i, at the problem's velocities and impulses [m/s; rad/s for rows on angles].
template <Scalar Real>
Real row_velocity_error(const VelocityProblem<Real>& problem, int i);

/// e_i of row i [N s]; 0 for a row whose bodies nothing can move.
template <Scalar Real>
Real natural_correction(const VelocityProblem<Real>& problem, int i);

/// The residual of problem.impulse and problem.velocity. O(m).
template <Scalar Real>
Residual<Real> residual(const VelocityProblem<Real>& problem, Real scale);

}  // namespace cairn
