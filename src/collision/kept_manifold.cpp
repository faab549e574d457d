// Floor 2. A manifold that moves with its two bodies.
#include <cairn/collision/kept_manifold.hpp>

#include <cmath>
#include <limits>

namespace cairn {

template <Scalar Real>
KeptManifold<Real> keep(const Manifold<Real>& manifold, const Frame<Real>& frame_a, Real radius_a,
                        const Frame<Real>& frame_b, Real radius_b) {
  using Face = typename KeptManifold<Real>::Face;
  KeptManifold<Real> kept{.radius_a = radius_a, .radius_b = radius_b};
  kept.count = static_cast<std::uint8_t>(manifold.count);
  if (kept.count == 0) return kept;
  const FeatureKind kind = feature_kind(manifold.points[0].feature);
  kept.face = kind == FeatureKind::face_of_a   ? Face::of_a
              : kind == FeatureKind::face_of_b ? Face::of_b
                                               : Face::none;
  const Frame<Real>& turning = kept.face == Face::of_b ? frame_b : frame_a;
  const Vec2<Real>& normal = manifold.normal;
  kept.normal = turning.rotation.transposed_times(normal);
  Real mean = 0;  // [m] of the separations: the points lie half of it from the surface of the face
  for (int i = 0; i < kept.count; ++i) mean += manifold.points[i].separation / static_cast<Real>(kept.count);
  for (int i = 0; i < kept.count; ++i) {
    const ManifoldPoint<Real>& point = manifold.points[i];
    const Real below = kept.face == Face::of_b ? point.separation - mean / 2 : mean / 2;  // [m] surface of a
    const Vec2<Real> core_a = point.position - normal * (below + radius_a);
    const Vec2<Real> core_b = point.position + normal * (point.separation - below + radius_b);
    kept.points[i].core_a = frame_a.rotation.transposed_times(core_a - frame_a.position);
    kept.points[i].core_b = frame_b.rotation.transposed_times(core_b - frame_b.position);
    kept.feature[i] = point.feature;
  }
  return kept;
}

template <Scalar Real>
Manifold<Real> KeptManifold<Real>::at(const Frame<Real>& frame_a, const Frame<Real>& frame_b,
                                      Real margin) const {
  Manifold<Real> manifold;
  manifold.normal = (face == Face::of_b ? frame_b : frame_a).rotation * normal;
  const Vec2<Real> from_a_to_b = frame_b.position - frame_a.position;
  Real height = 0;  // [m] over the centre of a, of the points' middle
  for (int i = 0; i < count; ++i) {
    const Vec2<Real> core_a = frame_a.rotation * points[i].core_a;
    const Vec2<Real> core_b = from_a_to_b + frame_b.rotation * points[i].core_b;
    const Vec2<Real> gap = core_b - core_a;
    Real distance = manifold.normal.dot(gap);
    if (face == Face::none) {
      distance = hypotenuse(gap.x(), gap.y());
      const Real rounding = 8 * std::numeric_limits<Real>::epsilon() *
                            (core_a.cwiseAbs().maxCoeff() + core_b.cwiseAbs().maxCoeff());
      if (distance > rounding) manifold.normal = gap / distance;
    }
    const Real separation = distance - (radius_a + radius_b);
    if (!(separation < margin)) continue;
    ManifoldPoint<Real>& point = manifold.points[manifold.count++];
    // Along a face the point is where the core is that touches it.
    if (face == Face::of_b) {
      point.position = core_a + manifold.normal * (radius_a + separation / 2);
    } else {
      point.position = core_b - manifold.normal * (radius_b + separation / 2);
    }
    point.separation = separation;
    point.feature = feature[i];
    height += manifold.normal.dot(point.position);
  }
  for (int i = 0; i < manifold.count; ++i) {
    Vec2<Real>& position = manifold.points[i].position;
    const Real middle = height / static_cast<Real>(manifold.count);
    position += manifold.normal * (middle - manifold.normal.dot(position)) + frame_a.position;
  }
  return manifold;
}

template struct KeptManifold<float>;
template KeptManifold<float> keep(const Manifold<float>&, const Frame<float>&, float, const Frame<float>&,
                                  float);
template struct KeptManifold<double>;
template KeptManifold<double> keep(const Manifold<double>&, const Frame<double>&, double,
                                   const Frame<double>&, double);

}  // namespace cairn
