// Shapes of bodies in pixels: outlines, their common parts, and what is inside.
#include <algorithm>
#include <cmath>
#include <limits>

#include "render/draw_parts.hpp"

namespace cairn::render {
namespace {

constexpr double farthest_point = 1e7;    // [px]
constexpr double farthest_center = 1e11;  // [px] of a body: doubles are 1e-5 px apart there
constexpr double huge_pixels = 1e6;       // [px] here an arc across a picture is straight to half a pixel
constexpr double beyond_view = 12;        // [px] beyond the viewport, where cut edges are not seen
constexpr double deviation = 0.25;        // [px] of a polygon from the circle it stands for
constexpr double most_corners = 96;       // of a circle

bool is_near(const Point& point, double farthest) {
  return std::abs(point.x()) < farthest && std::abs(point.y()) < farthest;
}

bool is_finite_pose(const Pose<double>& pose) {
  return pose.position.allFinite() && std::isfinite(pose.angle);
}

/// So large on the page that the canvas would not draw it whole.
bool is_huge(const Camera& camera, const Pose<double>& pose, const Shape<double>& shape) {
  return !is_near(camera.project(pose.position), huge_pixels) ||
         bounding_radius(shape) * camera.scale > huge_pixels;
}

/// Of a huge circle what is near the viewport: the side of a straight line.
Outline straightened(const Camera& camera, const Point& center, double radius) {
  const Rect& view = camera.viewport;
  const Point middle(view.x + view.width / 2, view.y + view.height / 2);
  const Point outward = (middle - center).normalized();
  const Point edge = center + radius * outward;
  const double far_off = view.width + view.height + 2 * beyond_view;
  const Point sideways_reach = far_off * perpendicular<double>(outward);
  const Point inner = edge - (std::max((edge - middle).dot(outward), 0.0) + 2 * far_off) * outward;
  return {edge - sideways_reach, edge + sideways_reach, inner + sideways_reach, inner - sideways_reach};
}

// Corners of an arc around `center`, from one angle to another [rad].
void append_arc(Outline& outline, const Vec2<double>& center, double radius, double from, double to,
                double scale) {
  const double pixels = std::max(radius * scale, 1.0);
  const double angle = 2 * std::acos(std::max(1 - deviation / pixels, 0.0));
  const double count = std::clamp(std::ceil(std::abs(to - from) / angle), 1.0, most_corners);
  for (double i = 0; i <= count; ++i) {
    const double at = from + (to - from) * i / count;
    outline.emplace_back(center.x() + radius * std::cos(at), center.y() + radius * std::sin(at));
  }
}

double angle_of(const Vec2<double>& v) { return std::atan2(v.y(), v.x()); }

void append(Outline& outline, const Circle<double>& circle, double scale) {
  append_arc(outline, circle.center, circle.radius, 0, 2 * pi, scale);
  outline.pop_back();
}

void append(Outline& outline, const Capsule<double>& capsule, double scale) {
  const double along = angle_of(capsule.point2 - capsule.point1);
  append_arc(outline, capsule.point2, capsule.radius, along - pi / 2, along + pi / 2, scale);
  append_arc(outline, capsule.point1, capsule.radius, along + pi / 2, along + 1.5 * pi, scale);
}

void append(Outline& outline, const Polygon<double>& polygon, double scale) {
  const int count = polygon.vertices.size();
  for (int i = 0; i < count; ++i) {
    if (polygon.radius == 0) {
      outline.push_back(polygon.vertices[i]);
      continue;
    }
    const double from = angle_of(polygon.normals[(i + count - 1) % count]);
    double to = angle_of(polygon.normals[i]);
    if (to < from) to += 2 * pi;
    append_arc(outline, polygon.vertices[i], polygon.radius, from, to, scale);
  }
}

void append(Outline& outline, const Segment<double>& segment, double) {
  outline.push_back(segment.point1);
  outline.push_back(segment.point2);
}

/// A chain is not convex: it is drawn link by link.
void append(Outline&, const Chain<double>&, double) {}

/// Keeps the side of the line through `from` and `to` where side() >= 0.
Outline half(const Outline& outline, const Point& from, const Point& to) {
  const Point run = to - from;
  const auto side = [&](const Point& point) { return cross<double>(run, point - from); };
  Outline kept;
  for (int i = 0; i < outline.size(); ++i) {
    const Point& point = outline[i];
    const Point& next = outline[(i + 1) % outline.size()];
    const double here = side(point);
    const double there = side(next);
    if (here >= 0) kept.push_back(point);
    if ((here >= 0) != (there >= 0)) kept.emplace_back(point + here / (here - there) * (next - point));
  }
  return kept;
}

double distance_to_segment(const Vec2<double>& point, const Vec2<double>& from, const Vec2<double>& to) {
  const Vec2<double> run = to - from;
  const double part = std::clamp((point - from).dot(run) / run.squaredNorm(), 0.0, 1.0);
  return (point - from - part * run).norm();
}

double depth(const Circle<double>& circle, const Vec2<double>& point) {
  return circle.radius - (point - circle.center).norm();
}

double depth(const Capsule<double>& capsule, const Vec2<double>& point) {
  return capsule.radius - distance_to_segment(point, capsule.point1, capsule.point2);
}

double depth(const Polygon<double>& polygon, const Vec2<double>& point) {
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < polygon.vertices.size(); ++i) {
    least = std::min(least, polygon.normals[i].dot(polygon.vertices[i] - point));
  }
  return least + polygon.radius;
}

double depth(const Segment<double>& segment, const Vec2<double>& point) {
  return -distance_to_segment(point, segment.point1, segment.point2);
}

double depth(const Chain<double>& chain, const Vec2<double>& point) {
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < chain.link_count(); ++i) {
    least = std::min(least, distance_to_segment(point, chain.point(i), chain.point(i + 1)));
  }
  return -least;
}

}  // namespace

bool is_line(const Shape<double>& shape) {
  return std::holds_alternative<Segment<double>>(shape) || std::holds_alternative<Chain<double>>(shape);
}

bool is_drawable(const Camera& camera, const Pose<double>& pose) {
  return is_finite_pose(pose) && is_near(camera.project(pose.position), farthest_point);
}

bool has_place(const Camera& camera, const Pose<double>& pose) {
  return is_finite_pose(pose) && is_near(camera.project(pose.position), farthest_center);
}

bool is_seen(const Camera& camera, const SnapshotBody& body) {
  if (!has_place(camera, body.pose)) return false;
  const Point center = camera.project(body.pose.position);
  const Rect& view = camera.viewport;
  for (const Shape<double>& shape : body.shapes) {
    const double radius = bounding_radius(shape) * camera.scale + 4;
    if (center.x() + radius >= view.x && center.x() - radius <= view.x + view.width &&
        center.y() + radius >= view.y && center.y() - radius <= view.y + view.height) {
      return true;
    }
  }
  return false;
}

Outline outline_of(const Camera& camera, const Pose<double>& pose, const Shape<double>& shape) {
  if (const auto* circle = std::get_if<Circle<double>>(&shape)) {
    const double radius = circle->radius * camera.scale;
    if (radius > huge_pixels) return straightened(camera, camera.project(pose.world(circle->center)), radius);
  }
  Outline outline;
  std::visit([&](const auto& kind) { append(outline, kind, camera.scale); }, shape);
  for (Point& point : outline) point = camera.project(pose.world(point));
  return outline;
}

Outline common_part(const Outline& a, const Outline& b) {
  if (b.size() < 3) return {};
  Point middle(0, 0);
  for (const Point& point : b) middle += point / static_cast<double>(b.size());
  Outline part = a;
  for (int i = 0; i < b.size() && part.size() > 2; ++i) {
    const Point& from = b[i];
    const Point& to = b[(i + 1) % b.size()];
    const bool turns_left = cross<double>(to - from, middle - from) >= 0;
    part = turns_left ? half(part, from, to) : half(part, to, from);
  }
  return part.size() > 2 ? part : Outline{};
}

Outline clipped(const Outline& outline, const Rect& rect) {
  Outline corners;
  corners.emplace_back(rect.x, rect.y);
  corners.emplace_back(rect.x + rect.width, rect.y);
  corners.emplace_back(rect.x + rect.width, rect.y + rect.height);
  corners.emplace_back(rect.x, rect.y + rect.height);
  return common_part(outline, corners);
}

double area(const Outline& outline) {
  double twice = 0;
  for (int i = 0; i < outline.size(); ++i) {
    twice += cross<double>(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
  }
  return std::abs(twice) / 2;
}

void paint_shape(Canvas& canvas, const Camera& camera, const Pose<double>& pose, const Shape<double>& shape,
                 const Paint& paint) {
  if (!is_line(shape) && is_huge(camera, pose, shape)) {
    const Outline part = clipped(outline_of(camera, pose, shape), inset(camera.viewport, -beyond_view));
    if (part.size() > 2) canvas.polygon(part, paint);
  } else if (const auto* circle = std::get_if<Circle<double>>(&shape)) {
    canvas.circle(camera.project(pose.world(circle->center)), circle->radius * camera.scale, paint);
  } else if (const auto* capsule = std::get_if<Capsule<double>>(&shape)) {
    canvas.capsule(camera.project(pose.world(capsule->point1)), camera.project(pose.world(capsule->point2)),
                   capsule->radius * camera.scale, paint);
  } else if (const auto* polygon = std::get_if<Polygon<double>>(&shape)) {
    Outline corners;
    for (int i = 0; i < polygon->vertices.size(); ++i) {
      corners.push_back(camera.project(pose.world(polygon->vertices[i])));
    }
    canvas.polygon(corners, paint, polygon->radius * camera.scale);
  } else if (const auto* segment = std::get_if<Segment<double>>(&shape)) {
    canvas.line(camera.project(pose.world(segment->point1)), camera.project(pose.world(segment->point2)),
                {.width = 1.5 * paint.outline_width, .color = paint.outline});
  } else if (const auto* chain = std::get_if<Chain<double>>(&shape)) {
    paint_chain(canvas, camera, pose, *chain, paint);
  }
}

double depth_in(const Shape<double>& shape, const Vec2<double>& local) {
  return std::visit([&](const auto& kind) { return depth(kind, local); }, shape);
}

double depth_in(const SnapshotBody& body, const Vec2<double>& local) {
  double deepest = -std::numeric_limits<double>::max();
  for (const Shape<double>& shape : body.shapes) deepest = std::max(deepest, depth_in(shape, local));
  return deepest;
}

double reach(const SnapshotBody& body, const Vec2<double>& direction) {
  const Vec2<double> center(0, 0);
  double longest = 0;
  for (const Shape<double>& shape : body.shapes) {
    if (!(depth_in(shape, center) > 0)) continue;
    double inside = 0;
    double outside = bounding_radius(shape) * 1.01;
    // Shapes are convex: halving finds the one place where the ray leaves.
    for (int i = 0; i < 40; ++i) {
      const double middle = (inside + outside) / 2;
      (depth_in(shape, middle * direction) > 0 ? inside : outside) = middle;
    }
    longest = std::max(longest, inside);
  }
  return longest;
}

const SnapshotBody* body_of(const Snapshot& snapshot, BodyId id) {
  const bool is_there = id.index >= 0 && id.index < snapshot.bodies.size();
  return is_there ? &snapshot.bodies[id] : nullptr;
}

}  // namespace cairn::render
