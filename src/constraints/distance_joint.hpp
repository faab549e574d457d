// Floor 3. Distance joint: a massless rod between two points.
#pragma once

#include <span>

#include "constraints/constraint.hpp"

namespace cairn {

/// Keeps the distance of two anchors. With d = p_b - p_a, u = d / |d| and arms r_a, r_b:
///   C = |d| - length,   j = (-u, -(r_a x u), u, r_b x u)
/// Both signs of the impulse are allowed: the rod pulls and pushes. At |d| = 0 the direction is not defined,
/// and no row is written.
class DistanceJoint final : public ConstraintOf<DistanceJoint> {
 public:
  struct Spec {
    BodyId a = {};
    BodyId b = {};
    Vec2<double> anchor_a = {0, 0};  // [m], world, where the bodies are placed
    Vec2<double> anchor_b = {0, 0};  // [m]
    double length = -1;              // [m]; negative: the distance of the anchors
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice, numbers that are not finite, or a length of 0.
  DistanceJoint(const Spec& spec, std::span<const Pose<double>> poses);

  std::string name() const override { return "distance"; }
  std::pair<BodyId, BodyId> bodies() const override { return {a_, b_}; }
  std::pair<Vec2<double>, Vec2<double>> anchors() const override { return {local_a_, local_b_}; }

  template <Scalar Real>
  void rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const;

 private:
  BodyId a_;
  BodyId b_;
  Vec2<double> local_a_;  // [m], in the body's frame
  Vec2<double> local_b_;
  double length_;  // [m]
};

}  // namespace cairn
