// Towers with bars beside them.
#include "lessons/kit/tower_panel.hpp"

#include <algorithm>

#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn {

namespace {

using render::Page;
using render::Point;
using render::Rect;

void draw_load_bars(Page& page, const render::Camera& camera, double right, const Snapshot& tower,
                    const List<double>& loads, const LoadBars& bars) {
  const double left = camera.project({0.5, 0}).x() + 14;
  const double per_newton = (right - left) / bars.largest;
  const double thickness = std::clamp(0.42 * camera.scale, 2.0, 12.0);
  const int boxes = loads.size();
  for (int i = 0; i < boxes; ++i) {
    const double y = camera.project({0, tower.bodies[{i + 1}].pose.position.y()}).y();
    const double length = std::max(0.0, loads[i] * per_newton);
    if (!bars.least.empty()) {
      const double from = bars.least[i] * per_newton, to = bars.most[i] * per_newton;
      page.canvas().rect({left + from, y - 0.8 * thickness, to - from, 1.6 * thickness},
                         {.fill = render::faded(bars.color, 0.25)});
    }
    page.canvas().rect({left, y - thickness / 2, length, thickness},
                       {.fill = bars.color, .outline = page.theme().outline, .outline_width = 1});
    const double tick = left + static_cast<double>(boxes - i) * bars.box_weight * per_newton;
    page.canvas().line({tick, y - thickness}, {tick, y + thickness},
                       {.width = 2, .color = page.theme().exact.color});
  }
}

/// Whether a box has come down by a fifth of its height upon the one below.
bool is_sunk(const Snapshot& tower) {
  for (int i = 2; i < tower.bodies.size(); ++i) {
    const double rise = tower.bodies[{i}].pose.position.y() - tower.bodies[{i - 1}].pose.position.y();
    if (rise < 0.8) return true;
  }
  return false;
}

}  // namespace

render::Camera draw_tower_loads(Page& page, const Rect& view, const Snapshot& tower,
                                const List<double>& loads, const LoadBars& bars) {
  const auto boxes = static_cast<double>(loads.size());
  render::Camera camera = render::fit(view, {{-1.2, -0.6}, {1.2, boxes + 0.4}});
  camera.center.x() = 0.5 * view.width / camera.scale - 1.2;  // the tower at the left
  render::WorldLook look;
  look.contacts = false;
  // In lower boxes those of two digits would be missing, and in a tower that has sunk edges would cross them.
  look.numbers = camera.scale >= (boxes < 10 ? 20 : 27) && !is_sunk(tower);
  look.penetration = false;
  draw_world(page, camera, tower, look);
  draw_load_bars(page, camera, view.x + view.width, tower, loads, bars);
  return camera;
}

Rect draw_solver_panel(Page& page, const Rect& rect, const render::SeriesStyle& style,
                       const std::string& name, const std::string& number) {
  const Rect inside = page.panel(rect, "");
  page.canvas().rect({rect.x, rect.y, rect.width, 6}, {.fill = style.color});
  render::TextStyle left = page.label();
  left.bold = true;
  const double line = left.size * 1.2;
  render::draw_marker(page.canvas(), {inside.x + 6, inside.y + line - 0.35 * left.size}, style.marker,
                      page.sizes().marker, style.color);
  page.canvas().text({inside.x + 18, inside.y + line}, name, left);
  render::TextStyle right = page.value();
  right.align = render::Align::right;
  page.canvas().text({inside.x + inside.width, inside.y + line}, number, right);
  const double top = inside.y + line + 10;
  return {inside.x, top, inside.width, inside.y + inside.height - top};
}

}  // namespace cairn
