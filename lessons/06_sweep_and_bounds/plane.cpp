// The plane of two lambda: where they may be, where each row is satisfied, and the way of Gauss-Seidel.
#include "lesson.hpp"

namespace cairn::sweeps {

namespace {

using Pair = FixedList<double, 2>;

/// Where a lambda would be negative: hatched as what nothing can enter.
void draw_forbidden(Page& page, const Camera& camera) {
  const Rect& view = camera.viewport;
  const Point origin = camera.project({0, 0});
  const auto block = [&page](const Rect& r) {
    if (!(r.width > 0) || !(r.height > 0)) return;
    const FixedList<Point, 4> corners = {Point(r.x, r.y), Point(r.x + r.width, r.y),
                                         Point(r.x + r.width, r.y + r.height), Point(r.x, r.y + r.height)};
    page.canvas().polygon(corners, {.fill = faded(page.theme().static_body, 0.35)});
    page.canvas().hatch(corners, {.width = 1, .color = faded(page.theme().static_hatch, 0.3)},
                        2 * page.sizes().hatch_pitch);
  };
  const double bottom = view.y + view.height;
  block({view.x, view.y, origin.x() - view.x, view.height});
  block({origin.x(), origin.y(), view.x + view.width - origin.x(), bottom - origin.y()});
  const Stroke axis{.width = page.sizes().axis, .color = page.theme().outline};
  page.canvas().line({view.x, origin.y()}, {view.x + view.width, origin.y()}, axis);
  page.canvas().line({origin.x(), view.y}, {origin.x(), bottom}, axis);
  page.avoid({{view.x, origin.y()}, {view.x + view.width, origin.y()}});
  page.avoid({{origin.x(), view.y}, {origin.x(), bottom}});
}

TextStyle plane_text(const Page& page) {
  TextStyle style = page.secondary();
  style.halo = page.theme().panel;
  return style;
}

/// Where row `i` is satisfied, A_i1 lambda_1 + A_i2 lambda_2 = b_i: from there so many pixels along the line.
Point on_row_line(const Camera& camera, const RodRun& rod, int i, double pixels) {
  const Matrix<double>& A = rod.system.A;
  const Vec2<double> along = Vec2<double>(-A(i, 1), A(i, 0)).normalized();
  return camera.project(Vec2<double>(rod.statics[0], rod.statics[1]) + pixels / camera.scale * along);
}

void draw_row_line(Page& page, const Camera& camera, const RodRun& rod, int i) {
  const Point from = on_row_line(camera, rod, i, -2000), to = on_row_line(camera, rod, i, 2000);
  page.canvas().line(from, to, {.width = 1.5, .color = page.theme().secondary_text, .dash = {8, 6}});
  page.avoid({from, to});
}

/// Beside its line, wherever there is room.
void name_row_line(Page& page, const Camera& camera, const RodRun& rod, int i) {
  const TextStyle style = plane_text(page);
  const std::string text = fmt::format("row {}", i + 1);
  const double width = page.canvas().text_width(text, style);
  List<Point> places;
  for (int step = 0; step < 1200; ++step) {  // near the crossing of both lines, or else ever farther below it
    const int pixels = step < 160 ? 6 * step - 480 : 480 - 6 * step;
    const Point at = on_row_line(camera, rod, i, pixels) + Point(0, style.size / 3);
    if (rod.tips() && (at - camera.project({rod.formula[0], rod.formula[1]})).norm() < 120) continue;
    places.push_back(at + Point(10, 0));
    places.push_back(at - Point(10 + width, 0));
  }
  page.place_text(places, inset(camera.viewport, 4), text, style);
}

/// Values along both axes, on the side where nothing may be, from 0 on; the ring of the answer has its own.
void write_ticks(Page& page, const Camera& camera, const Pair& ring) {
  const Rect room = inset(camera.viewport, 4);
  const Vec2<double> far = camera.unproject({room.x + room.width, room.y});
  TextStyle style = plane_text(page);
  style.color = page.theme().secondary_text;
  for (const bool upward : {false, true}) {
    const double end = upward ? far.y() : far.x();
    for (const double value : render::round_ticks(0, end, upward ? 5 : 3)) {
      if (upward && (value == 0 || std::abs(value - ring[1]) * camera.scale < style.size)) continue;
      const Point at = camera.project(upward ? Vec2<double>(0, value) : Vec2<double>(value, 0));
      const Point side = upward ? Point(-6, 0) : Point(0, 6);
      page.canvas().line(at, at + side, {.width = page.sizes().axis, .color = page.theme().outline});
      style.align = upward ? Align::right : Align::center;
      const Point words = at + (upward ? Point(-10, style.size / 3) : Point(0, 8 + style.size));
      page.place_text({words}, room, brief(value), style);
    }
  }
}

void draw_way(Page& page, const Camera& camera, const List<Pair>& way, const SeriesStyle& style,
              double width) {
  List<Point> points;
  for (const Pair& stop : way) points.push_back(camera.project({stop[0], stop[1]}));
  page.canvas().polyline(points, {.width = width, .color = style.color});
  for (const Point& point : points) {
    draw_marker(page.canvas(), point, style.marker, page.sizes().marker * 0.8, style.color);
  }
  page.avoid(points);
}

/// "(−20, 60)" beside a ring.
void draw_goal(Page& page, const Camera& camera, const Pair& at, bool lit) {
  const Point point = camera.project({at[0], at[1]});
  const Color color = lit ? page.theme().exact.color : page.theme().secondary_text;
  page.canvas().circle(point, page.sizes().joint + 2,
                       {.outline = color, .outline_width = page.sizes().outline});
  TextStyle style = plane_text(page);
  style.color = page.theme().text;
  const std::string text = fmt::format("({}, {})", brief(at[0], 1), brief(at[1], 1));
  const double width = page.canvas().text_width(text, style);
  const double away = page.sizes().joint + 8;
  List<Point> places;
  for (const double down : {style.size / 3, -away, away + style.size}) {
    for (const double left : {away, -away - width, -width / 2}) places.push_back(point + Point(left, down));
  }
  page.place_text(places, inset(camera.viewport, 4), text, style);
}

/// What the last row asked for, where that is not what it got.
void draw_asked(Page& page, const Camera& camera, const PlaneView& view) {
  if (view.way.empty() || !(std::min(view.asked[0], view.asked[1]) < -1e-9)) return;
  const Point from = camera.project({view.way.back()[0], view.way.back()[1]});
  const Point to = camera.project({view.asked[0], view.asked[1]});
  const Color color = page.theme().pgs.color;
  page.canvas().line(from, to, {.width = 2, .color = color, .dash = {4, 4}});
  page.canvas().circle(to, page.sizes().marker,
                       {.fill = page.theme().panel, .outline = color, .outline_width = 2});
  page.avoid({from, to});
}

void name_pull(Page& page, const Camera& camera) {
  const TextStyle style = plane_text(page);
  const Point origin = camera.project({0, 0});
  const std::string text = "λ_{1} < 0: a pull";
  const double width = page.canvas().text_width(text, style);
  if (camera.viewport.x + width + 24 > origin.x()) return;
  page.canvas().text({camera.viewport.x + 12, origin.y() - 12}, text, style);
}

/// All of the zig-zag without the clamp; closer where only the way with it is shown.
Camera plane_camera(const Rect& rect, const RodRun& rod, bool close) {
  if (close) {
    const double top = rod.formula[1];
    return fit(rect, {{-0.3 * top, -0.12 * top}, {std::max(0.45 * top, 12.0), 1.2 * top}});
  }
  const double left = std::min(0.0, rod.statics[0]);
  const double right = std::max(10.0, rod.statics[0]);
  const double top = std::max(rod.statics[1], rod.formula[1]);
  const double margin = 0.16 * std::max(right - left, top);
  return fit(rect, {{left - margin, -0.8 * margin}, {right + margin, top + margin}});
}

}  // namespace

void draw_plane(Page& page, const Rect& rect, const SweepRun& run, const PlaneView& view) {
  const RodRun& rod = run.rod;
  Rect inside = page.panel(rect, "λ_{1} to the right, λ_{2} up (N)");
  const bool close = rod.tips() && view.other.empty();
  const Camera camera = plane_camera(inside, rod, close);
  page.canvas().push_clip(inside);
  draw_forbidden(page, camera);
  draw_row_line(page, camera, rod, 0);
  draw_row_line(page, camera, rod, 1);
  draw_way(page, camera, view.other, {page.theme().secondary_text, {}, Marker::diamond}, 1.5);
  draw_asked(page, camera, view);
  draw_way(page, camera, view.way, page.theme().pgs, page.sizes().curve);
  if (!close) draw_goal(page, camera, rod.statics, !rod.tips());
  if (rod.tips()) draw_goal(page, camera, rod.formula, true);
  write_ticks(page, camera, rod.formula);
  name_pull(page, camera);
  name_row_line(page, camera, rod, 0);
  name_row_line(page, camera, rod, 1);
  page.canvas().pop_clip();
}

}  // namespace cairn::sweeps
