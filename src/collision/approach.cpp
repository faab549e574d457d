// Floor 2. When two shapes that move come near each other.
#include <cairn/collision/approach.hpp>

#include <algorithm>
#include <cmath>

#include <cairn/collision/hull_contact.hpp>

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
  Real cores = 0;              // [m] between the cores, without what rounds them
  Real separation = 0;         // [m] along the normal: no more than between their nearest points
};

// By which a square may be rounded, and more.
constexpr double rounded_square = 1 + 1e-5;

/// The shortest way from the vertices of `from` to the core of `to`, if it is shorter than `way`. An edge is
/// no nearer than the line that it lies on.
template <Scalar Real>
void shorten(const RoundedHull<Real>& from, const RoundedHull<Real>& to, Vec2<Real>& way) {
  Real most = static_cast<Real>(rounded_square) * way.squaredNorm();
  for (int i = 0; i < from.count; ++i) {
    for (int j = 0; j < to.count; ++j) {
      const Vec2<Real> arm = from.vertex(i) - to.vertex(j);
      const Real height = to.face_count() > 0 ? to.normal(j).dot(arm) : Real(0);
      if (height * height > most) continue;
      const Vec2<Real> edge = to.vertex(to.next(j)) - to.vertex(j);
      const Real squared = edge.squaredNorm();
      const Real share = squared > 0 ? std::clamp(edge.dot(arm) / squared, Real(0), Real(1)) : Real(0);
      const Vec2<Real> other = share * edge - arm;
      if (!(other.squaredNorm() < way.squaredNorm())) continue;
      way = other;
      most = static_cast<Real>(rounded_square) * way.squaredNorm();
    }
  }
}

/// Along the normal of the face that parts two hulls most. Where neither has a face, its size is -infinity.
template <Scalar Real>
Gap<Real> widest_gap(const RoundedHull<Real>& a, const RoundedHull<Real>& b) {
  const FaceQuery<Real> on_a = farthest_face(a, b), on_b = farthest_face(b, a);
  const Real separation = std::max(on_a.separation, on_b.separation);
  if (!std::isfinite(separation)) return {.separation = -std::numeric_limits<Real>::infinity()};
  const bool is_on_a = on_a.separation >= on_b.separation;
  return {.normal = is_on_a ? a.normal(on_a.face) : Vec2<Real>(-b.normal(on_b.face)),
          .cores = separation,
          .separation = separation - (a.radius + b.radius)};
}

/// Of two hulls that this gap parts: between their nearest points, if their cores are apart.
template <Scalar Real>
Gap<Real> nearest_gap(const RoundedHull<Real>& a, const RoundedHull<Real>& b, Real rounding,
                      const Gap<Real>& widest) {
  const Real radii = a.radius + b.radius;
  const bool has_face = std::isfinite(widest.separation);
  if (has_face && widest.cores <= rounding) return widest;
  Vec2<Real> way = b.vertex(0) - a.vertex(0), back = -way;
  shorten(a, b, way);
  shorten(b, a, back);
  if (back.squaredNorm() < way.squaredNorm()) way = -back;
  const Real distance = hypotenuse(way.x(), way.y());
  if (distance > rounding) return {.normal = way / distance, .separation = distance - radii};
  return has_face ? widest : Gap<Real>{.separation = -rounding - radii};
}

/// [m] How far a shape reaches in a unit direction from the centre of its body's frame.
template <Scalar Real>
struct Reach {
  Vec2<Real> direction;  // in the body's frame

  Real operator()(const Circle<Real>& shape) const { return direction.dot(shape.center) + shape.radius; }
  Real operator()(const Capsule<Real>& shape) const { return along(shape) + shape.radius; }
  Real operator()(const Segment<Real>& shape) const { return along(shape); }
  /// A chain is no hull: its links are.
  Real operator()(const Chain<Real>&) const { return std::numeric_limits<Real>::infinity(); }
  Real operator()(const Polygon<Real>& shape) const {
    Real most = -std::numeric_limits<Real>::infinity();
    for (const Vec2<Real>& vertex : shape.vertices) most = std::max(most, direction.dot(vertex));
    return most + shape.radius;
  }

 private:
  template <typename Line>
  Real along(const Line& line) const {
    return std::max(direction.dot(line.point1), direction.dot(line.point2));
  }
};

}  // namespace

template <Scalar Real>
Real gap_along(const Vec2<Real>& direction, const Shape<Real>& a,
               const std::type_identity_t<Frame<Real>>& frame_a, const Shape<Real>& b,
               const std::type_identity_t<Frame<Real>>& frame_b) {
  const Reach<Real> forth = {frame_a.rotation.transposed_times(direction)};
  const Reach<Real> back = {frame_b.rotation.transposed_times(-direction)};
  return direction.dot(frame_b.position - frame_a.position) - std::visit(forth, a) - std::visit(back, b);
}

template <Scalar Real>
Frame<Real> Course<Real>::at(Real time) const {
  if (frame && time == 0) return *frame;
  return Pose<Real>{pose.position + time * velocity.template head<2>(), pose.angle + time * velocity.z()};
}

template <Scalar Real>
Approach<Real> approach(const Shape<Real>& a, const std::type_identity_t<Course<Real>>& course_a,
                        const Shape<Real>& b, const std::type_identity_t<Course<Real>>& course_b, Real time,
                        Real near, Real far) {
  const Vec2<Real> parting = (course_b.velocity - course_a.velocity).template head<2>();
  const Real turning =
      std::abs(course_a.velocity.z()) * course_a.radius + std::abs(course_b.velocity.z()) * course_b.radius;
  Approach<Real> met;
  for (int round = 0;; ++round) {
    const Frame<Real> frame_a = course_a.at(met.time), frame_b = course_b.at(met.time);
    const RoundedHull<Real> hull_a = rounded_hull(a, frame_a, frame_a.position);
    const RoundedHull<Real> hull_b = rounded_hull(b, frame_b, frame_a.position);
    const Real rounding = 8 * std::numeric_limits<Real>::epsilon() * (hull_a.extent + hull_b.extent);
    const auto closing_along = [&](const Gap<Real>& gap) { return turning - gap.normal.dot(parting); };
    const Gap<Real> widest = widest_gap(hull_a, hull_b);
    const Real way = std::max(closing_along(widest), Real(0)) * (time - met.time);
    if (widest.separation - way > far + rounding) return {met.time, widest.separation, widest.normal};
    const Gap<Real> gap = nearest_gap(hull_a, hull_b, rounding, widest);
    met.separation = gap.separation;
    met.normal = gap.normal;
    const Real closing = closing_along(gap);
    if (met.separation <= near || !(closing > 0) || !(met.time < time)) return met;
    if (round == most_rounds) return {met.time, near, gap.normal};
    met.time = std::min(time, met.time + (met.separation - near / 2) / closing);
  }
}

template float gap_along(const Vec2<float>&, const Shape<float>&, const Frame<float>&, const Shape<float>&,
                         const Frame<float>&);
template double gap_along(const Vec2<double>&, const Shape<double>&, const Frame<double>&,
                          const Shape<double>&, const Frame<double>&);
template struct Course<float>;
template struct Course<double>;
template Approach<float> approach(const Shape<float>&, const Course<float>&, const Shape<float>&,
                                  const Course<float>&, float, float, float);
template Approach<double> approach(const Shape<double>&, const Course<double>&, const Shape<double>&,
                                   const Course<double>&, double, double, double);

}  // namespace cairn
