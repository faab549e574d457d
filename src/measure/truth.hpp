// Floor 6. How far an answer is from the truth of its problem.
#pragma once

#include <optional>

#include <cairn/solvers/residual.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// In all of this file `start` is a problem as a solver gets it: its velocities are v_free, those of the step
/// without any impulse. `answer` is the same problem with velocities v and impulses lambda [N s] as a solver
/// left them. Every function is pure. Body axes with an inverse mass of 0 count nowhere: nothing moves them.

/// ||v||_M = sqrt(v^T M v) [sqrt(J)]: the square root of twice the kinetic energy.
template <Scalar Real>
Real mass_norm(const PerBody<Vec3<Real>>& velocity, const PerBody<Vec3<Real>>& inverse_mass);

/// ||v - u||_M [sqrt(J)].
/// @throws std::invalid_argument unless there are equally many bodies in all three.
template <Scalar Real>
Real mass_distance(const PerBody<Vec3<Real>>& v, const PerBody<Vec3<Real>>& u,
                   const PerBody<Vec3<Real>>& inverse_mass);

/// E_M = ||v - v*||_M / ||v_free - v*||_M [1]: 1 without impulses, 0 at the truth v*. It does not depend on
/// which of the many impulses that move nothing are in lambda. Never divides by less than 1e-12 ||v*||_M; 0
/// where v is v*, infinite where v is wrong and v_free and v* are at rest. Only where v* is unique does it
/// mean anything.
/// @throws std::invalid_argument unless there are equally many bodies in all three.
template <Scalar Real>
Real velocity_error(const VelocityProblem<Real>& start, const PerBody<Vec3<Real>>& velocity,
                    const PerBody<Vec3<Real>>& truth);

/// v(lambda) = v_free + M^-1 J^T lambda (11), (19): what the velocities would be, had they not been gathered
/// impulse by impulse. Returns the problem with these impulses and velocities.
/// @throws std::invalid_argument unless there is one impulse for each row.
template <Scalar Real>
VelocityProblem<Real> with_impulses(const VelocityProblem<Real>& start, const PerRow<Real>& impulse);

/// delta = ||v - v(lambda)||_M / ||v_free - v||_M [1]: how far velocities and impulses have drifted apart by
/// rounding. Never divides by less than 1e-12 ||v||_M.
/// @throws std::invalid_argument unless both problems have equally many rows and bodies.
template <Scalar Real>
Real impulse_drift(const VelocityProblem<Real>& start, const VelocityProblem<Real>& answer);

/// G = sum (w_i)^+ (lambda_i - l_i)^+ + (-w_i)^+ (u_i - lambda_i)^+ [J], over the bounds l_i, u_i that are
/// finite, at the impulses as they are: the work that rows do which should do none. Of an infinite bound the
/// velocity w_i counts in AnswerSplit::primal instead. 0 at a solution; not only there.
template <Scalar Real>
Real complementarity_gap(const VelocityProblem<Real>& answer);

/// What is wrong with an answer, by kind (as in Q. Le Lidec et al., 2023).
template <Scalar Real>
struct AnswerSplit {
  /// The largest velocity that no impulse inside its bounds may leave [m/s; rad/s for rows on angles]:
  /// (-w)^+ where the upper bound is infinite, as for a contact, w^+ where the lower one is.
  Real primal = 0;
  Real dual = 0;             // [N s] the largest distance of an impulse from its interval
  Real complementarity = 0;  // [N s] the largest |e_i| of rows that are right in both
  /// The largest (|lambda_t| - limit)^+ / (limit + 1e-12 max |lambda|) of a friction row [1], where the limit
  /// is mu lambda_n, or what is left of a disc.
  Real cone = 0;
};
/// Takes an answer apart. O(m).
template <Scalar Real>
AnswerSplit<Real> answer_split(const VelocityProblem<Real>& answer);

/// r_inf in metres for all rows: max |A_ii e_i| [m/s], where a row on angles only is multiplied by the
/// largest length [m] of its bodies that can turn, such as their bounding radius. One length for each body.
/// @throws std::invalid_argument unless there is one length for each body.
template <Scalar Real>
Real worst_row_speed(const VelocityProblem<Real>& answer, const PerBody<Real>& lengths);

/// All of the above that needs nothing but the problem; E_M where the truth is given.
template <Scalar Real>
struct AnswerError {
  Residual<Real> returned = {};       // at the velocities that the solver returned
  Residual<Real> from_impulses = {};  // and at v(lambda)
  Real drift = 0;                     // delta
  Real gap = 0;                       // G [J]
  AnswerSplit<Real> split = {};       // by kind
  std::optional<Real> velocity = {};  // E_M of the velocities returned
};

/// @throws std::invalid_argument unless both problems have equally many rows and bodies.
template <Scalar Real>
AnswerError<Real> answer_error(const VelocityProblem<Real>& start, const VelocityProblem<Real>& answer,
                               const std::optional<PerBody<Vec3<Real>>>& truth = {});

}  // namespace cairn
