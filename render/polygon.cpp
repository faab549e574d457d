// Convex polygons: sharp, rounded and hatched. Every vertex carries the exact distances to up to four edges,
// so that corners stay sharp and thin polygons keep their weight.
#include <algorithm>
#include <cmath>

#include <cairn/math/list.hpp>
#include "render/shapes.hpp"

namespace cairn::render {
namespace {

constexpr double same_point = 1e-6;  // [px]
constexpr double no_edge = -1e3;     // [px], a distance that leaves every pixel whole
constexpr double longest_miter =
    8;  // in margins; beyond it the hull ends square, where coverage is almost nothing

/// A convex polygon without doubled points, so turned that the outside is where `distance` is positive.
struct Outline {
  List<Point> points = {};
  List<Point> normals = {};  // outward unit normal of the edge from point i to point i + 1
  Point center = Point::Zero();

  int size() const { return points.size(); }
  int next(int i) const { return (i + 1) % size(); }
  int previous(int i) const { return (i + size() - 1) % size(); }
};

double signed_area(Span<const Point> points) {
  double twice = 0;
  for (int i = 2; i < points.size(); ++i) {
    const Point first = points[i - 1] - points[0];
    const Point second = points[i] - points[0];
    twice += cross(first, second);
  }
  return 0.5 * twice;
}

Outline outline_of(Span<const Point> points) {
  Outline outline;
  for (const Point& point : points) {
    if (outline.points.empty() || (point - outline.points.back()).norm() > same_point) {
      outline.points.push_back(point);
    }
  }
  while (outline.size() > 1 && (outline.points.back() - outline.points.front()).norm() <= same_point) {
    outline.points.pop_back();
  }
  if (signed_area(outline.points) < 0) {
    std::reverse(outline.points.begin(), outline.points.end());
  }
  for (int i = 0; i < outline.size(); ++i) {
    const Point edge = outline.points[outline.next(i)] - outline.points[i];
    outline.normals.push_back(-perpendicular(edge) / edge.norm());
    outline.center += outline.points[i] / static_cast<double>(outline.size());
  }
  return outline;
}

/// Distance to edge i, less the rounding.
Affine distance(const Outline& outline, int i, double rounding) {
  const Point& normal = outline.normals[i];
  return {normal.x(), normal.y(), -normal.dot(outline.points[i]) - rounding};
}

/// The interior angle at which edges i and k meet, or would meet [pi].
float interior_angle(const Outline& outline, int i, int k) {
  const double cosine = std::clamp(outline.normals[i].dot(outline.normals[k]), -1.0, 1.0);
  return static_cast<float>(1 - std::acos(cosine) / pi);
}

/// Where the edges at point i meet when they lie `margin` further out; near point i if that is very far away.
Point moved_out(const Outline& outline, int i, double margin) {
  const Point sum = outline.normals[outline.previous(i)] + outline.normals[i];
  const double stretch = std::max(0.5 * sum.squaredNorm(), 2 / (longest_miter * longest_miter));
  return outline.points[i] + margin / stretch * sum;
}

/// The corners at point i of a hull `margin` further out: one, or two that cut off a very sharp tip.
void add_hull_corner(List<Point>& hull, const Outline& outline, int i, double margin) {
  const Point& before = outline.normals[outline.previous(i)];
  const Point& after = outline.normals[i];
  if ((before + after).norm() > 2 / longest_miter) {
    hull.push_back(moved_out(outline, i, margin));
    return;
  }
  const Point forwards = perpendicular(before);  // towards the tip on one side of it, and on the other
  const Point backwards = -perpendicular(after);
  hull.push_back(outline.points[i] + margin * (before + longest_miter * forwards));
  hull.push_back(outline.points[i] + margin * (after + longest_miter * backwards));
}

/// Up to four edges fit one measure. `edges` holds the own edge second, its neighbours first and third.
Measure measure_of(const Outline& outline, Span<const int> edges, double rounding) {
  Measure measure = {};
  measure.kind = Kind::polygon;
  for (int k = 0; k < 4; ++k) {
    measure.local[k] = {0, 0, no_edge};
    if (k < edges.size()) {
      measure.local[k] = distance(outline, edges[k], rounding);
      measure.shape[k] = interior_angle(outline, edges[k], edges[(k + 1) % edges.size()]);
    }
  }
  // Opposite edges of a quadrilateral share nothing; the first and third of a triangle are neighbours.
  if (edges.size() == 3) {
    measure.first[0] = interior_angle(outline, edges[0], edges[2]);
  }
  return measure;
}

/// The edge that faces edge i across the polygon.
int facing(const Outline& outline, int i) {
  int best = i;
  for (int k = 0; k < outline.size(); ++k) {
    if (outline.normals[k].dot(outline.normals[i]) < outline.normals[best].dot(outline.normals[i])) {
      best = k;
    }
  }
  return best;
}

struct Style {
  Measure look = {};    // kind, colours and pattern; the distances are filled in
  double rounding = 0;  // [px]
  double margin = 0;    // of the hull around the points [px]
};

void add_piece(Batch& batch, Span<const Point> hull, Measure measure, const Style& style) {
  measure.kind = style.look.kind;
  measure.second = style.look.second;
  measure.fill = style.look.fill;
  measure.outline = style.look.outline;
  measure.half_outline = style.look.half_outline;
  batch.add(hull, measure);
}

/// A polygon of up to four edges in one piece.
void add_whole(Batch& batch, const Outline& outline, const Style& style) {
  List<Point> hull;
  for (int i = 0; i < outline.size(); ++i) {
    if (style.rounding > 0) {
      hull.push_back(outline.points[i]);  // the outer pieces begin here
    } else {
      add_hull_corner(hull, outline, i, style.margin);
    }
  }
  constexpr FixedList<int, 4> all = {0, 1, 2, 3};
  add_piece(batch, hull, measure_of(outline, Span<const int>(all.data(), outline.size()), style.rounding),
            style);
}

/// A polygon of more edges, as a fan around its centre.
void add_fan(Batch& batch, const Outline& outline, const Style& style) {
  const auto corner = [&](int i) -> Point {
    return style.rounding > 0 ? outline.points[i] : moved_out(outline, i, style.margin);
  };
  for (int i = 0; i < outline.size(); ++i) {
    const FixedList<Point, 3> triangle = {outline.center, corner(i), corner(outline.next(i))};
    const FixedList<int, 4> edges = {outline.previous(i), i, outline.next(i), facing(outline, i)};
    const bool apart = edges[3] != edges[0] && edges[3] != edges[2];
    Measure measure = measure_of(outline, Span<const int>(edges.data(), apart ? 4 : 3), style.rounding);
    measure.first[0] = interior_angle(outline, edges[0], edges[2]);
    add_piece(batch, triangle, measure, style);
  }
}

void add_inside(Batch& batch, const Outline& outline, const Style& style) {
  if (outline.size() <= 4) {
    add_whole(batch, outline, style);
  } else {
    add_fan(batch, outline, style);
  }
}

/// The strip outside edge i.
void add_strip(Batch& batch, const Outline& outline, int i, const Style& style) {
  const Point& from = outline.points[i];
  const Point& to = outline.points[outline.next(i)];
  const Point out = style.margin * outline.normals[i];
  const FixedList<Point, 4> hull = {from, from + out, to + out, to};
  const FixedList<int, 1> edge = {i};
  add_piece(batch, hull, measure_of(outline, edge, style.rounding), style);
}

/// The wedge outside point i, between the strips, where the point itself is nearest.
void add_wedge(Batch& batch, const Outline& outline, int i, const Style& style) {
  const Point& tip = outline.points[i];
  const Point first = style.margin * outline.normals[outline.previous(i)];
  const Point last = style.margin * outline.normals[i];
  Point middle = first + last;
  // At a point that turns back by nearly half a turn the sum vanishes; straight on is the edge's own
  // direction.
  middle = middle.norm() > same_point ? Point(style.margin * middle.normalized()) : perpendicular(first);
  const auto corner = [&](const Point& a, const Point& b) -> Point {
    const Point sum = a + b;
    return tip + 2 * style.margin * style.margin / sum.squaredNorm() * sum;
  };
  const FixedList<Point, 6> hull = {tip,          tip + first,          corner(first, middle),
                                    tip + middle, corner(middle, last), tip + last};
  Measure measure = style.look;
  measure.kind = Kind::box;
  measure.local = {};
  measure.local[0] = {1, 0, -tip.x()};
  measure.local[1] = {0, 1, -tip.y()};
  measure.shape = {0, 0, static_cast<float>(style.rounding), 0};
  batch.add(hull, measure);
}

bool all_usable(Span<const Point> points) {
  return std::all_of(points.begin(), points.end(), [](const Point& point) { return usable(point); });
}

/// A polygon that has collapsed to a line or a point.
void add_collapsed(Batch& batch, Span<const Point> points, const Paint& paint, double rounding) {
  Point from = points.front();
  Point to = points.front();
  for (const Point& point : points) {
    if ((point - from).norm() > (to - from).norm()) {
      to = point;
    }
  }
  for (const Point& point : points) {
    if ((point - to).norm() > (from - to).norm()) {
      from = point;
    }
  }
  const Point span = to - from;
  const double length = span.norm();
  Box box = {.center = 0.5 * (from + to), .half_length = 0.5 * length, .radius = rounding};
  if (length > same_point) {
    box.axis = span / length;
  }
  add_box(batch, box, paint);
}

}  // namespace

void add_polygon(Batch& batch, Span<const Point> points, const Paint& paint, double rounding) {
  const double rim = half_outline(paint);
  if (points.empty() || !all_usable(points) || !usable(rounding) || rounding < 0 ||
      (paint.fill.a <= 0 && rim <= 0)) {
    return;
  }
  const Outline outline = outline_of(points);
  if (outline.size() < 3 || std::abs(signed_area(outline.points)) < same_point) {
    add_collapsed(batch, points, paint, rounding);
    return;
  }
  Style style = {.rounding = rounding, .margin = rounding + rim + 1};
  style.look.kind = Kind::polygon;
  style.look.fill = paint.fill;
  style.look.outline = paint.outline;
  style.look.half_outline = rim;
  add_inside(batch, outline, style);
  for (int i = 0; rounding > 0 && i < outline.size(); ++i) {
    add_strip(batch, outline, i, style);
    add_wedge(batch, outline, i, style);
  }
}

void add_hatch(Batch& batch, Span<const Point> points, const Stroke& stroke, double pitch) {
  if (points.size() < 3 || !all_usable(points) || !usable(pitch) || !(pitch > 0) || !(stroke.width > 0)) {
    return;
  }
  const Outline outline = outline_of(points);
  if (outline.size() < 3 || std::abs(signed_area(outline.points)) < same_point) {
    return;
  }
  Style style = {.rounding = 0, .margin = 1};
  style.look.kind = Kind::hatch;
  style.look.fill = stroke.color;
  // The lines start from the first point: they go with the shape when it moves.
  const double phase = std::fmod(points[0].x() + points[0].y(), pitch);
  style.look.second = {static_cast<float>(pitch), static_cast<float>(0.5 * stroke.width),
                       static_cast<float>(phase)};
  add_inside(batch, outline, style);
}

}  // namespace cairn::render
