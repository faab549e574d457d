// Random shapes with a fixed seed, and the corners of a shape's core, for tests that try many of them.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>

namespace cairn::test {

/// The same numbers on every machine (the distributions of the standard library are not).
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double uniform(double lower, double upper) {
    return lower + (upper - lower) * std::ldexp(static_cast<double>(engine_() >> 11), -53);
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }
  Vec2<double> point(double reach) {
    const double x = uniform(-reach, reach);
    return {x, uniform(-reach, reach)};
  }

 private:
  std::mt19937_64 engine_;
};

inline constexpr int shape_kinds = 5;

/// 0: circle, 1: capsule, 2: polygon, 3: rounded polygon, 4: segment. About 1 m large and off its origin.
inline Shape<double> random_shape(int kind, Random& random) {
  const Vec2<double> offset = random.point(0.3);
  const double radius = random.uniform(0.1, 0.4);
  const double angle = random.uniform(-pi, pi);
  const double length = random.uniform(0.5, 1.5);
  if (kind == 0) return circle(radius, offset);
  if (kind == 1) return moved(capsule({-length / 2, 0}, {length / 2, 0}, radius), offset, angle);
  if (kind == 4) return moved(segment({-length / 2, 0}, {length / 2, 0}), offset, angle);
  // Corners on an ellipse, at unequal angles that leave a gap: always convex.
  const int count = 3 + random.below(6);
  List<Vec2<double>> corners;
  for (int i = 0; i < count; ++i) {
    const double turn = 2 * pi * (i + random.uniform(0, 0.7)) / count;
    corners.emplace_back(length / 2 * std::cos(turn), 0.4 * std::sin(turn));
  }
  return moved(polygon(corners, kind == 3 ? radius : 0), offset, angle);
}

/// Every shape is the convex hull of these corners, and all that is within `radius` of it.
struct Core {
  List<Vec2<long double>> corners;  // [m], world, counter-clockwise
  long double radius = 0;           // [m]
};

/// By the C library, in long double.
inline Rotation<long double> exact_rotation(long double angle) {
  return Rotation<long double>(CosineAndSine<long double>{std::cos(angle), std::sin(angle)});
}

/// At a pose, in long double whatever the scalar, so that only the rounding of the input is shared.
template <Scalar Real>
Core core(const Shape<Real>& shape, const Pose<Real>& pose) {
  Core result;
  const Rotation<long double> rotation = exact_rotation(pose.angle);
  const auto add = [&](const Vec2<Real>& local) {
    const Vec2<long double> position = pose.position.template cast<long double>();
    result.corners.push_back(position + rotation * local.template cast<long double>());
  };
  if (const auto* round = std::get_if<Circle<Real>>(&shape)) {
    add(round->center);
    result.radius = round->radius;
  } else if (const auto* pill = std::get_if<Capsule<Real>>(&shape)) {
    add(pill->point1);
    add(pill->point2);
    result.radius = pill->radius;
  } else if (const auto* line = std::get_if<Segment<Real>>(&shape)) {
    add(line->point1);
    add(line->point2);
  } else {
    const Polygon<Real>& convex = std::get<Polygon<Real>>(shape);
    for (const Vec2<Real>& vertex : convex.vertices) add(vertex);
    result.radius = convex.radius;
  }
  return result;
}

/// The corner that lies farthest in a direction.
inline Vec2<long double> farthest_corner(const Core& core, const Vec2<long double>& direction) {
  Vec2<long double> best = core.corners[0];
  for (const Vec2<long double>& corner : core.corners) {
    if (corner.dot(direction) > best.dot(direction)) best = corner;
  }
  return best;
}

}  // namespace cairn::test
