// Floor 3. Revolute joint: a pin through two bodies.
#pragma once

#include <span>

#include "constraints/constraint.hpp"

namespace cairn {

/// Keeps two anchors together: two rows, one for each axis (three dimensions would need three, paper 4.3).
///   C = p_b - p_a = x_b + r_b - x_a - r_a
///   j = (-1, 0, r_a.y, 1, 0, -r_b.y) for x,   (0, -1, -r_a.x, 0, 1, r_b.x) for y
class RevoluteJoint final : public ConstraintOf<RevoluteJoint> {
 public:
  struct Spec {
    BodyId a = {};
    BodyId b = {};
    Vec2<double> anchor = {0, 0};  // [m], world, where the bodies are placed
  };

  /// `poses` are those the bodies start from.
  /// @throws std::invalid_argument for one body twice or an anchor that is not finite.
  RevoluteJoint(const Spec& spec, std::span<const Pose<double>> poses);

  std::string name() const override { return "revolute"; }
  std::pair<BodyId, BodyId> bodies() const override { return {a_, b_}; }
  std::pair<Vec2<double>, Vec2<double>> anchors() const override { return {local_a_, local_b_}; }

  template <Scalar Real>
  void rows(const std::vector<Pose<Real>>& poses, RowSpecs<Real>& rows) const;

 private:
  BodyId a_;
  BodyId b_;
  Vec2<double> local_a_;  // [m], in the body's frame
  Vec2<double> local_b_;
};

}  // namespace cairn
