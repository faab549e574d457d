// A world from its snapshot: what is drawn upon what. Also its past: ghosts and trails.
#include "render/draw.hpp"

#include <algorithm>
#include <cmath>

#include "render/draw_parts.hpp"
#include "render/plot.hpp"

namespace cairn::render {
namespace {

constexpr int most_ghosts = 7;
constexpr double oldest_ghost = 0.25;  // opacity
constexpr double newest_ghost = 0.60;
constexpr double farthest_body = 1e6;  // [m] bodies beyond are no part of the picture
constexpr int trail_markers = 6;
constexpr int most_avoided = 40;  // bodies; where there are more, labels find no room anyway

template <typename Draw>
void for_each_body(const Snapshot& snapshot, Draw draw) {
  for (const BodyId body : snapshot.bodies.indices()) draw(snapshot.bodies[body], body);
}

bool can_move(const SnapshotBody& body) { return body.type == BodyType::dynamic; }

// Evenly chosen, the newest always among them.
List<int> chosen(int count) {
  List<int> all;
  const int shown = std::min(count, most_ghosts);
  for (int i = 0; i < shown; ++i) {
    all.push_back(shown > 1 ? (i * (count - 1) + (shown - 1) / 2) / (shown - 1) : count - 1);
  }
  return all;
}

void include(Aabb<double>& bounds, const Aabb<double>& box) {
  bounds.lower = bounds.lower.cwiseMin(box.lower);
  bounds.upper = bounds.upper.cwiseMax(box.upper);
}

bool is_usable(const Aabb<double>& box) {
  return box.lower.allFinite() && box.upper.allFinite() && box.lower.cwiseAbs().maxCoeff() < farthest_body &&
         box.upper.cwiseAbs().maxCoeff() < farthest_body;
}

// The path in pixels, cut where a point cannot be drawn.
List<List<Point>> pieces_of(const Camera& camera, Span<const Vec2<double>> points) {
  List<List<Point>> pieces(1);
  for (const Vec2<double>& point : points) {
    if (is_drawable(camera, {.position = point, .angle = 0})) {
      pieces.back().push_back(camera.project(point));
    } else if (!pieces.back().empty()) {
      pieces.emplace_back();
    }
  }
  return pieces;
}

// So that labels of arrows rather stand beside bodies than upon their outlines.
void avoid_outlines(Page& page, const Camera& camera, const Snapshot& snapshot) {
  if (snapshot.bodies.size() > most_avoided) return;
  for (const SnapshotBody& body : snapshot.bodies) {
    if (!is_drawable(camera, body.pose)) continue;
    for (const Shape<double>& shape : body.shapes) {
      Outline outline = clipped(outline_of(camera, body.pose, shape), camera.viewport);
      if (outline.empty()) continue;
      outline.push_back(outline.front());
      page.avoid(outline);
    }
  }
}

}  // namespace

void draw_world(Page& page, const Camera& camera, const Snapshot& snapshot, const WorldLook& look) {
  page.canvas().push_clip(camera.viewport);
  draw_fields(page, camera, snapshot);
  for_each_body(snapshot, [&](const SnapshotBody& body, BodyId id) {
    if (!can_move(body)) draw_static_body(page, camera, body, id);
    if (!can_move(body)) draw_belt(page, camera, body, id, snapshot.time);
    if (!can_move(body)) draw_one_way(page, camera, body);
  });
  draw_joint_lines(page, camera, snapshot);
  for_each_body(snapshot, [&](const SnapshotBody& body, BodyId id) {
    if (can_move(body)) draw_dynamic_body(page, camera, body, id, look);
    if (can_move(body)) draw_belt(page, camera, body, id, snapshot.time);
    if (can_move(body)) draw_one_way(page, camera, body);
  });
  draw_joint_ends(page, camera, snapshot);
  draw_broken_joints(page, camera, snapshot);
  for_each_body(snapshot, [&](const SnapshotBody& body, BodyId id) {
    if (can_move(body)) write_name(page, camera, body, id, look);
  });
  draw_outer_forces(page, camera, snapshot);
  avoid_outlines(page, camera, snapshot);
  if (look.penetration) draw_penetrations(page, camera, snapshot);
  if (look.contacts) draw_contacts(page, camera, snapshot, look);
  page.canvas().pop_clip();
}

void draw_ghosts(Page& page, const Camera& camera, Span<const Snapshot> earlier) {
  page.canvas().push_clip(camera.viewport);
  const List<int> shown = chosen(earlier.size());
  for (int i = 0; i < shown.size(); ++i) {
    const double age = shown.size() > 1 ? static_cast<double>(i) / static_cast<double>(shown.size() - 1) : 1;
    const double opacity = oldest_ghost + (newest_ghost - oldest_ghost) * age;
    const Paint paint{.outline = faded(page.theme().outline, opacity), .outline_width = page.sizes().ghost};
    for (const SnapshotBody& body : earlier[shown[i]].bodies) {
      if (!can_move(body) || !is_seen(camera, body)) continue;
      for (const Shape<double>& shape : body.shapes)
        paint_shape(page.canvas(), camera, body.pose, shape, paint);
    }
  }
  page.canvas().pop_clip();
}

void draw_trail(Page& page, const Camera& camera, Span<const Vec2<double>> points, const SeriesStyle& style) {
  Canvas& canvas = page.canvas();
  canvas.push_clip(camera.viewport);
  for (const List<Point>& piece : pieces_of(camera, points)) {
    canvas.polyline(piece, {.width = page.sizes().curve, .color = style.color, .dash = style.dash});
    const int count = std::min(piece.size(), trail_markers);
    for (int i = 0; i < count; ++i) {
      const Point& at = piece[i * (piece.size() - 1) / std::max(count - 1, 1)];
      draw_marker(canvas, at, style.marker, page.sizes().marker, style.color);
    }
    page.note_curve(piece);
  }
  canvas.pop_clip();
}

Aabb<double> bounds_of(Span<const Snapshot> snapshots) {
  std::optional<Aabb<double>> bounds;
  for (const Snapshot& snapshot : snapshots) {
    for (const SnapshotBody& body : snapshot.bodies) {
      if (!can_move(body)) continue;
      for (const Shape<double>& shape : body.shapes) {
        const Aabb<double> box = bounding_box(shape, body.pose);
        if (!is_usable(box)) continue;
        if (!bounds) bounds = box;
        include(*bounds, box);
      }
    }
  }
  return bounds.value_or(Aabb<double>{});
}

}  // namespace cairn::render
