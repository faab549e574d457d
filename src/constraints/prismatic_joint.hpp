// Floor 3. Prismatic joint: a slide along a line; and slots and wheels, whose bodies turn on it.
#pragma once

#include <cairn/constraints/joint_coordinate.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Lets b slide along a line that is fixed in a. With the unit vector u of the line and n, which is u turned
/// by 90 degrees (both turn with a), arms r_a, r_b from the centres of mass to the anchors, d = p_b - p_a
/// from anchor to anchor, and the angle q_0 that b had against a where the joint was made:
///   perpendicular  C = n . d,           j = (-n, -((r_a + d) x n), n, r_b x n)
///   angle          C = q_b - q_a - q_0, j = (0, 0, -1, 0, 0, 1)
/// The arm on a reaches to the anchor of b: that is where the force acts, as n turns with a. What a kind
/// keeps and drives:
///   prismatic  both rows: b does not turn against a; the motor drives the slide
///   slot       no angle: a point of b runs in a slot of a; the motor drives the slide
///   wheel      no angle: b is a wheel on a sprung axle; the motor drives the angle
/// Limits, spring and ratchet are those of a JointCoordinate, the slide s = u . d, with
/// j_s = (-u, -((r_a + d) x u), u, r_b x u). A limit has a row while it is nearer than limit_margin, the
/// others where there are any. Its geometric stiffness is that of a pin with these arms. As b slides, the
/// force also moves along a: that couples sliding with turning, has no place on a diagonal, and is left out.
/// Source: the derivative of C, with dn/dt = w_a x n; E. Catto's b2WheelJoint for what a wheel is.
class PrismaticJoint final : public ConstraintOf<PrismaticJoint> {
 public:
  /// What it keeps and drives: see the class.
  enum class Kind { prismatic, slot, wheel };
  /// Drives the slide; of a wheel the angle.
  struct Motor {
    double speed = 0;                   // [m/s] of b along the axis, seen from a; of a wheel [rad/s]
    double max_force = 0;               // [N]; of a wheel [N m]
    std::optional<double> target = {};  // [m or rad] a servo: where it goes, at `speed` at most, and stays
    double rate = 10;                   // [1/s] of a servo: its speed for each m or rad that is missing
  };
  /// What the joint is made from.
  struct Spec {
    BodyId a = {};                           // carries the line
    BodyId b = {};                           // slides along it
    Vec2<double> anchor = {0, 0};            // [m], world, where the bodies are placed: there s is 0
    Vec2<double> axis = {1, 0};              // world, of any length
    Kind kind = Kind::prismatic;             // prismatic, slot or wheel
    std::optional<double> lower = {};        // [m]
    std::optional<double> upper = {};        // [m]
    double limit_margin = 0.5;               // [m]; a slider that moves further in a step runs past its limit
    std::optional<Motor> motor = {};         // none: slides, or turns, freely
    std::optional<JointSpring> spring = {};  // along the slide; a wheel needs one
    std::optional<double> ratchet = {};      // [m] of a tooth: never slides back; negative: never forward
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice, numbers that are not finite, an axis of 0, upper <
  /// lower, a max_force that is not > 0, a servo whose speed or rate is not, a spring or ratchet out of
  /// range, or a wheel without a spring.
  PrismaticJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  std::string name() const override;
  JointTraits traits() const override;
  List<Attachment> attachments() const override { return ends_.attachments(); }
  std::optional<JointMotor> motor() const override { return driven().motor(); }
  std::shared_ptr<const Constraint> with_motor(const std::optional<JointMotor>& motor) const override;
  List<Attachment> groove() const override;

  /// Where it is fastened.
  const JointEnds& ends() const { return ends_; }
  /// Whether it is a slide, a slot or a wheel.
  Kind kind() const { return kind_; }
  /// What is asked of its slide [m].
  const JointCoordinate& slide() const { return slide_; }
  /// Its axis, a unit vector in the frame of a.
  const Vec2<double>& axis() const { return local_axis_; }

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

  /// Adds its geometric stiffness under these forces, as add_stiffness().
  template <Scalar Real>
  void stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
               PerBody<Vec3<Real>>& stiffness) const;

 private:
  const JointCoordinate& driven() const { return kind_ == Kind::wheel ? turn_ : slide_; }

  JointEnds ends_;
  Kind kind_;
  Vec2<double> local_axis_;  // u in the frame of a
  JointCoordinate slide_;    // [m]
  JointCoordinate turn_;     // [rad] of a wheel
};

extern template class ConstraintOf<PrismaticJoint>;

}  // namespace cairn
