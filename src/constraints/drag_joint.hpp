// Floor 3. Drag joint: a soft pull on one point of a body, as of a hand or a mouse.
#pragma once

#include <cairn/constraints/joint_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Pulls an anchor p of a body to a fixed point of the world, the target, with a spring that is never
/// stronger than max_force. With the arm r from the centre of mass to the anchor:
///   C = p - target, two soft rows: j = (1, 0, -r.y) for x, (0, 1, r.x) for y, |impulse| <= max_force dt
/// Each axis has that limit for itself: along a diagonal the pull may be sqrt(2) times as strong. A disc as
/// in FrictionJoint would need axes that turn with the pull. 20 times the weight of a box pull it through no
/// wall that it touches; 100 times may. The damper brakes against the world, not against the target: behind a
/// target that goes evenly at u, the anchor stays 2 zeta u / w. The joint does not change: moved_to() is the
/// same grip with another target. Its geometric stiffness is that of a pin (add_pin_stiffness). Source: the
/// derivative of C; softness.hpp for springs; E. Catto's b2MouseJoint in Box2D, which has one stiffness for
/// both axes.
class DragJoint final : public ConstraintOf<DragJoint> {
 public:
  /// What the joint is made from.
  struct Spec {
    BodyId body = {};              // that is pulled
    Vec2<double> anchor = {0, 0};  // [m], world, where the body is placed
    Vec2<double> target = {0, 0};  // [m], world
    Softness softness = SwingSoftness{.frequency = 5, .damping_ratio = 0.7};  // of the spring that pulls
    double max_force = 1000;                                                  // [N]
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for an unknown body or the ground, numbers that are not finite, a softness
  /// out of range, or a max_force that is not > 0.
  DragJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  /// The same grip, pulled to another point of the world [m]. @throws std::invalid_argument unless it is
  /// finite.
  DragJoint moved_to(const Vec2<double>& target) const;

  /// The one that is pulled.
  BodyId body() const { return body_; }
  /// Of the spring that pulls.
  const Softness& softness() const { return softness_; }
  /// [N]
  double max_force() const { return max_force_; }

  std::string name() const override { return "drag"; }
  JointTraits traits() const override { return {.box2d_rows = 2}; }
  List<Attachment> attachments() const override { return {{ground, target_}, {body_, local_}}; }
  bool bodies_collide() const override { return true; }

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

  /// Adds its geometric stiffness under these forces, as add_stiffness().
  template <Scalar Real>
  void stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
               PerBody<Vec3<Real>>& stiffness) const;

 private:
  template <Scalar Real>
  JointArms<Real> arms(const Placements<Real>& at) const;

  BodyId body_;
  Vec2<double> local_;   // [m], in the body's frame
  Vec2<double> target_;  // [m], world; the ground's frame is the world's
  Softness softness_;
  double max_force_;  // [N]
};

extern template class ConstraintOf<DragJoint>;

}  // namespace cairn
