// Floor 3. Pulley joint: one rope over rollers, on up to four bodies.
#pragma once

#include <cairn/constraints/constraint.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Keeps the length of a rope that runs over rollers without friction. From the roller q_i of its end i the
/// rope goes to the anchor p_i of a body, r_i times there and back, as in a block and tackle. With
/// l_i = |p_i - q_i|, u_i = (p_i - q_i) / l_i, and arms from the centres of mass to p_i and q_i:
///   taut  C = sum r_i l_i - length,       impulse of any sign: pulls and pushes
///   rope  C = length - sum r_i l_i >= 0,  j of the other sign, impulse >= 0: only pulls
///   j of the body of end i     r_i (u_i, r_p x u_i)
///   j of the carrier of q_i    r_i (-u_i, -(r_q x u_i)), where the roller is not fixed to the ground
/// The impulse is the tension times dt. One row, however many bodies there are: this is the row on more than
/// two bodies of paper 4.3.
///
/// A rope that is wound on a drum does not slip: as the drum, its carrier, turns by q, it pays s q of rope
/// out. The rope leaves it at q_i, which moves with the centre of the drum and does not turn with it; the
/// radius is the arm of the rope there, s = r_q x u_i as they are when the joint is made:
///   l_i = |p_i - q_i| - s (q - q_0),   j of the drum r_i (-u_i, -s)
/// A wheel with mass that a rope runs over without slipping has a tension on each side: it is a drum with two
/// ropes, one joint for each.
///
/// A rope has its row while it has less slack than slack_margin. Where an anchor is at its roller, the
/// direction is not defined, and no row is written. Each part has the geometric stiffness of a line
/// (add_line_stiffness), r_i times; the arm on a drum does not turn, and has none. Source: the derivative of
/// C; the ratios are those of E. Catto, Box2D's pulley joint (2007).
class PulleyJoint final : public ConstraintOf<PulleyJoint> {
 public:
  /// Whether the rope only pulls, or is a belt that pushes too.
  enum class Kind { rope, taut };
  /// Whether the rope slips over the roller without friction, or is wound on it.
  enum class Roller { smooth, drum };
  /// One end of the rope: where it is fastened, and the last roller before it.
  struct End {
    BodyId body = {};              // that the end is fastened to
    Vec2<double> anchor = {0, 0};  // [m], world, where the bodies are placed
    Vec2<double> roller = {0, 0};  // [m], world: where the rope to the anchor leaves its roller
    double parts = 1;              // of rope between them; more than 1: a block and tackle
    BodyId carrier = ground;       // that the roller is fixed to
    Roller kind = Roller::smooth;  // smooth, or a drum
  };
  /// What the joint is made from.
  struct Spec {
    List<End> ends = {};        // one or more, on up to four bodies with their carriers
    double length = -1;         // [m] sum of all parts; negative: as long as it is now
    Kind kind = Kind::rope;     // rope or taut
    double slack_margin = 0.5;  // [m]; a rope that loses more slack in one step is overstretched
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for no ends, unknown bodies, more than four besides the ground, an end
  /// whose body carries its own roller, numbers that are not finite, parts or a length that are not > 0, and
  /// a drum that is the ground or that the rope does not go around.
  PulleyJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  std::string name() const override { return "pulley"; }
  JointTraits traits() const override { return {.is_line = true, .is_over_ground = true}; }
  /// From the first anchor over its roller to the next roller and down to its anchor, and so on.
  List<Attachment> attachments() const override;
  bool bodies_collide() const override { return true; }
  /// Whether it only pulls.
  Kind kind() const { return kind_; }
  /// [m] Of all parts.
  double length() const { return length_; }
  /// How many parts of rope each end has.
  List<double> parts() const;

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

  /// Adds its geometric stiffness under these forces, as add_stiffness().
  template <Scalar Real>
  void stiffen(const Placements<Real>& at, const RowForces<Real>& forces,
               PerBody<Vec3<Real>>& stiffness) const;

 private:
  struct Part {
    BodyId body = {};
    BodyId carrier = {};
    Roller kind = Roller::smooth;
    Vec2<double> anchor = {0, 0};  // [m] in the body's frame
    Vec2<double> roller = {0, 0};  // [m] in the carrier's frame; of a drum: from its centre, and never turned
    double count = 1;              // r_i
    double winding = 0;            // [m] s; 0 without a drum
    double start_angle = 0;        // [rad] q_0
  };
  static Part part_of(const End& end, PerBodySpan<const Pose<double>> poses);
  Attachment roller_of(const Part& part) const;

  List<Part> parts_;
  Kind kind_;
  double length_ = 0;    // [m]
  double slack_margin_;  // [m]
};

extern template class ConstraintOf<PulleyJoint>;

}  // namespace cairn
