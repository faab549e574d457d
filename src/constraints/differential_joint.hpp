// Floor 3. Differential joint: the gear box between two driven wheels.
#pragma once

#include <cairn/constraints/constraint.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Keeps the turning of a case, c, the mean of that of its two shafts, a and b. With the angles q that they
/// have turned since the joint was made:
///   C = q_a + q_b - 2 q_c,   j = (0, 0, 1), (0, 0, 1) and (0, 0, -2)
/// One row on three bodies: a row on more than two (paper 4.3). The impulse [N m s] is the torque on each
/// shaft times dt: both get the same, whatever their speeds are, and the case twice that, back. It acts on
/// the angles alone. Source: the derivative of C.
class DifferentialJoint final : public ConstraintOf<DifferentialJoint> {
 public:
  /// What the joint is made from.
  struct Spec {
    BodyId a = {};  // one shaft
    BodyId b = {};  // the other one
    BodyId c = {};  // the case between them
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice.
  DifferentialJoint(const Spec& spec, PerBodySpan<const Pose<double>> poses);

  std::string name() const override { return "differential"; }
  JointTraits traits() const override { return {.holds_points = false}; }
  /// The middles of the bodies: a shaft, the case, the other shaft.
  List<Attachment> attachments() const override { return {{.body = a_}, {.body = c_}, {.body = b_}}; }

  /// Writes the rows that hold where bodies are.
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const;

 private:
  BodyId a_;
  BodyId b_;
  BodyId c_;
  double start_;  // [rad] q_a + q_b - 2 q_c when it was made
};

extern template class ConstraintOf<DifferentialJoint>;

}  // namespace cairn
