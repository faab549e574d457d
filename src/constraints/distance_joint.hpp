// Floor 3. Distance joint: a massless rod, rope or spring between two points.
#pragma once

#include <optional>

#include <cairn/constraints/joint_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Keeps the distance of two anchors p_a, p_b. With d = p_b - p_a, u = d / |d| and arms r_a, r_b from the
/// centres of mass to the anchors:
///   rod     C = |d| - length,       j = (-u, -(r_a x u), u, r_b x u),   pulls and pushes
///   rope    C = length - |d| >= 0,  j = (u, r_a x u, -u, -(r_b x u)),   impulse >= 0: only pulls
///   least   C = |d| - least >= 0,   j of the rod, impulse >= 0: beside the row of a rope, it only pushes
///   spring  C and j of the rod, soft: impulse = -dt (k C + c dC/dt), as softness.hpp takes it
/// A rope may be soft too, as rubber is. It has a row while it has less slack than slack_margin. At |d| = 0
/// the direction is not defined, and no row is written. Its geometric stiffness is that of a line
/// (add_line_stiffness); what a spring's own k resists along the line is in its row already, exactly. Source:
/// the derivative of |d|; softness.hpp for springs.
class DistanceJoint final : public ConstraintOf<DistanceJoint> {
 public:
  /// What holds the anchors at their distance: see the class.
  enum class Kind { rod, rope, spring };
  /// What the joint is made from.
  struct Spec {
    BodyId a = {};                          // the first body
    BodyId b = {};                          // the second body
    Vec2<double> anchor_a = {0, 0};         // [m], world, where the bodies are placed
    Vec2<double> anchor_b = {0, 0};         // [m]
    double length = -1;                     // [m]; negative: the distance of the anchors
    Kind kind = Kind::rod;                  // rod, rope or spring
    std::optional<Softness> softness = {};  // a spring needs one, a rope may have one, a rod has none
    double least = 0;                       // [m] of a rope: the ends come no nearer
    double slack_margin = 0.5;              // [m]; a rope that loses more slack in one step is overstretched
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice, numbers that are not finite, a length of 0, or a
  /// softness or a least length that its kind cannot have.
  DistanceJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  /// "rod", "rope" or "spring".
  std::string name() const override;
  JointTraits traits() const override { return {.is_line = true}; }
  List<Attachment> attachments() const override { return ends_.attachments(); }
  /// Whether it is a rod, a rope or a spring.
  Kind kind() const { return kind_; }
  /// [m] Of a rod or a spring, or of a rope at most.
  double length() const { return length_; }
  /// [m] Of a rope at least.
  double least() const { return least_; }
  /// None: rigid.
  const std::optional<Softness>& softness() const { return softness_; }

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

  /// Adds its geometric stiffness under these forces, as add_stiffness().
  template <Scalar Real>
  void stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
               PerBody<Vec3<Real>>& stiffness) const;

 private:
  JointEnds ends_;
  Kind kind_;
  std::optional<Softness> softness_;
  double length_;        // [m]
  double least_;         // [m]
  double slack_margin_;  // [m]
};

extern template class ConstraintOf<DistanceJoint>;

}  // namespace cairn
