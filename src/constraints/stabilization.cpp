// Floor 3. Stabilization policies, slack rows, restitution, springs and motors: one line each.
#include "constraints/stabilization.hpp"

#include <algorithm>
#include <cmath>

#include "constraints/springs.hpp"

namespace cairn {

namespace {

template <Scalar Real>
Real spec_velocity(const RowSpec<Real>& spec, const PerBody<Vec3<Real>>& velocity) {
  Real jv = dot(spec.jacobian_a, velocity[spec.a]) + dot(spec.jacobian_b, velocity[spec.b]);
  for (int k = 0; k < spec.extra_count; ++k) {
    const RowTerm<Real>& term = spec.extra[k];
    jv += dot(term.jacobian, velocity[term.body]);
  }
  return jv;
}

/// Whether a row is meant to give way, or holds no position: it has no error that positions could take back.
template <Scalar Real>
bool holds_no_position(const RowSpec<Real>& spec) {
  return spec.softness || spec.max_force || spec.bounds.is_friction();
}

bool policy_has_springs(const Stabilization& stabilization, StabilizationPass pass) {
  return stabilization.policy == StabilizationPolicy::soft && pass == StabilizationPass::velocity;
}

/// Whether the error of a row goes by a spring of the policy.
template <Scalar Real>
bool is_on_spring(const RowSpec<Real>& spec, const RowRule<Real>& rule) {
  return rule.has_springs && !holds_no_position(spec) && !(spec.bounds.is_unilateral() && spec.error >= 0);
}

/// By how much of its error a rigid row recovers in a second: what stands for beta / dt in (7).
template <Scalar Real>
Real recovery_rate(const Stabilization& stabilization, StabilizationPass pass, Real dt) {
  const bool now =
      stabilization.policy == StabilizationPolicy::baumgarte ||
      (stabilization.policy == StabilizationPolicy::relaxed && pass == StabilizationPass::velocity) ||
      (stabilization.policy == StabilizationPolicy::split_impulse && pass == StabilizationPass::position);
  return now ? static_cast<Real>(stabilization.baumgarte) / dt : Real(0);
}

/// Without a limit to speeds.
template <Scalar Real>
RowRule<Real> rule_on_springs(const Stabilization& stabilization, StabilizationPass pass, Real dt,
                              const SwingSoftness& soft) {
  const SwingSoftness spring = spring_in_steps(soft, static_cast<double>(dt));
  return {.dt = dt,
          .only_corrects = pass == StabilizationPass::position,
          .slop = static_cast<Real>(stabilization.slop.value_or(usual_slop)),
          .rigid_rate = recovery_rate(stabilization, pass, dt),
          .has_springs = policy_has_springs(stabilization, pass),
          .spring_rate = return_rate<Real>(spring, dt),
          .spring_divisor = softness_divisor(spring, dt),
          .most_softness = most_softness<Real>(),
          .most_speed = std::numeric_limits<Real>::infinity()};
}

}  // namespace

SwingSoftness spring_in_steps(SwingSoftness spring, double dt) {
  spring.frequency = std::min(spring.frequency, 0.25 / dt);
  return spring;
}

double spring_sag(const SwingSoftness& spring, double dt, double acceleration) {
  const double omega = 2 * pi * spring_in_steps(spring, dt).frequency;
  return acceleration / (omega * omega);
}

template <Scalar Real>
RowRule<Real> joint_rule(const Stabilization& stabilization, StabilizationPass pass, Real dt) {
  return rule_on_springs(stabilization, pass, dt, stabilization.joint_soft);
}

/// Half as fast as a fall through the overlap, where velocities keep the speed: up to four overlaps d on each
/// other then lift the last body no higher than they are deep, as n sqrt(g d / 2) <= sqrt(2 g n d).
template <Scalar Real>
RowRule<Real> contact_rule(const Stabilization& stabilization, StabilizationPass pass, Real dt,
                           double gravity) {
  RowRule<Real> rule = rule_on_springs(stabilization, pass, dt, stabilization.soft);
  rule.most_speed = static_cast<Real>(most_speed(stabilization));
  const bool keep_speed = stabilization.policy == StabilizationPolicy::baumgarte;
  if (keep_speed && !std::isinf(rule.most_speed)) rule.gravity = static_cast<Real>(gravity);
  return rule;
}

template <Scalar Real>
Real bias_velocity(const RowSpec<Real>& spec, const RowRule<Real>& rule,
                   const PerBody<Vec3<Real>>& velocity) {
  const bool on_spring = is_on_spring(spec, rule);
  if (!spec.bounds.is_unilateral())
    return spec.speed - spec.error * (on_spring ? rule.spring_rate : rule.rigid_rate);
  const Real bias = pushing_bias(rule, spec.error, spec.keeps_slop ? rule.slop : Real(0), on_spring);
  return rule.only_corrects ? bias - spec_velocity(spec, velocity) : bias + spec.speed;
}

template <Scalar Real>
Real left_out_by_jacobian(const RowSpec<Real>& spec, const RowSpec<Real>& ahead, Real dt,
                          const PerBody<Vec3<Real>>& velocity) {
  return ahead.error - spec.error - dt * spec_velocity(spec, velocity);
}

template <Scalar Real>
void stabilize_row(const RowSpec<Real>& spec, const RowRule<Real>& rule, const BodyState<Real>& begin,
                   VelocityProblem<Real>& problem, std::uint64_t source, int first_row,
                   ConstraintRow<Real>& row) {
  row.a = spec.a;
  row.b = spec.b;
  row.jacobian_a = spec.jacobian_a;
  row.jacobian_b = spec.jacobian_b;
  row.bias = bias_velocity(spec, rule, problem.velocity);
  row.softness = 0;
  row.bounds = spec.bounds;
  row.key = {.source = source, .part = spec.part};
  row.first_extra = problem.extra_terms.size();
  row.extra_count = spec.extra_count;
  for (int k = 0; k < spec.extra_count; ++k) {
    problem.extra_terms.push_back(spec.extra[k]);
  }
  row.bounds.shift(first_row);
  if (spec.max_force) {
    const Real limit = *spec.max_force * problem.dt;
    row.bounds = row.bounds.is_friction() ? Bounds<Real>::rest_of_disc(limit, row.bounds.normal_row)
                                          : Bounds<Real>::at_most(limit);
  }
  if (rule.only_corrects && holds_no_position(spec)) {
    row.bounds = Bounds<Real>::at_most(0);
    return;
  }
  if (spec.softness) return put_on_spring(spec, begin, problem.dt, row);
  if (!is_on_spring(spec, rule)) return;
  row.softness =
      spring_softness(rule, row.bounds.is_equality() ? carried_inverse_mass(spec, problem.inverse_mass)
                                                     : inverse_effective_mass(problem, row));
}

template <Scalar Real>
RelaxedRow<Real> stabilize_contact(const ContactState<Real>& contact, const RowRule<Real>& rule,
                                   const VelocityProblem<Real>& problem, ConstraintRow<Real>& row) {
  const bool may_be_on_spring = rule.has_springs && !(contact.separation >= 0);
  const bool needs_speed = rule.only_corrects || contact.rebound > 0 || may_be_on_spring;
  const Real jv = needs_speed ? row_velocity(problem, row) : Real(0);
  const bool bounces = contact.rebound > 0 && contact.separation + rule.dt * jv < 0;
  const bool on_spring = may_be_on_spring && !bounces && !(-jv > rule.most_speed);
  row.bias = pushing_bias(rule, contact.separation, contact.slop_limit, on_spring);
  row.softness = 0;
  if (on_spring) row.softness = spring_softness(rule, inverse_effective_mass(problem, row));
  if (rule.only_corrects) row.bias -= jv;
  RelaxedRow<Real> relaxed = {.bias = std::min(row.bias, Real(0))};
  if (bounces && !rule.only_corrects) {
    row.bias = std::max(row.bias, contact.rebound);
    relaxed.bias = contact.rebound;
  }
  return relaxed;
}

template RowRule<float> joint_rule(const Stabilization&, StabilizationPass, float);
template RowRule<float> contact_rule(const Stabilization&, StabilizationPass, float, double);
template float bias_velocity(const RowSpec<float>&, const RowRule<float>&, const PerBody<Vec3<float>>&);
template float left_out_by_jacobian(const RowSpec<float>&, const RowSpec<float>&, float,
                                    const PerBody<Vec3<float>>&);
template void stabilize_row(const RowSpec<float>&, const RowRule<float>&, const BodyState<float>&,
                            VelocityProblem<float>&, std::uint64_t, int, ConstraintRow<float>&);
template RelaxedRow<float> stabilize_contact(const ContactState<float>&, const RowRule<float>&,
                                             const VelocityProblem<float>&, ConstraintRow<float>&);
template RowRule<double> joint_rule(const Stabilization&, StabilizationPass, double);
template RowRule<double> contact_rule(const Stabilization&, StabilizationPass, double, double);
template double bias_velocity(const RowSpec<double>&, const RowRule<double>&, const PerBody<Vec3<double>>&);
template double left_out_by_jacobian(const RowSpec<double>&, const RowSpec<double>&, double,
                                     const PerBody<Vec3<double>>&);
template void stabilize_row(const RowSpec<double>&, const RowRule<double>&, const BodyState<double>&,
                            VelocityProblem<double>&, std::uint64_t, int, ConstraintRow<double>&);
template RelaxedRow<double> stabilize_contact(const ContactState<double>&, const RowRule<double>&,
                                              const VelocityProblem<double>&, ConstraintRow<double>&);
template RowRule<long double> joint_rule(const Stabilization&, StabilizationPass, long double);
template RowRule<long double> contact_rule(const Stabilization&, StabilizationPass, long double, double);
template long double bias_velocity(const RowSpec<long double>&, const RowRule<long double>&,
                                   const PerBody<Vec3<long double>>&);
template long double left_out_by_jacobian(const RowSpec<long double>&, const RowSpec<long double>&,
                                          long double, const PerBody<Vec3<long double>>&);
template void stabilize_row(const RowSpec<long double>&, const RowRule<long double>&,
                            const BodyState<long double>&, VelocityProblem<long double>&, std::uint64_t, int,
                            ConstraintRow<long double>&);
template RelaxedRow<long double> stabilize_contact(const ContactState<long double>&,
                                                   const RowRule<long double>&,
                                                   const VelocityProblem<long double>&,
                                                   ConstraintRow<long double>&);

}  // namespace cairn
