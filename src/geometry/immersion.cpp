// Floor 1. Moments of areas below a level.
#include <cairn/geometry/immersion.hpp>

#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>

namespace cairn {

namespace {

/// Integrals of x, x^2 / 2, x y, x^3 / 3 and x y^2 over dy around an outline: of 1, x, y, x^2 and y^2 over
/// its area. y points upwards.
struct OutlineSums {
  double area = 0, x = 0, y = 0, xx = 0, yy = 0;
};

/// The values below are those of polynomials of the third degree, for which Gauss' rule of two points is
/// exact.
void add_line(Vec2<double> from, Vec2<double> to, double level, OutlineSums& sums) {
  if (from.y() >= level && to.y() >= level) return;
  const auto at_level = [&] {
    return Vec2<double>(from + (level - from.y()) / (to.y() - from.y()) * (to - from));
  };
  const Vec2<double> crossing = from.y() > level || to.y() > level ? at_level() : from;
  if (from.y() > level) from = crossing;
  if (to.y() > level) to = crossing;
  const Vec2<double> middle = (from + to) / 2, half = (to - from) / 2;
  for (const double side : {-1.0, 1.0}) {
    const Vec2<double> p = middle + side / std::sqrt(3.0) * half;
    const double x = p.x(), y = p.y(), dy = half.y();
    sums.area += x * dy;
    sums.x += x * x / 2 * dy;
    sums.y += x * y * dy;
    sums.xx += x * x * x / 3 * dy;
    sums.yy += x * y * y * dy;
  }
}

/// The integrals from 0 to `t` of cos^c sin^s, named by c and s.
struct ArcPowers {
  double c1, c2, c3, c4, c1s1, c2s1, c1s2, c2s2;

  explicit ArcPowers(double t) {
    const Rotation<double> turn(t);
    const double c = turn.c, s = turn.s, sin2 = 2 * s * c, sin4 = 2 * sin2 * (c * c - s * s);
    c1 = s;
    c2 = t / 2 + sin2 / 4;
    c3 = s - s * s * s / 3;
    c4 = 3 * t / 8 + sin2 / 4 + sin4 / 32;
    c1s1 = s * s / 2;
    c2s1 = (1 - c * c * c) / 3;
    c1s2 = s * s * s / 3;
    c2s2 = t / 8 - sin4 / 32;
  }
};

/// An arc counter-clockwise around `center`, all of it below the level.
void add_whole_arc(const Vec2<double>& center, double radius, double from, double to, OutlineSums& sums) {
  const double x = center.x(), y = center.y(), r = radius;
  const auto until = [&](double angle) {
    const ArcPowers p(angle);
    const double rx = r * p.c2s1, ry = r * p.c2;
    return OutlineSums{
        .area = r * (x * p.c1 + r * p.c2),
        .x = r / 2 * (x * x * p.c1 + 2 * x * r * p.c2 + r * r * p.c3),
        .y = r * (x * y * p.c1 + x * r * p.c1s1 + y * ry + r * rx),
        .xx = r / 3 * (x * x * x * p.c1 + 3 * x * x * ry + 3 * x * r * r * p.c3 + r * r * r * p.c4),
        .yy = r * (x * (y * y * p.c1 + 2 * y * r * p.c1s1 + r * r * p.c1s2) + y * y * ry + 2 * y * r * rx +
                   r * r * r * p.c2s2)};
  };
  const OutlineSums end = until(to), start = until(from);
  sums.area += end.area - start.area;
  sums.x += end.x - start.x;
  sums.y += end.y - start.y;
  sums.xx += end.xx - start.xx;
  sums.yy += end.yy - start.yy;
}

/// The parts of an arc below the level; `from` in (-pi, pi], `to` at most a turn further.
void add_arc(const Vec2<double>& center, double radius, double from, double to, double level,
             OutlineSums& sums) {
  List<double> ends = {from, to};
  const double height = (level - center.y()) / radius;
  if (std::abs(height) < 1) {
    const double turn = 2 * pi, right = arc_sine(height), left = pi - right;
    for (const double crossing : {right - turn, left - turn, right, left, right + turn, left + turn}) {
      if (from < crossing && crossing < to) ends.push_back(crossing);
    }
    std::sort(ends.begin(), ends.end());
  }
  for (int i = 0; i + 1 < ends.size(); ++i) {
    const bool below = Rotation<double>((ends[i] + ends[i + 1]) / 2).s < height;
    if (below) add_whole_arc(center, radius, ends[i], ends[i + 1], sums);
  }
}

/// The outline of all points within `radius` of a convex polygon, of a segment there and back, or of a point.
void add_rounded(const List<Vec2<double>>& corners, double radius, double level, OutlineSums& sums) {
  const int count = corners.size();
  const auto direction = [&](int i) {  // [rad] of the normal of edge i
    const Vec2<double> way = corners[(i + 1) % count] - corners[i % count];
    return arc_tangent(-way.x(), way.y());
  };
  for (int i = 0; i < count; ++i) {
    const Vec2<double>&one = corners[i], &next = corners[(i + 1) % count];
    const double normal = direction(i);
    const Vec2<double> out = Rotation<double>(normal) * Vec2<double>(radius, 0);
    add_line(one + out, next + out, level, sums);
    if (!(radius > 0)) continue;
    double turn = direction(i + 1) - normal;
    if (turn < 0) turn += 2 * pi;
    add_arc(next, radius, normal, normal + turn, level, sums);
  }
}

}  // namespace

AreaMoments immersed(const Shape<double>& shape, double angle, const Vec2<double>& up, double level) {
  // To axes with y along `up`.
  const Rotation<double> tilt(CosineAndSine<double>{.cosine = up.y(), .sine = -up.x()}), by_angle(angle);
  const auto turned = [&](const Vec2<double>& point) { return tilt.transposed_times(by_angle * point); };
  OutlineSums sums;
  if (const auto* disc = std::get_if<Circle<double>>(&shape)) {
    add_arc(turned(disc->center), disc->radius, -pi, pi, level, sums);
  } else if (const auto* rod = std::get_if<Capsule<double>>(&shape)) {
    add_rounded({turned(rod->point1), turned(rod->point2)}, rod->radius, level, sums);
  } else if (const auto* polygon = std::get_if<Polygon<double>>(&shape)) {
    List<Vec2<double>> corners;
    for (const Vec2<double>& vertex : polygon->vertices) corners.push_back(turned(vertex));
    add_rounded(corners, polygon->radius, level, sums);
  }
  return {.area = sums.area, .first = tilt * Vec2<double>(sums.x, sums.y), .polar = sums.xx + sums.yy};
}

AreaMoments immersed(Span<const Shape<double>> shapes, const Pose<double>& pose, const Vec2<double>& up,
                     double level) {
  AreaMoments sum;
  for (const Shape<double>& shape : shapes) {
    const AreaMoments part = immersed(shape, pose.angle, up, level - up.dot(pose.position));
    sum.area += part.area;
    sum.first += part.first;
    sum.polar += part.polar;
  }
  return sum;
}

}  // namespace cairn
