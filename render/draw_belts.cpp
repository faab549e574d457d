// Surfaces that run, with marks along the outline that go with it from frame to frame; and those that hold
// off only what comes from one side, with marks that point there.
#include <algorithm>
#include <cmath>

#include "render/draw_parts.hpp"

namespace cairn::render {
namespace {

constexpr double pitch = 26;       // [px] from a mark to the next
constexpr double inside = 6;       // [px] from the outline to a mark
constexpr double half_mark = 3.5;  // [px]
constexpr double margin = 20;      // [px] beyond the viewport, where marks are not seen

/// An edge of an outline, passed in the direction in which its surface runs.
struct Edge {
  Point from = {0, 0};
  Point along = {1, 0};    // unit
  Point outward = {0, 1};  // unit
  double length = 0;       // [px]
  int number = 0;          // of the shape's outline
};

/// [px] The part of the edge that may be seen; first above last: none.
std::pair<double, double> seen_part(const Edge& edge, const Rect& view) {
  double first = 0, last = edge.length;
  const double low[] = {view.x - margin, view.y - margin};
  const double high[] = {view.x + view.width + margin, view.y + view.height + margin};
  for (int k = 0; k < 2; ++k) {
    const double step = edge.along[k];
    if (std::abs(step) < 1e-9) {
      if (edge.from[k] < low[k] || edge.from[k] > high[k]) return {1, 0};
      continue;
    }
    const double to_low = (low[k] - edge.from[k]) / step, to_high = (high[k] - edge.from[k]) / step;
    first = std::max(first, std::min(to_low, to_high));
    last = std::min(last, std::max(to_low, to_high));
  }
  return {first, last};
}

/// Of a convex outline in pixels. A surface that runs to the right where it faces up runs clockwise.
List<Edge> edges_of(Outline outline, bool clockwise) {
  double twice_area = 0;  // in pixels, y down, clockwise outlines have a positive one
  for (int i = 0; i < outline.size(); ++i) {
    const Point &one = outline[i], &next = outline[(i + 1) % outline.size()];
    twice_area += one.x() * next.y() - one.y() * next.x();
  }
  const bool turns_round = (twice_area > 0) != clockwise;
  if (turns_round) std::reverse(outline.begin(), outline.end());
  List<Edge> edges;
  for (int i = 0; i < outline.size(); ++i) {
    const Point way = outline[(i + 1) % outline.size()] - outline[i];
    const double length = way.norm();
    if (!(length > 0)) continue;
    const Point along = way / length;
    const Point right(along.y(), -along.x());  // of the way in pixels, y down: its left
    edges.push_back({outline[i], along, clockwise ? right : Point(-right), length,
                     turns_round ? (2 * outline.size() - 2 - i) % outline.size() : i});
  }
  return edges;
}

void draw_mark(Canvas& canvas, const Edge& edge, double at, const Stroke& stroke) {
  const Point tip = edge.from + at * edge.along - inside * edge.outward + half_mark * edge.along;
  const Point back = tip - 2 * half_mark * edge.along;
  canvas.line(back + half_mark * edge.outward, tip, stroke);
  canvas.line(back - half_mark * edge.outward, tip, stroke);
}

}  // namespace

void draw_belt(Page& page, const Camera& camera, const SnapshotBody& body, BodyId id, double time) {
  if (body.surface_speed == 0 || !has_place(camera, body.pose)) return;
  const Stroke stroke{.width = 1.5, .color = page.theme().outline};
  const double way = std::fmod(std::abs(body.surface_speed) * time * camera.scale, pitch);
  for (const Shape<double>& shape : body.shapes) {
    if (is_line(shape)) continue;
    double passed = 0;  // [px] of the outline, before the edge
    for (const Edge& edge : edges_of(outline_of(camera, body.pose, shape), body.surface_speed > 0)) {
      const auto [first, last] = seen_part(edge, camera.viewport);
      const bool looks_out = id != ground || -edge.outward.y() > 0.1;  // of the ground what looks up
      const bool is_drawn = looks_out && !is_seam(body, shape, edge.number);
      const double begin = std::ceil((first + passed - way) / pitch) * pitch + way - passed;
      if (is_drawn)
        for (double at = begin; at <= last; at += pitch) draw_mark(page.canvas(), edge, at, stroke);
      passed += edge.length;
    }
  }
}

void draw_one_way(Page& page, const Camera& camera, const SnapshotBody& body) {
  if (body.filter.one_way.isZero(0) || !has_place(camera, body.pose)) return;
  const Vec2<double> outwards = Rotation<double>(body.pose.angle) * body.filter.one_way.normalized();
  const Point direction(outwards.x(), -outwards.y());
  const Stroke stroke{.width = 1.5, .color = page.theme().outline};
  for (const Shape<double>& shape : body.shapes) {
    for (Edge edge : edges_of(outline_of(camera, body.pose, shape), true)) {
      if (!(edge.outward.dot(direction) > 0.5)) continue;
      const auto [first, last] = seen_part(edge, camera.viewport);
      const double marks = std::max(1.0, std::floor(edge.length / pitch));
      const double begin = edge.length / marks / 2;
      // Turned, a mark of a belt points outwards.
      for (double at = begin; at <= std::min(last, edge.length); at += edge.length / marks) {
        if (at < first) continue;
        const Point middle = edge.from + at * edge.along - inside * direction;
        draw_mark(page.canvas(),
                  {middle + inside * perpendicular<double>(direction), direction,
                   perpendicular<double>(direction), 0},
                  0, stroke);
      }
    }
  }
}

}  // namespace cairn::render
