// Floor 3. Gear joint: two wheels that roll on each other.
#pragma once

#include <cairn/constraints/constraint.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Keeps what two wheels roll off on each other equal. With the angles q_a, q_b and q_c that the wheels and
/// their carrier have turned since the joint was made, and radii r_a, r_b:
///   external  C = r_a (q_a - q_c) + r_b (q_b - q_c),  teeth outside on both: they turn against each other
///   internal  C = r_a (q_a - q_c) - r_b (q_b - q_c),  one wheel inside the other: they turn the same way
///   j = (0, 0, r_a), (0, 0, +-r_b) and (0, 0, -r_a -+ r_b) for the carrier; C in m of rolled length
/// Only the ratio of the radii matters to the motion. The carrier is the body on which both axles sit: the
/// ground, unless the gear is a planetary one. The impulse [N s] is the force between the teeth times dt; it
/// acts on the angles alone, so the wheels need pins of their own. Source: the derivative of C.
class GearJoint final : public ConstraintOf<GearJoint> {
 public:
  /// Whether both wheels have their teeth outside, or one runs inside the other.
  enum class Mesh { external, internal };
  /// What the joint is made from.
  struct Spec {
    BodyId a = {};               // one wheel
    BodyId b = {};               // the other one
    BodyId c = ground;           // the carrier of both axles
    double radius_a = 1;         // [m] of the pitch circle
    double radius_b = 1;         // [m] of the other one
    Mesh mesh = Mesh::external;  // which way they turn
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice, or radii that are not > 0.
  GearJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  std::string name() const override { return "gear"; }
  JointTraits traits() const override { return {.holds_points = false}; }
  /// The middles of the wheels.
  List<Attachment> attachments() const override { return {{.body = a_}, {.body = b_}}; }

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

 private:
  BodyId a_;
  BodyId b_;
  BodyId c_;
  double lever_a_;  // [m] r_a
  double lever_b_;  // [m] r_b, negative for an internal mesh
  double start_;    // [m] r_a q_a + ... when it was made
};

extern template class ConstraintOf<GearJoint>;

}  // namespace cairn
