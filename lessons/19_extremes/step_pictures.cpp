// Four worlds on one page, each with its stamp.
#include "lesson.hpp"

#include "render/lint.hpp"

namespace cairn::edges {

namespace {

/// A word in a box with its left end at a point. @returns its width [px]
double draw_stamp(Page& page, const Point& base, Stamp stamp) {
  TextStyle text = page.tick();
  text.bold = true;
  const Theme& theme = page.theme();
  const FixedList<Color, 4> fills = {theme.panel, theme.penetration, theme.positive, theme.positive};
  const Color fill = fills[static_cast<int>(stamp)];
  text.color = render::ink_on(fill);
  text.halo = fill;
  const std::string word = stamp_text(stamp);
  const double width = page.canvas().text_width(word, text) + 10;
  page.canvas().rect({base.x(), base.y() - 1.05 * text.size, width, 1.45 * text.size},
                     {.fill = fill, .outline = theme.text, .outline_width = page.sizes().axis}, 3);
  page.canvas().text({base.x() + 5, base.y()}, word, text);
  return width;
}

/// A dashed line where the top of a stack belongs, with its height.
void draw_top(Page& page, const Camera& camera, const EdgeCase& edge) {
  const Point left = camera.project({edge.view.lower.x(), edge.top});
  const Point right = camera.project({edge.view.upper.x(), edge.top});
  page.canvas().line(left, right, {.width = 2, .color = page.theme().normal, .dash = {6, 4}});
  TextStyle text = aligned(page.tick(), Align::right);
  page.canvas().text(right + Point(0, 1.3 * text.size), fmt::format("{:g} m", edge.top), text);
}

/// The two pins pull at the body, each towards itself.
void draw_pulls(Page& page, const Camera& camera, const ExtremesRun& run, int step) {
  const double pull = pull_of(run.wall[two_pins], step);
  const double largest = pull_of(run.wall[two_pins], run.settings.steps);
  const ArrowScale scale{.pixels_per_unit = 0.26 * camera.scale / largest, .longest = camera.scale};
  for (const double side : {-1.0, 1.0})
    draw_arrow(page, camera, scale, {.tail = {pins_apart + 0.02 * side, -0.22}, .value = {side * pull, 0}});
}

/// What a share of something is called: 7.3 %, or 227 times.
std::string share_text(double share) {
  if (share < 1e-9) return "0 % of";
  if (share <= 9.995) return fixed(100 * share, share < 0.0995 ? 1 : 0) + " % of";
  return share < 9999 ? fixed(share, 0) + " times" : "> 9999 times";
}

/// What is measured of a world, in one or two lines.
List<std::string> measured_lines(const ExtremesRun& run, int which, int step) {
  const EdgeCase& edge = run.wall[which];
  const double off = worst(edge.off_by_step, step), energy = worst(edge.energy_by_step, step);
  List<std::string> lines = {fmt::format("off by {} {}", share_text(off), edge.quantity)};
  if (edge.top > 0 && off > 0.001) {
    const auto at = std::max_element(edge.off_by_step.begin(), edge.off_by_step.begin() + step + 1);
    const Snapshot& then = edge.frames[static_cast<int>(at - edge.off_by_step.begin())];
    lines[0] += then.bodies.back().pose.position.y() + 0.5 > edge.top ? ", upwards" : ", downwards";
  }
  if (energy > 0.01) lines.push_back("energy +" + fixed(100 * energy, 1) + " %");
  if (which == two_pins)
    lines.push_back(fmt::format("each pulls: {} kN", significant(pull_of(edge, step) / 1000, 3)));
  return lines;
}

void draw_edge(Page& page, const Rect& rect, const ExtremesRun& run, int which, int step) {
  const EdgeCase& edge = run.wall[which];
  const bool is_cut = edge.top > edge.view.upper.y() - edge.view.lower.y();
  const Rect inside = page.panel(rect, edge.name + (is_cut ? ", its upper end" : ""));
  const double line = 1.5 * page.sizes().tick;
  const Rect view = {inside.x, inside.y, inside.width, inside.height - 2 * line - 2};
  const Camera camera = fit(view, edge.view);
  const Snapshot& now = edge.frames[step];
  page.canvas().push_clip(view);
  if (which < 2) draw_boxes(page, camera, now, which == 0 ? run.settings.ratio : 1 / run.settings.ratio);
  if (which >= 2) draw_world(page, camera, now, {.numbers = false, .contacts = false, .penetration = false});
  if (which == two_pins) draw_pulls(page, camera, run, step);
  if (edge.top > 0) draw_top(page, camera, edge);
  page.canvas().pop_clip();
  const double base = inside.y + inside.height - 0.35 * page.sizes().tick;
  const List<std::string> lines = measured_lines(run, which, step);
  for (int i = 0; i < lines.size(); ++i)
    page.canvas().text({inside.x, base - (1 - i) * line}, lines[i], page.tick());
  const Stamp stamp = stamp_of(edge, step);
  TextStyle bold = page.tick();
  bold.bold = true;
  const double width = page.canvas().text_width(stamp_text(stamp), bold) + 10;
  draw_stamp(page, {inside.x + inside.width - width, base}, stamp);
}

/// Every stamp with its rule, in one line.
void draw_rules(Page& page, const Rect& rect) {
  const FixedList<std::string, 4> rules = {"off by at most 1 %", "by at most its own size",
                                           "the same, and a joint pulls ever harder",
                                           "by more, or energy up by over 1 %"};
  double x = rect.x;
  for (int i = 0; i < rules.size(); ++i) {
    const double base = rect.y + 1.1 * page.sizes().tick;
    x += draw_stamp(page, {x, base}, static_cast<Stamp>(i)) + 6;
    page.canvas().text({x, base}, rules[i], page.tick());
    x += page.canvas().text_width(rules[i], page.tick()) + 16;
  }
}

void draw_wall(Page& page, const ExtremesRun& run, int step) {
  const List<Rect> lines = in_rows(page, {1, 1, 0.08});
  draw_rules(page, lines[2]);
  for (int i = 0; i < run.wall.size(); ++i) {
    const List<Rect> panels = in_columns(page, lines[i / 2], {1, 1});
    draw_edge(page, panels[i % 2], run, i, step);
  }
}

Shot wall_shot(const ExtremesRun& run, int step) {
  std::string alt = fmt::format("Four small worlds after step {}:", step);
  for (const EdgeCase& edge : run.wall)
    alt += fmt::format(" {}: {};", edge.name, stamp_text(stamp_of(edge, step)));
  alt.back() = '.';
  return {.state = fmt::format("four worlds · step {}", step),
          .alt = alt,
          .draw = [&run, step](Page& page) { draw_wall(page, run, step); },
          .key = step == 3 || step == 10 || step == run.settings.steps};
}

}  // namespace

List<Shot> wall_shots(const ExtremesRun& run) {
  List<Shot> shots;
  for (int step = 0; step <= run.settings.steps; ++step) shots.push_back(wall_shot(run, step));
  return shots;
}

}  // namespace cairn::edges
