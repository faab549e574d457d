// Floor 3. How fast errors go: from what a constraint states to what a solver is given.
#pragma once

#include "constraints/constraint.hpp"

namespace cairn {

/// Baumgarte stabilization (4), (7). Contacts may keep `slop` of overlap, so that they do not flicker.
struct Stabilization {
  double baumgarte = 0.2;  // beta: the share of an error that one step removes
  double slop = 0.005;     // [m] overlap of contacts that is left alone
};

/// zeta (7) of one row: the value that j v should take in a step of dt [s].
///   an equality        -beta C / dt
///   an inequality with room left (C > 0)        -C / dt: it may use its room up, and no more
///   an inequality that is violated (C < 0)      beta max(0, -C - slop) / dt
/// and, if the free velocity would make the bodies meet within the step, at least the rebound. A motor asks
/// for its speed. In a soft row its spring's rate takes the place of beta / dt, and there is no slop.
/// `velocity` is the velocity that the step would have without constraints.
template <Scalar Real>
Real bias_velocity(const RowSpec<Real>& spec, const Stabilization& stabilization, Real dt,
                   const std::vector<Vec3<Real>>& velocity);

/// The row of `spec` in a step of `problem`, whose dt, inverse masses and velocities are those of the step
/// without constraints: with the bias above, the softness of its spring, and a motor's force as an impulse.
/// The block of the row begins at row `first_row`. Terms of further bodies go to the problem's extra terms.
template <Scalar Real>
ConstraintRow<Real> stabilized_row(const RowSpec<Real>& spec, const Stabilization& stabilization,
                                   VelocityProblem<Real>& problem, std::uint64_t source, int first_row);

}  // namespace cairn
