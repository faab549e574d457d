// Floor 2. Narrowphase: the manifold of any two shapes.
//
// The cores of two rounded hulls are compared first: the face from which the other core is farthest away
// (separating axis theorem) tells how far apart they are, or how deep they overlap. When the cores are apart
// and two corners are what is nearest, the contact is one point between these corners. Else a face touches:
// the other hull's edge that faces it most is cut to the width of the face, and its two ends are the points.
#include <cairn/collision/collide.hpp>

#include <limits>

#include <cairn/collision/collide_beside.hpp>
#include <cairn/collision/hull_contact.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

template <Scalar Real>
Manifold<Real> collide(const Shape<Real>& a, const std::type_identity_t<Frame<Real>>& frame_a,
                       const Shape<Real>& b, const std::type_identity_t<Frame<Real>>& frame_b, Real margin,
                       const std::type_identity_t<NeighboursOf<Real>>& around) {
  const Vec2<Real>& origin = frame_a.position;
  const RoundedHull<Real> hull_a = rounded_hull(a, frame_a, origin);
  const RoundedHull<Real> hull_b = rounded_hull(b, frame_b, origin);
  // A few roundings each of a rotation, a difference and a projection.
  const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * (hull_a.extent + hull_b.extent);
  const narrowphase::Pair<Real> pair{hull_a, hull_b, margin, rounding};
  Manifold<Real> manifold;
  if (around.a != nullptr) {
    manifold = narrowphase::collide_beside(pair, narrowphase::Side::a, *around.a, frame_a.rotation);
  } else if (around.b != nullptr) {
    manifold = narrowphase::collide_beside(pair, narrowphase::Side::b, *around.b, frame_b.rotation);
  } else {
    manifold = narrowphase::collide_hulls(pair);
  }
  for (int i = 0; i < manifold.count; ++i) manifold.points[i].position += origin;
  return manifold;
}

template Manifold<float> collide(const Shape<float>&, const Frame<float>&, const Shape<float>&,
                                 const Frame<float>&, float, const NeighboursOf<float>&);
template Manifold<double> collide(const Shape<double>&, const Frame<double>&, const Shape<double>&,
                                  const Frame<double>&, double, const NeighboursOf<double>&);

}  // namespace cairn
