// Floor 3. Bias, softness and bounds of the rows of joints: one line each.
#include <cairn/constraints/problem_rows.hpp>

#include <algorithm>

#include <cairn/constraints/springs.hpp>

namespace cairn {

namespace {

template <Scalar Real>
bool is_still(const PerBody<Vec3<Real>>& inverse_mass, BodyId body, const Vec3<Real>& jacobian) {
  const Vec3<Real>& m = inverse_mass[body];
  return m.x() * jacobian.x() == 0 && m.y() * jacobian.y() == 0 && m.z() * jacobian.z() == 0;
}

/// Not angles alone.
template <Scalar Real>
bool holds_points(const RigidRow<Real>& row) {
  const auto is_angle = [](const Vec3<Real>& j) { return j.x() == 0 && j.y() == 0; };
  return !is_angle(row.jacobian_a) || !is_angle(row.jacobian_b);
}

/// Whether a row is meant to give way, or holds no position: it has no error that positions could take back.
template <Scalar Real>
bool holds_no_position(const RowSpec<Real>& spec) {
  return spec.softness || spec.max_force || spec.bounds.is_friction();
}

/// Whether the error of a row goes by a spring of the policy.
template <Scalar Real>
bool is_on_spring(const RowSpec<Real>& spec, const RowRule<Real>& rule) {
  return rule.has_springs && !holds_no_position(spec) && !(spec.bounds.is_unilateral() && spec.error >= 0);
}

/// zeta (7) of a row without a spring of its own, that has this speed besides and goes at these velocities.
template <Scalar Real>
Real bias_velocity(const RowSpec<Real>& spec, Real speed, const RowRule<Real>& rule,
                   const PerBody<Vec3<Real>>& velocity) {
  const bool on_spring = is_on_spring(spec, rule);
  if (!spec.bounds.is_unilateral()) return speed - spec.error * error_rate(rule, on_spring);
  const Real bias = pushing_bias(rule, spec.error, spec.keeps_slop ? rule.slop : Real(0), on_spring);
  return rule.only_corrects ? bias - row_velocity(spec, velocity) : bias + speed;
}

/// Takes down what rows are off by.
template <Scalar Real>
class RowErrors final : public RowWriter<Real> {
 public:
  RowErrors(const PerBody<Vec3<Real>>& velocity, List<RowError<Real>>& errors)
      : velocity_(velocity), errors_(errors) {}
  void add(const RowSpec<Real>& row) override { errors_.push_back({row.part, row.error}); }
  void add(const RigidRow<Real>& row) override { errors_.push_back({row.part, row.error}); }
  Vec3<Real> velocity(BodyId body) const override { return velocity_[body]; }

 private:
  const PerBody<Vec3<Real>>& velocity_;
  List<RowError<Real>>& errors_;
};

}  // namespace

template <Scalar Real>
ProblemRows<Real>::ProblemRows(const RowWriting<Real>& writing, std::uint64_t source, const Constraint* joint,
                               Span<const RowImpulse<Real>> last)
    : writing_(writing), source_(source), joint_(joint), last_(last), first_(writing.next) {}

template <Scalar Real>
void ProblemRows<Real>::add(const RigidRow<Real>& row) {
  measure_gap(row);
  const VelocityProblem<Real>& problem = writing_.problem;
  if (is_still(problem.inverse_mass, row.a, row.jacobian_a) &&
      is_still(problem.inverse_mass, row.b, row.jacobian_b))
    return;
  const Arcs<Real>* const arcs = writing_.arcs;
  Real speed = row.speed;
  if (arcs && (arcs->moves[row.a] || arcs->moves[row.b]))
    speed -= lost_on_arc(row, row_velocity(row, writing_.begin.velocity));
  const RowRule<Real>& rule = writing_.rule;
  ConstraintRow<Real>& to = next_row(row);
  to.bias = speed - row.error * error_rate(rule, rule.has_springs);
  if (rule.has_springs)
    to.softness = spring_softness(rule, carried_inverse_mass<Real>(row, problem.inverse_mass));
  if (writing_.second_rows)
    writing_.second_rows->push_back({speed - row.error * error_rate(writing_.second_rule, false), 0});
}

template <Scalar Real>
void ProblemRows<Real>::add(const RowSpec<Real>& spec) {
  if (spec.approach > 0) return add(motor_of(spec, writing_.problem.dt));
  const bool yields = spec.softness || spec.max_force;
  if (!yields && spec.bounds.is_equality()) {
    if (spec.extra_count == 0) return add(static_cast<const RigidRow<Real>&>(spec));
    measure_gap(spec);
  }
  if (moves_nothing(spec)) return;
  VelocityProblem<Real>& problem = writing_.problem;
  Real speed = spec.speed;
  if (follows_arc(spec)) speed -= lost_on_arc(spec, row_velocity(spec, writing_.begin.velocity));
  ConstraintRow<Real>& to = next_row(spec);
  to.bias = bias_velocity(spec, speed, writing_.rule, problem.velocity);
  set_bounds(spec, to.bounds);
  to.extra_count = spec.extra_count;
  for (int k = 0; k < spec.extra_count; ++k) problem.extra_terms.push_back(spec.extra[k]);
  if (writing_.rule.only_corrects && holds_no_position(spec)) {
    to.bounds = Bounds<Real>::at_most(0);
  } else if (spec.softness) {
    put_on_spring(spec, writing_.begin, problem.dt, to);
  } else if (is_on_spring(spec, writing_.rule)) {
    to.softness = spring_softness(writing_.rule, spec.bounds.is_equality()
                                                     ? carried_inverse_mass(spec, problem.inverse_mass)
                                                     : inverse_effective_mass(problem, to));
  }
  if (!writing_.second_rows) return;
  writing_.second_rows->push_back(
      spec.softness ? SecondRow<Real>{to.bias, to.softness}
                    : SecondRow<Real>{bias_velocity(spec, speed, writing_.second_rule, problem.velocity), 0});
}

/// Over an old row where there is one, so every member is set: as of a rigid equality, but for its bias.
template <Scalar Real>
ConstraintRow<Real>& ProblemRows<Real>::next_row(const RigidRow<Real>& row) {
  VelocityProblem<Real>& problem = writing_.problem;
  if (writing_.next == problem.row_count()) problem.rows.emplace_back();
  ConstraintRow<Real>& to = problem.rows[writing_.next++];
  to.a = row.a;
  to.b = row.b;
  to.jacobian_a = row.jacobian_a;
  to.jacobian_b = row.jacobian_b;
  to.softness = 0;
  to.bounds = Bounds<Real>::equality();
  to.key = {.source = source_, .part = row.part};
  to.first_extra = problem.extra_terms.size();
  to.extra_count = 0;
  return to;
}

template <Scalar Real>
void ProblemRows<Real>::set_bounds(const RowSpec<Real>& spec, Bounds<Real>& bounds) const {
  bounds = spec.bounds;
  bounds.shift(first_);
  if (!spec.max_force) return;
  const Real limit = *spec.max_force * writing_.problem.dt;
  bounds = bounds.is_friction() ? Bounds<Real>::rest_of_disc(limit, bounds.normal_row)
                                : Bounds<Real>::at_most(limit);
}

/// Whether no impulse of a row could change a velocity, as that of a row for the angle between the ground and
/// a body that never turns: A_ii is 0.
template <Scalar Real>
bool ProblemRows<Real>::moves_nothing(const RowSpec<Real>& spec) const {
  const PerBody<Vec3<Real>>& inverse_mass = writing_.problem.inverse_mass;
  bool still =
      is_still(inverse_mass, spec.a, spec.jacobian_a) && is_still(inverse_mass, spec.b, spec.jacobian_b);
  for (int k = 0; k < spec.extra_count; ++k)
    still = still && is_still(inverse_mass, spec.extra[k].body, spec.extra[k].jacobian);
  return still;
}

template <Scalar Real>
void ProblemRows<Real>::measure_gap(const RigidRow<Real>& row) {
  if (writing_.radius == nullptr || !holds_points(row)) return;
  gap_squared_ += row.error * row.error;
  for (const BodyId body : {row.a, row.b}) {
    const Real radius = (*writing_.radius)[body];
    if (radius > 0) most_gap_ = std::min(most_gap_, radius);
  }
}

/// Whether a row holds where the substep ends: those that hold now, which of one side that only pushes is
/// known by what it gave. Where bodies are all but still, there is no arc.
template <Scalar Real>
bool ProblemRows<Real>::follows_arc(const RowSpec<Real>& spec) const {
  const Arcs<Real>* const arcs = writing_.arcs;
  if (arcs == nullptr || spec.softness || spec.max_force || spec.jumps) return false;
  if (spec.extra_count == 0 && !arcs->moves[spec.a] && !arcs->moves[spec.b]) return false;
  if (spec.bounds.is_equality() || !(spec.error > 0)) return true;
  return std::any_of(last_.begin(), last_.end(),
                     [&](const RowImpulse<Real>& row) { return row.part == spec.part && row.impulse > 0; });
}

/// [m/s or rad/s] What the Jacobian of a row, with j v, leaves out of its error in the substep, for each
/// second of it: (C(x + dt v) - C(x)) / dt - j v.
template <Scalar Real>
Real ProblemRows<Real>::lost_on_arc(const RigidRow<Real>& row, Real jv) {
  const Arcs<Real>& arcs = *writing_.arcs;
  if (!knows_errors_ahead_) {
    knows_errors_ahead_ = true;
    arcs.errors.clear();
    RowErrors<Real> errors(writing_.begin.velocity, arcs.errors);
    joint_->write_rows(arcs.ahead, errors);
  }
  const Real dt = writing_.problem.dt;
  for (const RowError<Real>& ahead : arcs.errors)
    if (ahead.part == row.part) return (ahead.error - row.error - dt * jv) / dt;
  return 0;
}

template class ProblemRows<float>;
template class ProblemRows<double>;

}  // namespace cairn
