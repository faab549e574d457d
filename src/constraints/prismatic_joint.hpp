// Floor 3. Prismatic joint: a slide along a line.
#pragma once

#include <cairn/constraints/joint_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Lets b slide along a line that is fixed in a, and not turn against a. With the unit vector u of the line
/// and n, which is u turned by 90 degrees (both turn with a), arms r_a, r_b from the centres of mass to the
/// anchors, d = p_b - p_a from anchor to anchor, and the angle q_0 that b had against a where the joint was
/// made:
///   perpendicular  C = n . d,           j = (-n, -((r_a + d) x n), n, r_b x n)
///   angle          C = q_b - q_a - q_0, j = (0, 0, -1, 0, 0, 1)
/// The arm on a reaches to the anchor of b: that is where the force acts, as n turns with a. Limits and motor
/// are on the slide's coordinate s = u . d, with j_s = (-u, -((r_a + d) x u), u, r_b x u):
///   lower limit    C = s - lower >= 0,  j = j_s,   impulse >= 0
///   upper limit    C = upper - s >= 0,  j = -j_s,  impulse >= 0
///   motor          no C,                j = j_s,   j v = speed, |impulse| <= max_force dt
/// A limit has a row while it is nearer than limit_margin, and a motor when there is one. Its geometric
/// stiffness is that of a pin with these arms. As b slides, the force also moves along a: that couples
/// sliding with turning, has no place on a diagonal, and is left out. Source: the derivative of C, with dn/dt
/// = w_a x n; the bounds as in E. Catto, Modeling and Solving Constraints (2009).
class PrismaticJoint final : public ConstraintOf<PrismaticJoint> {
 public:
  /// Drives the slide.
  struct Motor {
    double speed = 0;      // [m/s] of b along the axis, seen from a
    double max_force = 0;  // [N]
  };
  /// What the joint is made from.
  struct Spec {
    BodyId a = {};                     // carries the line
    BodyId b = {};                     // slides along it
    Vec2<double> anchor = {0, 0};      // [m], world, where the bodies are placed: there s is 0
    Vec2<double> axis = {1, 0};        // world, of any length
    std::optional<double> lower = {};  // [m]
    std::optional<double> upper = {};  // [m]
    double limit_margin = 0.5;         // [m]; a slider that moves further in one step runs past its limit
    std::optional<Motor> motor = {};   // none: slides freely
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice, numbers that are not finite, an axis of 0, upper <
  /// lower, or a max_force that is not > 0.
  PrismaticJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  std::string name() const override { return "prismatic"; }
  List<Attachment> attachments() const override { return ends_.attachments(); }
  std::optional<JointMotor> motor() const override;
  std::shared_ptr<const Constraint> with_motor(const std::optional<JointMotor>& motor) const override;

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

  /// Adds its geometric stiffness under these forces, as add_stiffness().
  template <Scalar Real>
  void stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
               PerBody<Vec3<Real>>& stiffness) const;

 private:
  JointEnds ends_;
  Vec2<double> local_axis_;  // u in the frame of a
  JointLimits limits_;       // [m]
  std::optional<Motor> motor_;
};

extern template class ConstraintOf<PrismaticJoint>;

}  // namespace cairn
