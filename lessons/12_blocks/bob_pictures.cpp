// A bob with a tiny moment of inertia: where two rows throw it, and where their block keeps it.
#include "lesson.hpp"

namespace cairn::blocks {

namespace {

const double shown_seconds = 1.2;  // step by step; then the end

bool is_inside(const Rect& rect, const Point& point) {
  return point.x() >= rect.x && point.x() <= rect.x + rect.width && point.y() >= rect.y &&
         point.y() <= rect.y + rect.height;
}

void draw_bob(Page& page, const Rect& rect, const BobRun& run, int step, const std::string& name,
              const SeriesStyle& style) {
  const Rect inside = page.panel(rect, name);
  page.canvas().rect({rect.x, rect.y, rect.width, 4}, {.fill = style.color});
  const Camera camera = fit(inside, {{-1.25, -2.7}, {1.7, 1.35}});
  page.canvas().push_clip(inside);
  const Point pin = camera.project({0, 0});
  page.canvas().circle(pin, camera.scale, {.outline = page.theme().inactive, .outline_width = 2});
  TextStyle text = aligned(page.label(), Align::center);
  page.canvas().text(camera.project({0, 1}) - Point(0, 8), "where the pin should hold it", text);
  List<Vec2<double>> path;
  for (int k = 0; k <= step && is_inside(inside, camera.project(run.path[k])); ++k)
    path.push_back(run.path[k]);
  draw_trail(page, camera, path, {style.color, {}, Marker::none});
  const Point bob = camera.project(run.path[step]);
  if (is_inside(inside, bob))
    page.canvas().line(pin, bob, {.width = page.sizes().outline, .color = page.theme().joint});
  page.canvas().circle(
      bob, 0.1 * camera.scale,
      {.fill = page.theme().body, .outline = page.theme().outline, .outline_width = page.sizes().outline});
  page.canvas().circle(
      pin, page.sizes().joint,
      {.fill = page.theme().panel, .outline = page.theme().joint, .outline_width = page.sizes().outline});
  page.canvas().pop_clip();
  if (is_inside(inside, bob)) return;
  text.halo = page.theme().panel;
  page.canvas().text({pin.x(), pin.y() + 0.45 * camera.scale},
                     fmt::format("{} m away", significant(run.path[step].norm(), 2)), text);
}

/// While it begins, the energy as it is; in the end its excess over that of hanging still, in decades.
void draw_energy(Page& page, const Rect& rect, const BlocksRuns& all, int step) {
  const bool soon = step * all.settings.dt <= shown_seconds * (1 + 1e-9);
  Plot plot{.title =
                soon ? "energy (J), 0 at rest at the pin" : "energy above hanging (J); no line: below it"};
  plot.x = {.title = "t (s)", .min = 0, .max = soon ? shown_seconds : all.settings.pin_seconds};
  if (soon) {
    plot.y = {.min = -25, .max = 25};
  } else {
    const double top = 10 * std::max(100.0, all.bob_rows.largest_energy);
    plot.y = {.scale = AxisScale::logarithmic, .min = 0.1, .max = top};
  }
  const auto add = [&](const std::string& name, const BobRun& run, const SeriesStyle& style) {
    Series series{.name = name, .style = style};
    for (int k = 0; k * all.settings.dt <= *plot.x.max + 1e-9 && k < run.energy.size(); ++k)
      series.add(k * all.settings.dt, run.energy[k] + (soon ? 0 : gravity));
    plot.series.push_back(series);
  };
  add("rows", all.bob_rows, style_of_rows(page));
  add("block", all.bob_block, style_of_blocks(page));
  plot.now = step * all.settings.dt;
  draw_plot(page, rect, plot);
}

void draw_bobs(Page& page, const BlocksRuns& all, int step) {
  const List<Rect> parts = in_columns(page, {0.31, 0.31, 0.38});
  const std::string time =
      fmt::format("{} s, {} sweeps per step", fixed(step * all.settings.dt, 2), all.settings.sweeps);
  draw_bob(page, parts[0], all.bob_rows, step, "rows: " + time, style_of_rows(page));
  draw_bob(page, parts[1], all.bob_block, step, "block: " + time, style_of_blocks(page));
  draw_energy(page, parts[2], all, step);
}

}  // namespace

List<Shot> bob_shots(const BlocksRuns& all) {
  const auto step_at = [&](double time) { return static_cast<int>(std::lround(time / all.settings.dt)); };
  List<int> steps;
  for (int k = 1; k <= step_at(shown_seconds); ++k) steps.push_back(k);
  steps.push_back(step_at(all.settings.pin_seconds));
  List<Shot> shots;
  for (const int k : steps) {
    const double time = k * all.settings.dt;
    shots.push_back({.state = fmt::format("bob · {} s · step {}", fixed(time, 2), k),
                     .alt = fmt::format(
                         "A bob on a pin after {:.2f} s: row by row its energy is {:.3g} J, with the block "
                         "{:.3f} J.",
                         time, all.bob_rows.energy[k], all.bob_block.energy[k]),
                     .draw = [&all, k](Page& page) { draw_bobs(page, all, k); },
                     .key = k == step_at(0.8) || k == steps.back()});
  }
  return shots;
}

}  // namespace cairn::blocks
