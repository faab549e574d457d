// Floor 3. Weld joint: two bodies as one.
#pragma once

#include <cairn/constraints/joint_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Keeps two anchors together and the angle between the bodies: three rows, all that the plane allows. With
/// positions x, angles q, arms r_a, r_b from the centres of mass to the anchor, and the angle q_0 that b had
/// against a where the joint was made:
///   C = p_b - p_a = x_b + r_b - x_a - r_a,   C = q_b - q_a - q_0
///   j = (-1, 0, r_a.y, 1, 0, -r_b.y) for x,   (0, -1, -r_a.x, 0, 1, r_b.x) for y,
///       (0, 0, -1, 0, 0, 1) for q
/// The third row's impulse is the moment that bends the joint. A long beam of welds converges slowly: about
/// n^4 sweeps a digit for n bodies. Its geometric stiffness is that of a pin (add_pin_stiffness); its moment
/// has none. A soft weld is glue or a flexible beam: its place and its angle each give way like a spring.
/// Source: the derivative of C; softness.hpp for springs.
class WeldJoint final : public ConstraintOf<WeldJoint> {
 public:
  /// What the joint is made from.
  struct Spec {
    BodyId a = {};                          // the first body
    BodyId b = {};                          // the second body
    Vec2<double> anchor = {0, 0};           // [m], world, where the bodies are placed
    std::optional<Softness> softness = {};  // of the two rows of the place [N/m]; none: rigid
    std::optional<Softness> bending = {};   // of the row of the angle [N m/rad]; none: rigid
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice, an anchor that is not finite, or a softness out of
  /// range.
  WeldJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  std::string name() const override { return "weld"; }
  JointTraits traits() const override { return {.box2d_rows = 3}; }
  List<Attachment> attachments() const override { return ends_.attachments(); }
  /// Where it is fastened.
  const JointEnds& ends() const { return ends_; }
  /// Of its place; none: rigid.
  const std::optional<Softness>& softness() const { return softness_; }
  /// Of its angle; none: rigid.
  const std::optional<Softness>& bending() const { return bending_; }

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

  /// Adds its geometric stiffness under these forces, as add_stiffness().
  template <Scalar Real>
  void stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
               PerBody<Vec3<Real>>& stiffness) const;

 private:
  JointEnds ends_;
  std::optional<Softness> softness_;
  std::optional<Softness> bending_;
};

extern template class ConstraintOf<WeldJoint>;

}  // namespace cairn
