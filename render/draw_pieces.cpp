// Bodies whose outline was cut into pieces: the outline as a whole, and the seams as thin lines.
#include <map>
#include <utility>

#include "render/draw_parts.hpp"

namespace cairn::render {
namespace {

constexpr double seam_width = 1;  // [px]

using Place = std::pair<double, double>;  // [m] a corner: pieces that share one have the same numbers
using Edges = std::map<std::pair<Place, Place>, const Polygon<double>*>;

Place place_of(const Vec2<double>& corner) { return {corner.x(), corner.y()}; }

Point on_page(const Camera& camera, const SnapshotBody& body, const Place& place) {
  return camera.project(body.pose.world(Vec2<double>(place.first, place.second)));
}

Edges edges_of(const SnapshotBody& body) {
  Edges edges;
  for (const Shape<double>& shape : body.shapes) {
    if (!is_piece(shape)) continue;
    const auto& polygon = std::get<Polygon<double>>(shape);
    for (const int i : polygon.vertices.indices()) {
      const Vec2<double>& next = polygon.vertices[(i + 1) % polygon.vertices.size()];
      edges[{place_of(polygon.vertices[i]), place_of(next)}] = &polygon;
    }
  }
  return edges;
}

}  // namespace

bool is_seam(const SnapshotBody& body, const Shape<double>& shape, int edge) {
  if (!is_piece(shape)) return false;
  const List<Vec2<double>>& corners = std::get<Polygon<double>>(shape).vertices;
  const Place from = place_of(corners[edge]), to = place_of(corners[(edge + 1) % corners.size()]);
  return edges_of(body).contains({to, from});
}

void draw_outlines(Canvas& canvas, const Camera& camera, const SnapshotBody& body, const Stroke& stroke) {
  const Edges edges = edges_of(body);
  std::map<Place, Place> ways;  // along outlines
  for (const auto& [edge, piece] : edges) {
    const auto& [from, to] = edge;
    if (!edges.contains({to, from})) {
      ways[from] = to;
    } else if (from < to) {
      canvas.line(on_page(camera, body, from), on_page(camera, body, to),
                  {.width = seam_width, .color = stroke.color});
    }
  }
  while (!ways.empty()) {
    Outline loop;
    Place at = ways.begin()->first;
    for (auto next = ways.find(at); next != ways.end(); next = ways.find(at)) {
      loop.push_back(on_page(camera, body, at));
      at = next->second;
      ways.erase(next);
    }
    loop.push_back(loop[0]);
    loop.push_back(loop[1]);  // the first corner is joined as the others are
    canvas.polyline(loop, stroke);
  }
}

}  // namespace cairn::render
