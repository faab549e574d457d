// Floor 2. When two shapes that move come near each other.
#include "collision/approach.hpp"

#include <algorithm>
#include <cmath>

#include "collision/hull_contact.hpp"

namespace cairn {
namespace {

using narrowphase::FaceQuery;
using narrowphase::farthest_face;

// What goes straight is near after a few rounds; what turns about a point far from where it touches takes
// more. After the last one the time is too early, which is safe.
constexpr int most_rounds = 32;

/// The surfaces of two hulls.
template <Scalar Real>
struct Gap {
  Vec2<Real> normal = {0, 1};  // unit, from a to b
  Real separation = 0;         // [m] along the normal: no more than between their nearest points
};

/// The shortest way from the vertices of `from` to the core of `to`, if it is shorter than `way`.
template <Scalar Real>
void shorten(const RoundedHull<Real>& from, const RoundedHull<Real>& to, Vec2<Real>& way) {
  for (int i = 0; i < from.count; ++i) {
    for (int j = 0; j < to.count; ++j) {
      const Vec2<Real> arm = from.vertex(i) - to.vertex(j), edge = to.vertex(to.next(j)) - to.vertex(j);
      const Real squared = edge.squaredNorm();
      const Real share = squared > 0 ? std::clamp(edge.dot(arm) / squared, Real(0), Real(1)) : Real(0);
      const Vec2<Real> other = share * edge - arm;
      if (other.squaredNorm() < way.squaredNorm()) way = other;
    }
  }
}

template <Scalar Real>
Gap<Real> gap_between(const RoundedHull<Real>& a, const RoundedHull<Real>& b, Real rounding) {
  const Real radii = a.radius + b.radius;
  const FaceQuery<Real> on_a = farthest_face(a, b), on_b = farthest_face(b, a);
  const Real separation = std::max(on_a.separation, on_b.separation);
  Gap<Real> gap{.separation = std::max(separation, -rounding) - radii};
  if (std::isfinite(separation)) {
    const bool is_on_a = on_a.separation >= on_b.separation;
    gap.normal = is_on_a ? a.normal(on_a.face) : Vec2<Real>(-b.normal(on_b.face));
    gap.separation = separation - radii;
    if (separation <= rounding) return gap;
  }
  Vec2<Real> way = b.vertex(0) - a.vertex(0), back = -way;
  shorten(a, b, way);
  shorten(b, a, back);
  if (back.squaredNorm() < way.squaredNorm()) way = -back;
  const Real distance = hypotenuse(way.x(), way.y());
  if (distance <= rounding) return gap;
  return {.normal = way / distance, .separation = distance - radii};
}

}  // namespace

template <Scalar Real>
Frame<Real> Course<Real>::at(Real time) const {
  return Pose<Real>{pose.position + time * velocity.template head<2>(), pose.angle + time * velocity.z()};
}

template <Scalar Real>
Approach<Real> approach(const Shape<Real>& a, const std::type_identity_t<Course<Real>>& course_a,
                        const Shape<Real>& b, const std::type_identity_t<Course<Real>>& course_b, Real time,
                        Real near) {
  const Vec2<Real> parting = (course_b.velocity - course_a.velocity).template head<2>();
  const Real turning =
      std::abs(course_a.velocity.z()) * course_a.radius + std::abs(course_b.velocity.z()) * course_b.radius;
  Approach<Real> met;
  for (int round = 0;; ++round) {
    const Frame<Real> frame_a = course_a.at(met.time), frame_b = course_b.at(met.time);
    const RoundedHull<Real> hull_a = rounded_hull(a, frame_a, frame_a.position);
    const RoundedHull<Real> hull_b = rounded_hull(b, frame_b, frame_a.position);
    const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * (hull_a.extent + hull_b.extent);
    const Gap<Real> gap = gap_between(hull_a, hull_b, rounding);
    met.separation = gap.separation;
    const Real closing = turning - gap.normal.dot(parting);
    if (met.separation <= near || !(closing > 0) || !(met.time < time)) return met;
    if (round == most_rounds) return {met.time, near};
    met.time = std::min(time, met.time + (met.separation - near / 2) / closing);
  }
}

template struct Course<float>;
template struct Course<double>;
template struct Course<long double>;
template Approach<float> approach(const Shape<float>&, const Course<float>&, const Shape<float>&,
                                  const Course<float>&, float, float);
template Approach<double> approach(const Shape<double>&, const Course<double>&, const Shape<double>&,
                                   const Course<double>&, double, double);
template Approach<long double> approach(const Shape<long double>&, const Course<long double>&,
                                        const Shape<long double>&, const Course<long double>&, long double,
                                        long double);

}  // namespace cairn
