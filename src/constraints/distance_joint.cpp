// Floor 3. The distance joint's one row.
#include <cairn/constraints/distance_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

constexpr std::uint64_t least_part = 1;  // the name of its row; the other one is 0

}  // namespace

DistanceJoint::DistanceJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : kind_(spec.kind), softness_(spec.softness), least_(spec.least), slack_margin_(spec.slack_margin) {
  require(spec.a != spec.b, "DistanceJoint", "b", "another body than a", spec.b.index);
  require_finite(spec.anchor_a, "DistanceJoint", "anchor_a", "m");
  require_finite(spec.anchor_b, "DistanceJoint", "anchor_b", "m");
  ends_ = {spec.a, spec.b, spec.anchor_a, spec.anchor_b, poses};
  require_finite(spec.length, "DistanceJoint", "length", "m");
  length_ = spec.length < 0 ? (spec.anchor_b - spec.anchor_a).norm() : spec.length;
  require(length_ > 0, "DistanceJoint", "length", "> 0 m", length_);
  require(slack_margin_ >= 0 && std::isfinite(slack_margin_), "DistanceJoint", "slack_margin",
          "a finite number >= 0 m", slack_margin_);
  require(least_ >= 0 && least_ < length_, "DistanceJoint", "least",
          ">= 0 m and < the length, " + shortest(length_) + " m", least_);
  if (kind_ != Kind::rope) require(least_ == 0, "DistanceJoint", "least", "left out but for a rope", least_);
  if (kind_ == Kind::rod) require(!softness_, "DistanceJoint", "softness", "left out for a rod", "one");
  if (kind_ == Kind::spring)
    require(softness_.has_value(), "DistanceJoint", "softness", "given for a spring", "none");
  if (softness_) require_softness(*softness_, "DistanceJoint");
}

std::string DistanceJoint::name() const {
  if (kind_ == Kind::rope) return "rope";
  return kind_ == Kind::spring ? "spring" : "rod";
}

template <Scalar Real>
void DistanceJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  const JointArms<Real> arms = ends_.arms(at);
  const Real distance = arms.d.norm();
  if (!(distance > 0)) return;

  const Vec2<Real> u = arms.d / distance;
  RowSpec<Real> row;
  row.a = ends_.a;
  row.b = ends_.b;
  row.error = distance - static_cast<Real>(length_);
  row.jacobian_a = {-u.x(), -u.y(), -cross(arms.r_a, u)};
  row.jacobian_b = {u.x(), u.y(), cross(arms.r_b, u)};
  row.softness = softness_;
  if (kind_ != Kind::rope) return rows.add(row);
  const Real room = distance - static_cast<Real>(least_), margin = static_cast<Real>(slack_margin_);
  row.bounds = Bounds<Real>::unilateral();
  row.keeps_slop = false;
  if (least_ > 0 && room <= margin) {
    RowSpec<Real> push = row;
    push.error = room;
    push.softness.reset();  // only its pull is elastic
    push.part = least_part;
    rows.add(push);
  }
  if (-row.error > margin) return;
  row.error = -row.error;
  row.jacobian_a = -row.jacobian_a;
  row.jacobian_b = -row.jacobian_b;
  rows.add(row);
}

template <Scalar Real>
void DistanceJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                            PerBody<Vec3<Real>>& stiffness) const {
  const JointArms<Real> arms = ends_.arms(at);
  const Real distance = arms.d.norm();
  if (!(distance > 0)) return;
  const Vec2<Real> u = arms.d / distance;
  const Real tension = kind_ == Kind::rope ? forces.of(0) - forces.of(least_part) : -forces.of(0);
  add_line_stiffness<Real>(ends_.a, arms.r_a, u, distance, tension, stiffness);
  add_line_stiffness<Real>(ends_.b, arms.r_b, -u, distance, tension, stiffness);
}

template class ConstraintOf<DistanceJoint>;

}  // namespace cairn
