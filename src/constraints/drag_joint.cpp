// Floor 3. The drag joint's two rows.
#include <cairn/constraints/drag_joint.hpp>

#include <cairn/math/check.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

DragJoint::DragJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses)
    : body_(spec.body), target_(spec.target), softness_(spec.softness), max_force_(spec.max_force) {
  require(body_.index > 0 && body_.index < poses.size(), "DragJoint", "body",
          "the id of a body of this scene, and not the ground", body_.index);
  require_finite(spec.anchor, "DragJoint", "anchor", "m");
  require_finite(target_, "DragJoint", "target", "m");
  require_softness(softness_, "DragJoint");
  require(max_force_ > 0 && std::isfinite(max_force_), "DragJoint", "max_force", "a finite number > 0 N",
          max_force_);
  local_ = poses[body_].local(spec.anchor);
}

DragJoint DragJoint::moved_to(const Vec2<double>& target) const {
  require_finite(target, "DragJoint::moved_to", "target", "m");
  DragJoint moved = *this;
  moved.target_ = target;
  return moved;
}

template <Scalar Real>
JointArms<Real> DragJoint::arms(const Placements<Real>& at) const {
  return joint_arms<Real>(at[ground], at[body_], target_, local_);
}

template <Scalar Real>
void DragJoint::rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
  // A pin between the target, a point of the ground, and the anchor that gives way.
  for (const RigidRow<Real>& row : pin_rows(ground, body_, arms(at))) {
    RowSpec<Real> soft = row;
    soft.softness = softness_;
    soft.max_force = static_cast<Real>(max_force_);
    rows.add(soft);
  }
}

template <Scalar Real>
void DragJoint::stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
                        PerBody<Vec3<Real>>& stiffness) const {
  add_pin_stiffness(ground, body_, arms(at), pin_force(forces), stiffness);
}

template class ConstraintOf<DragJoint>;

}  // namespace cairn
