// Chains: a line, with short strokes on the side of its solid.
#include <algorithm>
#include <cmath>

#include "render/draw_parts.hpp"
#include "render/rects.hpp"

namespace cairn::render {
namespace {

constexpr double stroke_pitch = 9;   // [px] from stroke to stroke
constexpr double stroke_length = 8;  // [px]
constexpr double chain_cut = 16;     // [px] beyond the viewport, where nothing is seen

/// Strokes along one link, slanting back into the solid. `passed` [px] is how long the line was before.
void draw_strokes(Canvas& canvas, const Rect& view, const Point& from, const Point& to, double passed,
                  const Stroke& stroke) {
  LineSegment seen{from, to};
  const double length = (to - from).norm();
  if (!(length > 0) || !clip(seen, view)) return;
  const Point along = (to - from) / length;
  const Point solid(along.y(), -along.x());  // on the left hand, where y points down
  const Point slant = stroke_length / std::sqrt(2.0) * (solid - along);
  const double begin = passed + (seen.from - from).norm(), end = passed + (seen.to - from).norm();
  for (double at = std::ceil(begin / stroke_pitch) * stroke_pitch; at < end; at += stroke_pitch) {
    const Point foot = from + (at - passed) * along;
    canvas.line(foot, foot + slant, stroke);
  }
}

}  // namespace

void paint_chain(Canvas& canvas, const Camera& camera, const Pose<double>& pose, const Chain<double>& chain,
                 const Paint& paint) {
  const Rect view = inset(camera.viewport, -chain_cut);
  double passed = 0;
  List<Point> line;
  for (int i = 0; i <= chain.link_count(); ++i) line.push_back(camera.project(pose.world(chain.point(i))));
  for (int i = 0; i + 1 < line.size(); ++i) {
    draw_strokes(canvas, view, line[i], line[i + 1], passed, {.width = 1, .color = paint.outline});
    passed += (line[i + 1] - line[i]).norm();
  }
  canvas.polyline(line, {.width = 1.5 * paint.outline_width, .color = paint.outline});
}

}  // namespace cairn::render
