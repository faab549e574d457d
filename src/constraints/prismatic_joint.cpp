// Floor 3. The rows of slides, slots and wheels.
#include <cairn/constraints/prismatic_joint.hpp>

#include <cmath>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// C = direction . d, for a direction that turns with a.
template <Scalar Real>
RigidRow<Real> slide_row(BodyId a, BodyId b, const JointArms<Real>& arms, const Vec2<Real>& direction,
                         JointPart part) {
  const Vec2<Real> arm_a = arms.r_a + arms.d;
  return {.a = a,
          .b = b,
          .error = direction.dot(arms.d),
          .jacobian_a = {-direction.x(), -direction.y(), -cross(arm_a, direction)},
          .jacobian_b = {direction.x(), direction.y(), cross(arms.r_b, direction)},
          .part = static_cast<std::uint64_t>(part)};
}

}  // namespace

PrismaticJoint::PrismaticJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses) : kind_(spec.kind) {
  const char* const who = "PrismaticJoint";
  require(spec.a != spec.b, who, "b", "another body than a", spec.b.index);
  require_finite(spec.anchor, who, "anchor", "m");
  require_finite(spec.axis, who, "axis", "m");
  const double length = spec.axis.stableNorm();
  require(length > 0 && std::isfinite(length), who, "axis", "of a finite length > 0 m", length);
  std::optional<JointMotor> motor;
  if (spec.motor) motor = {spec.motor->speed, spec.motor->max_force, spec.motor->target, spec.motor->rate};
  const bool is_wheel = kind_ == Kind::wheel;
  if (is_wheel) require(spec.spring.has_value(), who, "spring", "given for a wheel", "none");
  const JointLimits limits{.lower = spec.lower, .upper = spec.upper, .margin = spec.limit_margin};
  slide_ = JointCoordinate(limits, is_wheel ? std::nullopt : motor, spec.spring, spec.ratchet, who, "m");
  turn_ = JointCoordinate({}, is_wheel ? motor : std::nullopt, {}, {}, who, "rad");
  ends_ = {spec.a, spec.b, spec.anchor, spec.anchor, poses};
  local_axis_ = Rotation<double>(poses[spec.a].angle).transposed_times(spec.axis / length);
}

std::string PrismaticJoint::name() const {
  if (kind_ == Kind::slot) return "slot";
  return kind_ == Kind::wheel ? "wheel" : "prismatic";
}

JointTraits PrismaticJoint::traits() const {
  return turn_.marked(slide_.marked({.turns = kind_ == Kind::wheel, .slides = true, .box2d_rows = 2}));
}

std::shared_ptr<const Constraint> PrismaticJoint::with_motor(const std::optional<JointMotor>& motor) const {
  auto other = std::make_shared<PrismaticJoint>(*this);
  (kind_ == Kind::wheel ? other->turn_ : other->slide_).change(motor);
  return other;
}

List<Attachment> PrismaticJoint::groove() const {
  const JointLimits& limits = slide_.limits();
  if (!limits.lower || !limits.upper) return {};
  return {{ends_.a, ends_.local_a + *limits.lower * local_axis_},
          {ends_.a, ends_.local_a + *limits.upper * local_axis_}};
}

template <Scalar Real>
void PrismaticJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  const JointArms<Real> arms = ends_.arms(at);
  const Vec2<Real> u = at[ends_.a].rotation * local_axis_.template cast<Real>();

  const RigidRow<Real> angle = angle_row(ends_.a, ends_.b, ends_.angle(at));
  const FixedList<RigidRow<Real>, 2> both = {
      slide_row<Real>(ends_.a, ends_.b, arms, perpendicular(u), JointPart::y), angle};
  const Span<const RigidRow<Real>> held(both.data(), kind_ == Kind::prismatic ? 2 : 1);

  // The last rows of a sweep are satisfied best: the slide itself comes after what is asked of it.
  if (!turn_.is_free()) turn_.add_rows<Real>(angle, held, rows);
  if (!slide_.is_free())
    slide_.add_rows<Real>(slide_row(ends_.a, ends_.b, arms, u, JointPart::x), held, rows);
  for (const RigidRow<Real>& row : held) rows.add(row);
}

template <Scalar Real>
void PrismaticJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                             PerBody<Vec3<Real>>& stiffness) const {
  JointArms<Real> arms = ends_.arms(at);
  arms.r_a += arms.d;
  const Vec2<Real> u = at[ends_.a].rotation * local_axis_.template cast<Real>();
  const Real across = forces.of(static_cast<std::uint64_t>(JointPart::y));
  const Vec2<Real> force = slide_.force(forces) * u + across * perpendicular(u);
  add_pin_stiffness(ends_.a, ends_.b, arms, force, stiffness);
}

template class ConstraintOf<PrismaticJoint>;

}  // namespace cairn
