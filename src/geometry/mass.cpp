// Floor 1. Area, centroid and moment of inertia of shapes, exact.
#include <cairn/geometry/mass.hpp>
#include <cairn/math/list.hpp>

#include <cmath>
#include <cstddef>

namespace cairn {
namespace {

/// Area, centroid and inertia of parts, put together with the parallel axis theorem.
MassProperties combine(Span<const MassProperties> parts) {
  MassProperties whole;
  Vec2<double> first_moment = Vec2<double>::Zero();  // [m^3]
  for (const MassProperties& part : parts) {
    whole.area += part.area;
    first_moment += part.area * part.centroid;
  }
  if (!(whole.area > 0)) return {};
  whole.centroid = first_moment / whole.area;
  for (const MassProperties& part : parts) {
    whole.inertia += part.inertia + part.area * (part.centroid - whole.centroid).squaredNorm();
  }
  return whole;
}

/// About its centroid, a triangle of sides a, b, c has the inertia area (a^2 + b^2 + c^2) / 36.
MassProperties triangle(const Vec2<double>& p, const Vec2<double>& q, const Vec2<double>& r) {
  const double area = cross<double>(q - p, r - p) / 2;
  const double sides = (q - p).squaredNorm() + (r - q).squaredNorm() + (p - r).squaredNorm();
  return {area, (p + q + r) / 3, area * sides / 36};
}

/// The strip of width `radius` outside the edge from p to q, whose outward normal is n.
MassProperties strip(const Vec2<double>& p, const Vec2<double>& q, const Vec2<double>& n, double radius) {
  const double length = (q - p).norm();
  const double area = length * radius;
  return {area, (p + q + radius * n) / 2, area * (length * length + radius * radius) / 12};
}

/// The circular sector around `apex` between the unit vectors `from` and `to` (less than half a turn).
MassProperties sector(const Vec2<double>& apex, const Vec2<double>& from, const Vec2<double>& to,
                      double radius) {
  const double angle = arc_tangent(cross<double>(from, to), from.dot(to));
  const double area = radius * radius * angle / 2;
  if (!(area > 0)) return {};
  // The integral of the unit vector over the angle is (to - from) turned by -90 degrees; the integral of the
  // distance squared over the radius is radius^3 / 3.
  const Vec2<double> arm = -perpendicular<double>(to - from) * (radius * radius * radius / 3) / area;
  const double about_apex = area * radius * radius / 2;
  return {area, apex + arm, about_apex - area * arm.squaredNorm()};
}

MassProperties of(const Circle<double>& shape) {
  const double area = pi * shape.radius * shape.radius;
  return {area, shape.center, area * shape.radius * shape.radius / 2};
}

/// A rectangle and two half discs. A half disc has its centroid 4 r / (3 pi) from its centre.
MassProperties of(const Capsule<double>& shape) {
  const double r = shape.radius;
  const double length = (shape.point2 - shape.point1).norm();
  const double rectangle = 2 * r * length;
  const double disc = pi * r * r;
  const double inertia = rectangle * (length * length + 4 * r * r) / 12 + disc * r * r / 2 +
                         disc * length * length / 4 + 4 * length * r * r * r / 3;
  return {rectangle + disc, (shape.point1 + shape.point2) / 2, inertia};
}

MassProperties of(const Polygon<double>& shape) {
  const int count = shape.vertices.size();
  List<MassProperties> parts;
  for (int i = 1; i + 1 < count; ++i) {
    parts.push_back(triangle(shape.vertices[0], shape.vertices[i], shape.vertices[i + 1]));
  }
  for (int i = 0; i < count; ++i) {
    const int next = (i + 1) % count;
    parts.push_back(strip(shape.vertices[i], shape.vertices[next], shape.normals[i], shape.radius));
    parts.push_back(sector(shape.vertices[next], shape.normals[i], shape.normals[next], shape.radius));
  }
  return combine(parts);
}

MassProperties of(const Segment<double>& shape) { return {0, (shape.point1 + shape.point2) / 2, 0}; }

MassProperties of(const Chain<double>&) { return {}; }

}  // namespace

MassProperties mass_properties(const Shape<double>& shape) {
  return std::visit([](const auto& held) { return of(held); }, shape);
}

MassProperties mass_properties(Span<const Shape<double>> shapes) {
  List<MassProperties> parts;
  parts.reserve(shapes.size());
  for (const Shape<double>& shape : shapes) parts.push_back(mass_properties(shape));
  return combine(parts);
}

}  // namespace cairn
