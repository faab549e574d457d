// Floor 2. Where bodies are, with the cosines and sines that all who look at a body share.
#pragma once

#include <limits>

#include <cairn/dynamics/body.hpp>

namespace cairn {

/// A pose with the cosine and the sine of its angle.
template <Scalar Real>
struct Placement {
  Vec2<Real> position = Vec2<Real>::Zero();  // [m] of the centre of mass
  Real angle = 0;                            // [rad] counter-clockwise, continuous
  Rotation<Real> rotation = {};              // from the body's directions to the world's
};

/// An angle with its cosine and its sine, kept for whoever asks for the same angle again.
template <Scalar Real>
struct KnownRotation {
  Real angle = std::numeric_limits<Real>::quiet_NaN();  // [rad]; not a number: none is known yet
  Rotation<Real> rotation = {};                         // by this angle
};

/// Where bodies are: a view of their poses.
template <Scalar Real>
class Placements {
 public:
  /// Cosines and sines are computed whenever a body is looked at.
  Placements(const PerBody<Pose<Real>>& poses) : poses_(&poses) {}
  /// They are computed once for each angle of a body: `known` keeps them, as scratch memory of one thread.
  Placements(const PerBody<Pose<Real>>& poses, PerBody<KnownRotation<Real>>& known)
      : poses_(&poses), known_(&known) {
    known.resize(poses.size());
  }

  /// Where a body is.
  Placement<Real> operator[](BodyId body) const {
    const Pose<Real>& pose = (*poses_)[body];
    const Real angle = pose.angle + 0;  // no -0: both zeros turn alike
    if (known_ == nullptr) return {pose.position, pose.angle, Rotation<Real>(angle)};
    KnownRotation<Real>& known = (*known_)[body];
    if (!(known.angle == angle)) known = {angle, Rotation<Real>(angle)};
    return {pose.position, pose.angle, known.rotation};
  }

 private:
  const PerBody<Pose<Real>>* poses_;
  PerBody<KnownRotation<Real>>* known_ = nullptr;
};

}  // namespace cairn
