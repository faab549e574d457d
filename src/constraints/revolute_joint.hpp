// Floor 3. Revolute joint: a pin through two bodies.
#pragma once

#include <cairn/constraints/joint_coordinate.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Keeps two anchors together: two rows, one for each axis (three dimensions would need three, paper 4.3).
/// With positions x and arms r_a, r_b from the centres of mass to the anchors p_a, p_b:
///   C = p_b - p_a = x_b + r_b - x_a - r_a
///   j = (-1, 0, r_a.y, 1, 0, -r_b.y) for x,   (0, -1, -r_a.x, 0, 1, r_b.x) for y
/// Limits, motor or servo, spring and ratchet are those of a JointCoordinate, the angle q = q_b - q_a - q_0,
/// where q_0 is how b stood against a when the joint was made, and j_q = (0, 0, -1, 0, 0, 1). The angle is
/// continuous: two turns are 4 pi. A limit has a row while it is nearer than limit_margin, the others where
/// there are any. Its geometric stiffness is that of a pin (add_pin_stiffness). Source: the derivative of C.
class RevoluteJoint final : public ConstraintOf<RevoluteJoint> {
 public:
  /// Drives the angle.
  struct Motor {
    double speed = 0;                   // [rad/s] of b, seen from a; positive: counterclockwise
    double max_torque = 0;              // [N m]
    std::optional<double> target = {};  // [rad] a servo: where it goes, at `speed` at most, and stays
    double rate = 10;                   // [1/s] of a servo: its speed for each rad that is missing
  };
  /// What the joint is made from.
  struct Spec {
    BodyId a = {};                     // the first body
    BodyId b = {};                     // the second body
    Vec2<double> anchor = {0, 0};      // [m], world, where the bodies are placed
    std::optional<double> lower = {};  // [rad] from where b stands against a now
    std::optional<double> upper = {};  // [rad]
    double limit_margin = 0.5;         // [rad]; a body that turns further in one step runs past its limit
    std::optional<Motor> motor = {};   // none: turns freely
    std::optional<JointSpring> spring = {};  // a torsion spring, [N m/rad]
    std::optional<double> ratchet = {};      // [rad] of a tooth: never turns back; negative: clockwise
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice, numbers that are not finite, upper < lower, a
  /// max_torque that is not > 0, a servo whose speed or rate is not, or a spring or ratchet out of range.
  RevoluteJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  std::string name() const override { return "revolute"; }
  JointTraits traits() const override { return turn_.marked({.turns = true, .box2d_rows = 2}); }
  List<Attachment> attachments() const override { return ends_.attachments(); }
  std::optional<JointMotor> motor() const override { return turn_.motor(); }
  std::shared_ptr<const Constraint> with_motor(const std::optional<JointMotor>& motor) const override;

  /// Where it is fastened.
  const JointEnds& ends() const { return ends_; }
  /// What is asked of its angle.
  const JointCoordinate& turn() const { return turn_; }

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

  /// Adds its geometric stiffness under these forces, as add_stiffness().
  template <Scalar Real>
  void stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
               PerBody<Vec3<Real>>& stiffness) const;

 private:
  JointEnds ends_;
  JointCoordinate turn_;  // [rad]
};

extern template class ConstraintOf<RevoluteJoint>;

}  // namespace cairn
