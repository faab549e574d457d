// Floor 3. Gear joint: two wheels that roll on each other, or a wheel on a rack.
#pragma once

#include <cairn/constraints/constraint.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Keeps what two wheels, or a wheel and a rack, roll off on each other equal. With the angles q_a, q_b and
/// q_c that the wheels and their carrier have turned since the joint was made, and radii r_a, r_b:
///   external  C = r_a (q_a - q_c) + r_b (q_b - q_c),  teeth outside on both: they turn against each other
///   internal  C = r_a (q_a - q_c) - r_b (q_b - q_c),  one wheel inside the other: they turn the same way
///   j = (0, 0, r_a), (0, 0, +-r_b) and (0, 0, -r_a -+ r_b) for the carrier; C in m of rolled length
/// A rack b slides along a line of the carrier, with the unit vector u, while the wheel a turns. With
/// d = x_b - x_c, which was d_0 when the joint was made, and u turning with c:
///   rack      C = r_a (q_a - q_c) - (u . d - u_0 . d_0),  u: the way that b goes as a turns counterclockwise
///   j = (0, 0, r_a), (-u, 0) and (u, d x u - r_a) for the carrier
/// Only the ratio of the radii matters to the motion. The carrier is the body on which both axles sit: the
/// ground, unless the gear is a planetary one. The impulse [N s] is the force between the teeth times dt; it
/// acts on angles, and of a rack along its line at the middle, so wheels need pins and racks slides of their
/// own. The geometric stiffness of a rack is that of a pin at its middle, on the carrier. Source: the
/// derivative of C.
class GearJoint final : public ConstraintOf<GearJoint> {
 public:
  /// Whether both wheels have their teeth outside, one runs inside the other, or b is a rack.
  enum class Mesh { external, internal, rack };
  /// What the joint is made from.
  struct Spec {
    BodyId a = {};               // one wheel
    BodyId b = {};               // the other one
    BodyId c = ground;           // the carrier of both axles
    double radius_a = 1;         // [m] of the pitch circle
    double radius_b = 1;         // [m] of the other one; a rack has none
    Mesh mesh = Mesh::external;  // which way they turn
    Vec2<double> axis = {1, 0};  // world, of any length: the way that a rack goes as a turns counterclockwise
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice, radii that are not > 0, or a rack with an axis of 0.
  GearJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  std::string name() const override { return "gear"; }
  JointTraits traits() const override { return {.holds_points = is_rack_, .is_shown = false}; }
  /// The middles of the wheels.
  List<Attachment> attachments() const override { return {{.body = a_}, {.body = b_}}; }

  /// The wheel.
  BodyId wheel() const { return a_; }
  /// The other wheel, or the rack.
  BodyId other() const { return b_; }
  /// What carries both.
  BodyId carrier() const { return c_; }
  /// How far the other one turns or slides back as the wheel turns on [1, or m of a rack].
  double ratio() const { return is_rack_ ? -lever_a_ : lever_a_ / lever_b_; }
  /// Whether that is a rack.
  bool is_rack() const { return is_rack_; }
  /// Of a rack: a unit vector in the frame of the carrier.
  const Vec2<double>& axis() const { return local_axis_; }

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

  /// Adds the geometric stiffness of a rack under these forces, as add_stiffness().
  template <Scalar Real>
  void stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
               PerBody<Vec3<Real>>& stiffness) const;

 private:
  template <Scalar Real>
  Real rolled_length(const Placement<Real>& a, const Placement<Real>& b, const Placement<Real>& c) const;

  BodyId a_;
  BodyId b_;
  BodyId c_;
  double lever_a_;  // [m] r_a
  double lever_b_;  // [m] r_b, negative for an internal mesh, 0 of a rack
  bool is_rack_;
  Vec2<double> local_axis_;  // u in the frame of c
  double start_;             // [m] r_a q_a + ... when it was made
};

extern template class ConstraintOf<GearJoint>;

}  // namespace cairn
