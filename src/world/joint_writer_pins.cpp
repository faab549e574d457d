// Floor 5. Rows of pins, written in place: the numbers of RevoluteJoint and stabilize_row, to the last bit.
#include <algorithm>
#include <limits>

#include "constraints/joint_rows.hpp"
#include "world/joint_writer.hpp"

namespace cairn {

namespace {

/// All of a row but its Jacobians and what makes errors go. Every member is set: the row may be an old one.
template <Scalar Real>
void begin_pin_row(const Pin& pin, JointPart part, int extra_terms, ConstraintRow<Real>& row) {
  row.a = pin.a;
  row.b = pin.b;
  row.bounds = Bounds<Real>::equality();
  row.key = {.source = pin.source, .part = static_cast<std::uint64_t>(part)};
  row.first_extra = extra_terms;
  row.extra_count = 0;
}

}  // namespace

template <Scalar Real>
PinRules<Real> JointWriter<Real>::pin_rules(const Substep<Real>& step, const Stabilization& stabilization,
                                            StabilizationPass pass) const {
  return {joint_rule(stabilization, pass, step.dt),
          joint_rule(stabilization, StabilizationPass::relax, step.dt)};
}

/// Where the bodies of all pins are: their cosines and sines serve all pins of a body.
template <Scalar Real>
void JointWriter<Real>::locate_pins(const Substep<Real>& step) {
  pin_frames_.resize(step.state.pose.size());
  for (const BodyId body : pins_->bodies) pin_frames_[body] = step.state.pose[body];
  if (!step.plan.follows_arcs) return;
  pin_frames_ahead_.resize(step.state.pose.size());
  for (const BodyId body : pins_->bodies) pin_frames_ahead_[body] = poses_ahead_[body];
}

/// The two rows from `next` on; and what they are in the second solve, where there is one. Whether they hold
/// points that are too far apart.
template <Scalar Real>
bool JointWriter<Real>::write_pin(const Substep<Real>& step, const Pin& pin, const PinRules<Real>& rules,
                                  VelocityProblem<Real>& problem, int& next,
                                  List<RelaxedRow<Real>>* relaxed) const {
  while (problem.row_count() < next + 2) problem.rows.emplace_back();
  ConstraintRow<Real>&x = problem.rows[next], &y = problem.rows[next + 1];
  const auto arms = joint_arms(pin_frames_[pin.a], pin_frames_[pin.b], pin.local_a, pin.local_b);
  begin_pin_row(pin, JointPart::x, problem.extra_terms.size(), x);
  begin_pin_row(pin, JointPart::y, problem.extra_terms.size(), y);
  x.jacobian_a = {-1, 0, arms.r_a.y()};
  x.jacobian_b = {1, 0, -arms.r_b.y()};
  y.jacobian_a = {0, -1, -arms.r_a.x()};
  y.jacobian_b = {0, 1, arms.r_b.x()};
  Vec2<Real> speed = {0, 0};
  if (step.plan.follows_arcs && (goes_along_arc_[pin.a] || goes_along_arc_[pin.b])) {
    const auto ahead =
        joint_arms(pin_frames_ahead_[pin.a], pin_frames_ahead_[pin.b], pin.local_a, pin.local_b);
    const Vec3<Real>&v_a = step.state.velocity[pin.a], &v_b = step.state.velocity[pin.b];
    const auto lost = [&](Real error_ahead, Real error, const ConstraintRow<Real>& row) {
      const Real jv = dot(row.jacobian_a, v_a) + dot(row.jacobian_b, v_b);
      return (error_ahead - error - step.dt * jv) / step.dt;
    };
    speed = {0 - lost(ahead.d.x(), arms.d.x(), x), 0 - lost(ahead.d.y(), arms.d.y(), y)};
  }
  const RowRule<Real>& now = rules.now;
  const Real rate = now.has_springs ? now.spring_rate : now.rigid_rate;
  x.bias = speed.x() - arms.d.x() * rate;
  y.bias = speed.y() - arms.d.y() * rate;
  const Real carried = problem.inverse_mass[pin.a].x() + problem.inverse_mass[pin.b].x();
  x.softness = y.softness = now.has_springs ? spring_softness(now, carried) : Real(0);
  if (relaxed) {
    relaxed->push_back({speed.x() - arms.d.x() * rules.again.rigid_rate, 0});
    relaxed->push_back({speed.y() - arms.d.y() * rules.again.rigid_rate, 0});
  }
  const Real radius_a = step.kinds[pin.a].radius, radius_b = step.kinds[pin.b].radius;
  Real most = std::numeric_limits<Real>::infinity();
  if (radius_a > 0) most = radius_a;
  if (radius_b > 0) most = std::min(most, radius_b);
  next += 2;
  return arms.d.x() * arms.d.x() + arms.d.y() * arms.d.y() > most * most;
}

template class JointWriter<float>;
template class JointWriter<double>;
template class JointWriter<long double>;

}  // namespace cairn
