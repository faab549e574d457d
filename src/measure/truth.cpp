// Floor 6. Errors of an answer.
#include <cairn/measure/truth.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

template <Scalar Real>
void require_same_size(const VelocityProblem<Real>& start, const VelocityProblem<Real>& answer,
                       const char* place) {
  require(start.rows.size() == answer.rows.size() && start.rows.size() == answer.impulse.size(), place,
          "answer", "of as many rows as the start", static_cast<double>(answer.impulse.size()));
  require(start.velocity.size() == answer.velocity.size(), place, "answer", "of as many bodies as the start",
          static_cast<double>(answer.velocity.size()));
}

/// error / scale, where the scale may be that of rounding or nothing at all.
template <Scalar Real>
Real relative_to(Real error, Real scale, Real own_norm) {
  const Real least = std::max(scale, Real(1e-12) * own_norm);
  if (error == 0) return 0;
  return least > 0 ? error / least : std::numeric_limits<Real>::infinity();
}

/// The larger of the two; a NaN stays, for an answer that is none must not look like a good one.
template <Scalar Real>
Real worse_of(Real worst, Real next) {
  return next > worst || std::isnan(next) ? next : worst;
}

/// A row's interval at the impulses as they are [N s].
template <Scalar Real>
struct Interval {
  Real lower = 0;
  Real upper = 0;
};

template <Scalar Real>
Interval<Real> interval_of(const VelocityProblem<Real>& problem, int i) {
  const Real infinity = std::numeric_limits<Real>::infinity();
  const Bounds<Real>& bounds = problem.rows[i].bounds;
  return {bounds.clamp(-infinity, problem.impulse), bounds.clamp(infinity, problem.impulse)};
}

/// Whether nothing can move along the row.
template <Scalar Real>
bool is_idle(const VelocityProblem<Real>& problem, int i) {
  return !(inverse_effective_mass(problem, problem.rows[i]) > 0);
}

/// The part of w that an infinite bound forbids.
template <Scalar Real>
Real primal_violation(const Interval<Real>& interval, Real w) {
  Real worst = 0;
  if (std::isinf(interval.upper)) worst = worse_of(worst, -w);
  if (std::isinf(interval.lower)) worst = worse_of(worst, w);
  return worst;
}

template <Scalar Real>
Real largest_impulse(const VelocityProblem<Real>& problem) {
  Real largest = 0;
  for (const Real impulse : problem.impulse) largest = std::max(largest, std::abs(impulse));
  return largest;
}

/// The largest length of the bodies that the row turns; 0 for a row that moves any of them along.
template <Scalar Real>
Real length_of_angular_row(const VelocityProblem<Real>& problem, const ConstraintRow<Real>& row,
                           const PerBody<Real>& lengths) {
  bool is_angular = true;
  Real length = 0;
  for_each_term(problem, row, [&](BodyId body, const Vec3<Real>& jacobian) {
    is_angular = is_angular && jacobian.x() == 0 && jacobian.y() == 0;
    if (jacobian.z() != 0 && problem.inverse_mass[body].z() > 0) length = std::max(length, lengths[body]);
  });
  return is_angular ? length : Real(0);
}

}  // namespace

template <Scalar Real>
Real mass_norm(const PerBody<Vec3<Real>>& velocity, const PerBody<Vec3<Real>>& inverse_mass) {
  return mass_distance(velocity, PerBody<Vec3<Real>>(velocity.size(), Vec3<Real>::Zero()), inverse_mass);
}

template <Scalar Real>
Real mass_distance(const PerBody<Vec3<Real>>& v, const PerBody<Vec3<Real>>& u,
                   const PerBody<Vec3<Real>>& inverse_mass) {
  require(v.size() == u.size() && v.size() == inverse_mass.size(), "mass_distance", "velocities",
          "one for each body", static_cast<double>(u.size()));
  Real sum = 0;
  for (const BodyId body : v.indices()) {
    for (int axis = 0; axis < 3; ++axis) {
      const Real inverse = inverse_mass[body](axis);
      const Real gap = v[body](axis) - u[body](axis);
      if (inverse > 0) sum += gap * gap / inverse;
    }
  }
  return std::sqrt(sum);
}

template <Scalar Real>
Real velocity_error(const VelocityProblem<Real>& start, const PerBody<Vec3<Real>>& velocity,
                    const PerBody<Vec3<Real>>& truth) {
  return relative_to(mass_distance(velocity, truth, start.inverse_mass),
                     mass_distance(start.velocity, truth, start.inverse_mass),
                     mass_norm(truth, start.inverse_mass));
}

template <Scalar Real>
VelocityProblem<Real> with_impulses(const VelocityProblem<Real>& start, const PerRow<Real>& impulse) {
  require(impulse.size() == start.rows.size(), "with_impulses", "impulse", "one for each row",
          static_cast<double>(impulse.size()));
  VelocityProblem<Real> result = start;
  result.impulse = impulse;
  for (int i = 0; i < result.row_count(); ++i) apply_impulse(result, result.rows[i], impulse[i]);
  return result;
}

template <Scalar Real>
Real impulse_drift(const VelocityProblem<Real>& start, const VelocityProblem<Real>& answer) {
  require_same_size(start, answer, "impulse_drift");
  const VelocityProblem<Real> rebuilt = with_impulses(start, answer.impulse);
  return relative_to(mass_distance(answer.velocity, rebuilt.velocity, start.inverse_mass),
                     mass_distance(start.velocity, answer.velocity, start.inverse_mass),
                     mass_norm(answer.velocity, start.inverse_mass));
}

template <Scalar Real>
Real complementarity_gap(const VelocityProblem<Real>& answer) {
  Real sum = 0;
  for (int i = 0; i < answer.row_count(); ++i) {
    if (is_idle(answer, i)) continue;
    const Interval<Real> interval = interval_of(answer, i);
    const Real w = row_velocity_error(answer, i), impulse = answer.impulse[i];
    if (!std::isfinite(w) || !std::isfinite(impulse)) return std::numeric_limits<Real>::quiet_NaN();
    if (w > 0 && std::isfinite(interval.lower)) sum += w * std::max(impulse - interval.lower, Real(0));
    if (w < 0 && std::isfinite(interval.upper)) sum -= w * std::max(interval.upper - impulse, Real(0));
  }
  return sum;
}

template <Scalar Real>
AnswerSplit<Real> answer_split(const VelocityProblem<Real>& answer) {
  AnswerSplit<Real> split;
  const Real least = Real(1e-12) * largest_impulse(answer);
  for (int i = 0; i < answer.row_count(); ++i) {
    if (is_idle(answer, i)) continue;
    const Interval<Real> interval = interval_of(answer, i);
    const Real impulse = answer.impulse[i];
    const Real primal = primal_violation(interval, row_velocity_error(answer, i));
    const Real outside = std::max({interval.lower - impulse, impulse - interval.upper, Real(0)});
    split.primal = worse_of(split.primal, primal);
    split.dual = worse_of(split.dual, outside);
    if (primal == 0 && outside == 0) {
      split.complementarity = worse_of(split.complementarity, std::abs(natural_correction(answer, i)));
    }
    if (answer.rows[i].bounds.is_friction() && !(outside == 0)) {
      split.cone = worse_of(split.cone, outside / (interval.upper + least));
    }
  }
  return split;
}

template <Scalar Real>
Real worst_row_speed(const VelocityProblem<Real>& answer, const PerBody<Real>& lengths) {
  require(lengths.size() == answer.velocity.size(), "worst_row_speed", "lengths", "one for each body",
          static_cast<double>(lengths.size()));
  Real worst = 0;
  for (int i = 0; i < answer.row_count(); ++i) {
    const ConstraintRow<Real>& row = answer.rows[i];
    const Real length = length_of_angular_row(answer, row, lengths);
    const Real speed = std::abs(inverse_effective_mass(answer, row) * natural_correction(answer, i));
    worst = worse_of(worst, length > 0 ? length * speed : speed);
  }
  return worst;
}

template <Scalar Real>
AnswerError<Real> answer_error(const VelocityProblem<Real>& start, const VelocityProblem<Real>& answer,
                               const std::optional<PerBody<Vec3<Real>>>& truth) {
  require_same_size(start, answer, "answer_error");
  const Real scale = residual_scale(start);
  AnswerError<Real> error{.returned = residual(answer, scale),
                          .from_impulses = residual(with_impulses(start, answer.impulse), scale),
                          .drift = impulse_drift(start, answer),
                          .gap = complementarity_gap(answer),
                          .split = answer_split(answer)};
  if (truth) error.velocity = velocity_error(start, answer.velocity, *truth);
  return error;
}

template float mass_norm(const PerBody<Vec3<float>>&, const PerBody<Vec3<float>>&);
template float mass_distance(const PerBody<Vec3<float>>&, const PerBody<Vec3<float>>&,
                             const PerBody<Vec3<float>>&);
template float velocity_error(const VelocityProblem<float>&, const PerBody<Vec3<float>>&,
                              const PerBody<Vec3<float>>&);
template VelocityProblem<float> with_impulses(const VelocityProblem<float>&, const PerRow<float>&);
template float impulse_drift(const VelocityProblem<float>&, const VelocityProblem<float>&);
template float complementarity_gap(const VelocityProblem<float>&);
template AnswerSplit<float> answer_split(const VelocityProblem<float>&);
template float worst_row_speed(const VelocityProblem<float>&, const PerBody<float>&);
template AnswerError<float> answer_error(const VelocityProblem<float>&, const VelocityProblem<float>&,
                                         const std::optional<PerBody<Vec3<float>>>&);
template double mass_norm(const PerBody<Vec3<double>>&, const PerBody<Vec3<double>>&);
template double mass_distance(const PerBody<Vec3<double>>&, const PerBody<Vec3<double>>&,
                              const PerBody<Vec3<double>>&);
template double velocity_error(const VelocityProblem<double>&, const PerBody<Vec3<double>>&,
                               const PerBody<Vec3<double>>&);
template VelocityProblem<double> with_impulses(const VelocityProblem<double>&, const PerRow<double>&);
template double impulse_drift(const VelocityProblem<double>&, const VelocityProblem<double>&);
template double complementarity_gap(const VelocityProblem<double>&);
template AnswerSplit<double> answer_split(const VelocityProblem<double>&);
template double worst_row_speed(const VelocityProblem<double>&, const PerBody<double>&);
template AnswerError<double> answer_error(const VelocityProblem<double>&, const VelocityProblem<double>&,
                                          const std::optional<PerBody<Vec3<double>>>&);
template long double mass_norm(const PerBody<Vec3<long double>>&, const PerBody<Vec3<long double>>&);
template long double mass_distance(const PerBody<Vec3<long double>>&, const PerBody<Vec3<long double>>&,
                                   const PerBody<Vec3<long double>>&);
template long double velocity_error(const VelocityProblem<long double>&, const PerBody<Vec3<long double>>&,
                                    const PerBody<Vec3<long double>>&);
template VelocityProblem<long double> with_impulses(const VelocityProblem<long double>&,
                                                    const PerRow<long double>&);
template long double impulse_drift(const VelocityProblem<long double>&, const VelocityProblem<long double>&);
template long double complementarity_gap(const VelocityProblem<long double>&);
template AnswerSplit<long double> answer_split(const VelocityProblem<long double>&);
template long double worst_row_speed(const VelocityProblem<long double>&, const PerBody<long double>&);
template AnswerError<long double> answer_error(const VelocityProblem<long double>&,
                                               const VelocityProblem<long double>&,
                                               const std::optional<PerBody<Vec3<long double>>>&);

}  // namespace cairn
