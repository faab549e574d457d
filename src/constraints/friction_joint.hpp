// Floor 3. Friction joint: a table seen from above, whose normal force is known.
#pragma once

#include <optional>

#include <cairn/constraints/joint_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// What the friction forces of a body on a table may be.
enum class FrictionShape {
  square,          // each axis of the world up to max_force: too strong along diagonals
  aligned_square,  // each axis up to max_force, the first one along the velocity
  circle,          // no longer than max_force, in any direction: Coulomb's cone
};

/// Slows the sliding of b on a, and its turning, with at most a given force and torque: for scenes seen from
/// above, where gravity points into the table and max_force is mu m g. No C; with v the velocity of the
/// anchor on b, less that of the same point of a, arms r_a, r_b to that point, and axes s, t:
///   slide  j = (-s, -(r_a x s), s, r_b x s),  j v = 0,  |impulse| <= max_force dt;  the same for t
///   turn   j = (0, 0, -1, 0, 0, 1),           j v = 0,  |impulse| <= max_torque dt
/// The square has s and t along x and y. The others have s along v as it would be without constraints, and t
/// across; at rest, x and y. In the circle the row of t may have what the row of s has left of the disc:
/// |impulse_t| <= sqrt((max_force dt)^2 - impulse_s^2).
///
/// Why the axes must turn: clamp each of two fixed axes to what the other has left, and every point of an arc
/// of the circle is an answer, as both rows want more and neither may have it; which of them comes out
/// depends on the order of the rows. No rule for one row that sees but the impulse of the other can do
/// better, as the direction of sliding is not in it. Along v the first row is the whole friction of a sliding
/// body and the second is nothing: exact for a body that slides freely. Where other joints turn the sliding
/// within a step, the direction is behind by that step. Source: paper 4.5, which finds no difference between
/// the cone and axes along the velocity; the disc as in Coulomb's law.
class FrictionJoint final : public ConstraintOf<FrictionJoint> {
 public:
  /// What the joint is made from.
  struct Spec {
    BodyId a = ground;                            // the table
    BodyId b = {};                                // what slides on it
    std::optional<Vec2<double>> anchor = {};      // [m], world: where it acts on b; none: its centre of mass
    double max_force = 0;                         // [N]; 0: slides freely
    double max_torque = 0;                        // [N m]; 0: turns freely
    FrictionShape shape = FrictionShape::circle;  // of the set of forces
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice, numbers that are not finite, limits below 0, or no
  /// limit above 0.
  FrictionJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  std::string name() const override { return "friction"; }
  JointTraits traits() const override { return {.holds_points = false, .box2d_rows = 3}; }
  List<Attachment> attachments() const override { return ends_.attachments(); }
  bool bodies_collide() const override { return true; }
  /// [N]
  double max_force() const { return max_force_; }
  /// [N m]
  double max_torque() const { return max_torque_; }
  /// Of the forces that it may have.
  FrictionShape shape() const { return shape_; }

  /// Writes the rows that hold where bodies are, and as they move.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

 private:
  template <Scalar Real>
  JointArms<Real> arms(const Placements<Real>& at) const;
  template <Scalar Real>
  Vec2<Real> first_axis(const JointArms<Real>& arms, const RowWriter<Real>& rows) const;

  JointEnds ends_;
  double max_force_;   // [N]
  double max_torque_;  // [N m]
  FrictionShape shape_;
};

extern template class ConstraintOf<FrictionJoint>;

}  // namespace cairn
