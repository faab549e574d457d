// Floor 3. Stabilization policies: one line each.
#include <cairn/constraints/stabilization.hpp>

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

bool policy_has_springs(const Stabilization& stabilization, StabilizationPass pass) {
  return stabilization.policy == StabilizationPolicy::soft && pass == StabilizationPass::velocity;
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

template RowRule<float> joint_rule(const Stabilization&, StabilizationPass, float);
template RowRule<float> contact_rule(const Stabilization&, StabilizationPass, float, double);
template RowRule<double> joint_rule(const Stabilization&, StabilizationPass, double);
template RowRule<double> contact_rule(const Stabilization&, StabilizationPass, double, double);

}  // namespace cairn
