// Floor 2. A manifold that moves with its two bodies.
#include "collision/kept_manifold.hpp"

#include <cmath>
#include <limits>

namespace cairn {

template <Scalar Real>
KeptManifold<Real>::KeptManifold(const Manifold<Real>& manifold, const Frame<Real>& frame_a, Real radius_a,
                                 const Frame<Real>& frame_b, Real radius_b)
    : radius_a_(radius_a), radius_b_(radius_b), count_(static_cast<std::uint8_t>(manifold.count)) {
  if (count_ == 0) return;
  const FeatureKind kind = feature_kind(manifold.points[0].feature);
  face_ = kind == FeatureKind::face_of_a   ? Face::of_a
          : kind == FeatureKind::face_of_b ? Face::of_b
                                           : Face::none;
  const Frame<Real>& turning = face_ == Face::of_b ? frame_b : frame_a;
  const Vec2<Real>& normal = manifold.normal;
  normal_ = turning.rotation.transposed_times(normal);
  Real mean = 0;  // [m] of the separations: the points lie half of it from the surface of the face
  for (int i = 0; i < count_; ++i) mean += manifold.points[i].separation / static_cast<Real>(count_);
  for (int i = 0; i < count_; ++i) {
    const ManifoldPoint<Real>& point = manifold.points[i];
    const Real below = face_ == Face::of_b ? point.separation - mean / 2 : mean / 2;  // [m] surface of a
    const Vec2<Real> core_a = point.position - normal * (below + radius_a);
    const Vec2<Real> core_b = point.position + normal * (point.separation - below + radius_b);
    points_[i].core_a = frame_a.rotation.transposed_times(core_a - frame_a.position);
    points_[i].core_b = frame_b.rotation.transposed_times(core_b - frame_b.position);
    points_[i].feature = point.feature;
  }
}

template <Scalar Real>
Manifold<Real> KeptManifold<Real>::at(const Frame<Real>& frame_a, const Frame<Real>& frame_b,
                                      Real margin) const {
  Manifold<Real> manifold;
  manifold.normal = (face_ == Face::of_b ? frame_b : frame_a).rotation * normal_;
  const Vec2<Real> from_a_to_b = frame_b.position - frame_a.position;
  Real height = 0;  // [m] over the centre of a, of the points' middle
  for (int i = 0; i < count_; ++i) {
    const Vec2<Real> core_a = frame_a.rotation * points_[i].core_a;
    const Vec2<Real> core_b = from_a_to_b + frame_b.rotation * points_[i].core_b;
    const Vec2<Real> gap = core_b - core_a;
    Real distance = manifold.normal.dot(gap);
    if (face_ == Face::none) {
      distance = std::hypot(gap.x(), gap.y());
      const Real rounding = 8 * std::numeric_limits<Real>::epsilon() *
                            (core_a.cwiseAbs().maxCoeff() + core_b.cwiseAbs().maxCoeff());
      if (distance > rounding) manifold.normal = gap / distance;
    }
    const Real separation = distance - (radius_a_ + radius_b_);
    if (!(separation < margin)) continue;
    ManifoldPoint<Real>& point = manifold.points[manifold.count++];
    // Along a face the point is where the core is that touches it.
    if (face_ == Face::of_b) {
      point.position = core_a + manifold.normal * (radius_a_ + separation / 2);
    } else {
      point.position = core_b - manifold.normal * (radius_b_ + separation / 2);
    }
    point.separation = separation;
    point.feature = points_[i].feature;
    height += manifold.normal.dot(point.position);
  }
  for (int i = 0; i < manifold.count; ++i) {
    Vec2<Real>& position = manifold.points[i].position;
    const Real middle = height / static_cast<Real>(manifold.count);
    position += manifold.normal * (middle - manifold.normal.dot(position)) + frame_a.position;
  }
  return manifold;
}

template class KeptManifold<float>;
template class KeptManifold<double>;
template class KeptManifold<long double>;

}  // namespace cairn
