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

/// Whether the two sides of an inequality would meet within the step, and part again by the rebound.
template <Scalar Real>
bool rebounds(const RowSpec<Real>& spec, Real dt, const PerBody<Vec3<Real>>& velocity) {
  return spec.rebound > 0 && spec.error + dt * spec_velocity(spec, velocity) < 0;
}

bool policy_has_springs(const Stabilization& stabilization, StabilizationPass pass) {
  return stabilization.policy == StabilizationPolicy::soft && pass == StabilizationPass::velocity;
}

/// Whether bodies that come together at `approach` [m/s] are stopped as by a rigid row, though they overlap:
/// for as long as a step, a spring lets a share of any speed through. The limit is the speed at which overlap
/// is taken back at most.
template <Scalar Real>
bool strikes(const Stabilization& stabilization, Real approach) {
  return approach > static_cast<Real>(most_speed(stabilization));
}

/// The spring of the policy for an error that is to go.
template <Scalar Real>
std::optional<SwingSoftness> policy_spring_of(const RowSpec<Real>& spec, const Stabilization& stabilization,
                                              StabilizationPass pass, Real dt,
                                              const PerBody<Vec3<Real>>& velocity) {
  if (!policy_has_springs(stabilization, pass) || holds_no_position(spec)) return std::nullopt;
  if (spec.bounds.is_unilateral() && (spec.error >= 0 || rebounds(spec, dt, velocity))) return std::nullopt;
  const bool of_contact = spec.gravity.has_value();
  if (of_contact && strikes(stabilization, -spec_velocity(spec, velocity))) return std::nullopt;
  return spring_in_steps(of_contact ? stabilization.soft : stabilization.joint_soft, static_cast<double>(dt));
}

template <Scalar Real>
Real limited_softness(Real softness) {
  return std::min(softness, most_softness<Real>());
}

/// Whether the velocities of contacts keep the speed that takes overlap back.
bool contacts_keep_speed(const Stabilization& stabilization) {
  return stabilization.policy == StabilizationPolicy::baumgarte;
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

/// [m/s] How fast a contact takes this much overlap back at most. Half as fast as a fall through it, where
/// velocities keep the speed: up to four overlaps d on each other then lift the last body no higher than they
/// are deep, as n sqrt(g d / 2) <= sqrt(2 g n d). Without gravity nothing says how fast that is.
template <Scalar Real>
Real speed_limit(const Stabilization& stabilization, Real gravity, Real overlap) {
  if (std::isinf(most_speed(stabilization))) return std::numeric_limits<Real>::infinity();
  const Real limit = static_cast<Real>(most_speed(stabilization));
  const bool keeps_speed = contacts_keep_speed(stabilization) && gravity > 0;
  return keeps_speed ? std::min(limit, std::sqrt(gravity * overlap / 2)) : limit;
}

/// [m] What an inequality may stay violated by.
template <Scalar Real>
Real slop_of(const Stabilization& stabilization, Real slop_limit) {
  return std::min(static_cast<Real>(stabilization.slop.value_or(usual_slop)), slop_limit);
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
Real bias_velocity(const RowSpec<Real>& spec, const Stabilization& stabilization, StabilizationPass pass,
                   Real dt, const PerBody<Vec3<Real>>& velocity) {
  const auto spring = policy_spring_of(spec, stabilization, pass, dt, velocity);
  const Real rate = spring ? return_rate(*spring, dt) : recovery_rate(stabilization, pass, dt);
  if (!spec.bounds.is_unilateral()) return spec.speed - spec.error * rate;

  const bool has_slop = spec.keeps_slop && !spring;
  const Real slop = has_slop ? slop_of(stabilization, spec.slop_limit) : Real(0);
  Real bias = -spec.error / dt;
  if (spec.error < 0) {
    const Real overlap = std::max(Real(0), -spec.error - slop);
    bias = rate * overlap;
    if (spec.gravity) bias = std::min(bias, speed_limit(stabilization, *spec.gravity, overlap));
  }
  if (pass == StabilizationPass::position) return bias - spec_velocity(spec, velocity);
  bias += spec.speed;
  return rebounds(spec, dt, velocity) ? std::max(bias, spec.rebound) : bias;
}

template <Scalar Real>
Real left_out_by_jacobian(const RowSpec<Real>& spec, const RowSpec<Real>& ahead, Real dt,
                          const PerBody<Vec3<Real>>& velocity) {
  return ahead.error - spec.error - dt * spec_velocity(spec, velocity);
}

template <Scalar Real>
void stabilize_row(const RowSpec<Real>& spec, const Stabilization& stabilization, StabilizationPass pass,
                   const BodyState<Real>& begin, VelocityProblem<Real>& problem, std::uint64_t source,
                   int first_row, ConstraintRow<Real>& row) {
  row.a = spec.a;
  row.b = spec.b;
  row.jacobian_a = spec.jacobian_a;
  row.jacobian_b = spec.jacobian_b;
  row.bias = bias_velocity(spec, stabilization, pass, problem.dt, problem.velocity);
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
  if (pass == StabilizationPass::position && holds_no_position(spec)) {
    row.bounds = Bounds<Real>::at_most(0);
    return;
  }
  if (spec.softness) return put_on_spring(spec, begin, problem.dt, row);
  if (const auto spring = policy_spring_of(spec, stabilization, pass, problem.dt, problem.velocity)) {
    const Real carried = row.bounds.is_equality() ? carried_inverse_mass(spec, problem.inverse_mass)
                                                  : inverse_effective_mass(problem, row);
    row.softness = limited_softness(carried / softness_divisor(*spring, problem.dt));
  }
}

template <Scalar Real>
JointRule<Real> joint_rule(const Stabilization& stabilization, StabilizationPass pass, Real dt) {
  if (!policy_has_springs(stabilization, pass)) return {.rate = recovery_rate(stabilization, pass, dt)};
  const SwingSoftness spring = spring_in_steps(stabilization.joint_soft, static_cast<double>(dt));
  return {.rate = return_rate<Real>(spring, dt),
          .has_spring = true,
          .spring_divisor = softness_divisor(spring, dt)};
}

template <Scalar Real>
ContactStabilization<Real>::ContactStabilization(const Stabilization& stabilization, StabilizationPass pass,
                                                 Real dt)
    : stabilization_(stabilization),
      pass_(pass),
      dt_(dt),
      on_springs_(policy_has_springs(stabilization, pass)),
      rigid_rate_(recovery_rate(stabilization, pass, dt)),
      spring_rate_(on_springs_
                       ? return_rate<Real>(spring_in_steps(stabilization.soft, static_cast<double>(dt)), dt)
                       : Real(0)) {}

template <Scalar Real>
RelaxedRow<Real> ContactStabilization<Real>::stabilize(const ContactState<Real>& contact,
                                                       const VelocityProblem<Real>& problem,
                                                       ConstraintRow<Real>& row) const {
  const bool corrects = pass_ == StabilizationPass::position;
  const bool may_be_on_spring = on_springs_ && !(contact.separation >= 0);
  const bool needs_speed = corrects || contact.rebound > 0 || may_be_on_spring;
  const Real jv = needs_speed ? row_velocity(problem, row) : Real(0);
  const bool bounces = contact.rebound > 0 && contact.separation + dt_ * jv < 0;
  const bool on_spring = may_be_on_spring && !bounces && !strikes(stabilization_, -jv);
  row.bias = -contact.separation / dt_;
  if (contact.separation < 0) {
    const Real slop = on_spring ? Real(0) : slop_of(stabilization_, contact.slop_limit);
    const Real overlap = std::max(Real(0), -contact.separation - slop);
    const Real rate = on_spring ? spring_rate_ : rigid_rate_;
    row.bias = std::min(rate * overlap, speed_limit(stabilization_, contact.gravity, overlap));
  }
  if (corrects) row.bias -= jv;
  RelaxedRow<Real> relaxed = {.bias = std::min(row.bias, Real(0))};
  if (!corrects && bounces) {
    row.bias = std::max(row.bias, contact.rebound);
    relaxed.bias = contact.rebound;
  }
  row.softness = 0;
  if (!on_spring) return relaxed;
  const SwingSoftness spring = spring_in_steps(stabilization_.soft, static_cast<double>(dt_));
  row.softness = limited_softness(inverse_effective_mass(problem, row) / softness_divisor(spring, dt_));
  return relaxed;
}

template <Scalar Real>
ContactRule<Real> ContactStabilization<Real>::rule(Real gravity) const {
  const bool keeps_speed = contacts_keep_speed(stabilization_) && !std::isinf(most_speed(stabilization_));
  const SwingSoftness spring = spring_in_steps(stabilization_.soft, static_cast<double>(dt_));
  return {.dt = dt_,
          .slop = on_springs_ ? Real(0) : static_cast<Real>(stabilization_.slop.value_or(usual_slop)),
          .rigid_rate = rigid_rate_,
          .has_springs = on_springs_,
          .spring_rate = spring_rate_,
          .spring_divisor = softness_divisor(spring, dt_),
          .most_softness = most_softness<Real>(),
          .most_speed = static_cast<Real>(most_speed(stabilization_)),
          .gravity = keeps_speed ? gravity : Real(0)};
}

template JointRule<float> joint_rule(const Stabilization&, StabilizationPass, float);
template JointRule<double> joint_rule(const Stabilization&, StabilizationPass, double);
template JointRule<long double> joint_rule(const Stabilization&, StabilizationPass, long double);
template class ContactStabilization<float>;
template class ContactStabilization<double>;
template class ContactStabilization<long double>;
template float bias_velocity(const RowSpec<float>&, const Stabilization&, StabilizationPass, float,
                             const PerBody<Vec3<float>>&);
template float left_out_by_jacobian(const RowSpec<float>&, const RowSpec<float>&, float,
                                    const PerBody<Vec3<float>>&);
template void stabilize_row(const RowSpec<float>&, const Stabilization&, StabilizationPass,
                            const BodyState<float>&, VelocityProblem<float>&, std::uint64_t, int,
                            ConstraintRow<float>&);
template double bias_velocity(const RowSpec<double>&, const Stabilization&, StabilizationPass, double,
                              const PerBody<Vec3<double>>&);
template double left_out_by_jacobian(const RowSpec<double>&, const RowSpec<double>&, double,
                                     const PerBody<Vec3<double>>&);
template void stabilize_row(const RowSpec<double>&, const Stabilization&, StabilizationPass,
                            const BodyState<double>&, VelocityProblem<double>&, std::uint64_t, int,
                            ConstraintRow<double>&);
template long double bias_velocity(const RowSpec<long double>&, const Stabilization&, StabilizationPass,
                                   long double, const PerBody<Vec3<long double>>&);
template long double left_out_by_jacobian(const RowSpec<long double>&, const RowSpec<long double>&,
                                          long double, const PerBody<Vec3<long double>>&);
template void stabilize_row(const RowSpec<long double>&, const Stabilization&, StabilizationPass,
                            const BodyState<long double>&, VelocityProblem<long double>&, std::uint64_t, int,
                            ConstraintRow<long double>&);

}  // namespace cairn
