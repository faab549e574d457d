// A bob with a tiny moment of inertia: where two rows throw it, and where their block keeps it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn::blocks {

namespace {

using render::Page;
using render::Point;
using render::Rect;

const double shown_seconds = 1.2;  // step by step; then the end

bool is_inside(const Rect& rect, const Point& point) {
  return point.x() >= rect.x && point.x() <= rect.x + rect.width && point.y() >= rect.y &&
         point.y() <= rect.y + rect.height;
}

void draw_bob(Page& page, const Rect& rect, const BobRun& run, int step, const std::string& name,
              const render::SeriesStyle& style) {
  const Rect inside = page.panel(rect, name);
  page.canvas().rect({rect.x, rect.y, rect.width, 4}, {.fill = style.color});
  const render::Camera camera = render::fit(inside, {{-1.2, -2.65}, {1.2, 0.35}});
  page.canvas().push_clip(inside);
  const Point pin = camera.project({0, 0});
  page.canvas().circle(pin, camera.scale, {.outline = page.theme().grid, .outline_width = 1.5});
  List<Vec2<double>> path;
  for (int k = 0; k <= step && is_inside(inside, camera.project(run.path[k])); ++k)
    path.push_back(run.path[k]);
  draw_trail(page, camera, path, {style.color, {}, render::Marker::none});
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
  render::TextStyle text = page.label();
  text.align = render::Align::center;
  text.halo = page.theme().panel;
  page.canvas().text({pin.x(), pin.y() + 0.6 * camera.scale},
                     fmt::format("{} m away", render::significant(run.path[step].norm(), 2)), text);
}

/// While it begins, the energy as it is; in the end its excess over that of hanging still, in decades.
void draw_energy(Page& page, const Rect& rect, const BlocksRuns& all, int step) {
  const bool soon = step * all.settings.dt <= shown_seconds * (1 + 1e-9);
  render::Plot plot{.title =
                        soon ? "energy (J), 0 at rest at the pin" : "energy above that of hanging still (J)"};
  plot.x = {.title = "t (s)", .min = 0, .max = soon ? shown_seconds : all.settings.pin_seconds};
  if (soon) {
    plot.y = {.title = "", .min = -25, .max = 25};
  } else {
    const double top = 10 * std::max(100.0, all.bob_rows.largest_energy);
    plot.y = {.title = "", .scale = render::AxisScale::logarithmic, .min = 0.1, .max = top};
  }
  const auto add = [&](const std::string& name, const BobRun& run, const render::SeriesStyle& style) {
    render::Series series{.name = name, .style = style};
    for (int k = 0; k * all.settings.dt <= *plot.x.max + 1e-9 && k < run.energy.size(); ++k) {
      series.x.push_back(k * all.settings.dt);
      series.y.push_back(run.energy[k] + (soon ? 0 : gravity));
    }
    plot.series.push_back(series);
  };
  add("rows", all.bob_rows, style_of_rows(page));
  add("block", all.bob_block, style_of_blocks(page));
  plot.now = step * all.settings.dt;
  draw_plot(page, rect, plot);
}

/// Both bobs; returns what is free below them.
Rect draw_bobs(Page& page, const BlocksRuns& all, int step) {
  const List<Rect> parts = rows(page.area(), {0.54, 0.46}, page.sizes().gap);
  const List<Rect> halves = columns(parts[0], {0.5, 0.5}, page.sizes().gap);
  const std::string sweeps =
      fmt::format("{} sweep{} a step", all.settings.sweeps, all.settings.sweeps == 1 ? "" : "s");
  draw_bob(page, halves[0], all.bob_rows, step, "rows, " + sweeps, style_of_rows(page));
  draw_bob(page, halves[1], all.bob_block, step, "block, " + sweeps, style_of_blocks(page));
  return parts[1];
}

/// Says of the bob what has happened to it, with this inertia.
std::string answer_text(const BlocksRuns& all) {
  const ChainRun& chain = all.chains[welded_three];
  const bool thrown = all.bob_rows.largest_energy > 1000;
  return fmt::format(
      "Three welded beams take {} sweeps with blocks and {} without: the conflict between joints is left. {}",
      chain.blocks.sweeps, chain.rows.sweeps,
      thrown ? "But where the rows of one joint couple strongly, as in this pin, a block is the difference "
               "between a pendulum and an explosion."
             : "With this inertia rows do not throw the bob either; with a tiny one they do.");
}

/// The beams that were asked about, far from done, and a bob that rows cannot hold.
void draw_answer(Page& page, const BlocksRuns& all, int step) {
  const List<Rect> parts = rows(page.area(), {0.62, 0.38}, page.sizes().gap);
  const List<Rect> halves = columns(parts[0], {0.6, 0.4}, page.sizes().gap);
  const List<Rect> beams = rows(halves[0], {0.5, 0.5}, page.sizes().gap);
  draw_both_beams(page, {beams[0], beams[1]}, all.chains[welded_three], 10);
  draw_bob(page, halves[1], all.bob_rows, step, "C, rows", style_of_rows(page));
  page.note(parts[1], "The answer", answer_text(all));
}

}  // namespace

List<Shot> bob_shots(const Runs& all) {
  const auto step_at = [&](double time) { return static_cast<int>(std::lround(time / all->settings.dt)); };
  List<int> steps;
  for (int k = 1; k <= step_at(shown_seconds); ++k) steps.push_back(k);
  steps.push_back(step_at(all->settings.pin_seconds));
  List<Shot> shots;
  for (const int k : steps) {
    const double time = k * all->settings.dt;
    shots.push_back({.state = fmt::format("C · {} s · step {}", render::fixed(time, 2), k),
                     .alt = fmt::format(
                         "A bob on a pin after {:.2f} s: row by row its energy is {:.3g} J, with the block "
                         "{:.3f} J.",
                         time, all->bob_rows.energy[k], all->bob_block.energy[k]),
                     .draw = [all, k](Page& page) { draw_energy(page, draw_bobs(page, *all, k), *all, k); },
                     .key = k == step_at(0.3) || k == step_at(0.8) || k == steps.back()});
  }
  shots.push_back(
      {.state = "answer",
       .alt = "Three beams after ten sweeps, by rows and by blocks; the bob after 0.8 s, row by row; "
              "and the answer.",
       .draw = [all, last = step_at(0.8)](Page& page) { draw_answer(page, *all, last); },
       .key = true});
  return shots;
}

}  // namespace cairn::blocks
