// Two stacks of two boxes: the load that each sweep finds, and how many sweeps any ratio of masses takes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "parts.hpp"
#include "render/bars.hpp"
#include "render/draw.hpp"
#include "render/matrix.hpp"
#include "render/plot.hpp"

namespace cairn::edges {

namespace {

using render::fixed;
using render::Page;
using render::Rect;

const FixedList<int, 8> map_sweeps = {1, 3, 10, 30, 100, 300, 1000, 3000};

/// One stack, its masses written on its boxes, and the load on the ground as an arrow beside it.
void draw_stack(Page& page, const Rect& rect, const RatioRun& run, int sweep) {
  const bool heavy_above = run.ratio >= 1;
  const double other = heavy_above ? run.ratio : 1 / run.ratio;
  const Rect inside = page.panel(
      rect, heavy_above ? fmt::format("{:g} kg on 1 kg", other) : fmt::format("1 kg on {:g} kg", other));
  const render::Camera camera = render::fit(inside, {{-1.4, -0.35}, {1.4, 2.15}});
  render::WorldLook look;
  look.contacts = false;
  look.names = {"", heavy_above ? "1" : fmt::format("{:g}", other),
                heavy_above ? fmt::format("{:g}", other) : "1"};
  page.canvas().push_clip(inside);
  draw_world(page, camera, snapshot(World(two_boxes_scene(run.ratio))), look);
  const render::ArrowScale scale{
      .pixels_per_unit = 1.7 * camera.scale, .longest = 2 * camera.scale, .unit = ""};
  const double weight = (1 + run.ratio) * gravity, load = run.load[sweep][0];
  if (sweep > 0) draw_arrow(page, camera, scale, {.tail = {0.85, 0}, .value = {0, load / weight}});
  page.canvas().pop_clip();
  if (sweep == 0) return;
  render::TextStyle text = page.value();
  text.align = render::Align::right;
  page.canvas().text({inside.x + inside.width, inside.y + text.size},
                     fmt::format("λ_{{1}} = {} of {:g} N", render::significant(load, 4), weight), text);
}

/// The two stacks with the load on the ground after a sweep.
void draw_stacks(Page& page, const Rect& rect, const ExtremesRun& run, int sweep) {
  const List<Rect> panels = columns(rect, {1, 1}, page.sizes().gap);
  const RatioRun& light = run_of(run.ratios, 1 / run.settings.ratio);
  draw_stack(page, panels[0], run_of(run.ratios, run.settings.ratio), sweep);
  draw_stack(page, panels[1], light, std::min(sweep, light.error.size() - 1));
}

/// A style for each of a few stacks; all of them are solved by SI, so they share its colour.
render::SeriesStyle style_of(const Page& page, int which) {
  const FixedList<render::Marker, 4> markers = {render::Marker::square, render::Marker::circle,
                                                render::Marker::triangle, render::Marker::diamond};
  const FixedList<List<double>, 4> dashes = {List<double>{}, {10, 6}, {3, 4}, {14, 4, 3, 4}};
  return {.color = page.theme().si.color, .dash = dashes[which], .marker = markers[which]};
}

/// The largest, the middle and the smallest of them.
std::set<double> plotted_ratios(double ratio) { return {ratio, 10, 1, 1 / ratio}; }

void draw_errors(Page& page, const Rect& rect, const ExtremesRun& run, int sweep) {
  render::Plot plot{.title = "error of the load on the ground (%)"};
  const int last = run_of(run.ratios, run.settings.ratio).counted;
  plot.x = {.title = "sweep", .scale = render::AxisScale::logarithmic, .min = 1, .max = 1.3 * last + 10};
  plot.y = {.title = "", .scale = render::AxisScale::logarithmic, .min = 0.1, .max = 100};
  int which = 0;
  for (const double ratio : plotted_ratios(run.settings.ratio)) {
    const RatioRun& each = run_of(run.ratios, ratio);
    render::Series series{.name = name_of(ratio), .style = style_of(page, which++)};
    double next = 1;  // sparsely, as the axis is logarithmic
    for (int k = 1; k < each.error.size() && 100 * each.error[k] >= 0.1; ++k) {
      if (k < next && k != sweep) continue;
      next = 1.05 * k;
      series.x.push_back(k);
      series.y.push_back(100 * each.error[k]);
    }
    plot.series.push_back(series);
  }
  plot.now = sweep;
  plot.goals.push_back({100 * goal, "1 %"});
  draw_plot(page, rect, plot);
}

render::Equation equation_of(const Page& page, const ExtremesRun& run, int sweep) {
  const RatioRun& heavy = run_of(run.ratios, run.settings.ratio);
  const double jv = heavy.speed_jv[sweep][0];
  return {.number = "eq (22), row 1 of " + name_of(heavy.ratio),
          .symbols = "Δλ_{1} = (ζ − j·v) / (A_{11} Δt)",
          .numbers = fmt::format("= (0 − ({})) / (1 × {:g})", render::significant(jv, 4), time_step),
          .result = fmt::format("= {} N", fixed(-jv / time_step, 3)),
          .algorithm = fmt::format("λ_{{1}}: {} → {} N", fixed(heavy.load[sweep - 1][0], 2),
                                   fixed(heavy.load[sweep][0], 2)),
          .color = page.theme().normal};
}

void draw_sweep(Page& page, const ExtremesRun& run, int sweep) {
  const List<Rect> halves = columns(page.area(), {0.5, 0.5}, page.sizes().gap);
  const List<Rect> left = rows(halves[0], {0.56, 0.44}, page.sizes().gap);
  draw_stacks(page, left[0], run, sweep);
  draw_errors(page, halves[1], run, sweep);
  page.equation(left[1], equation_of(page, run, sweep));
}

Shot sweep_shot(const Run& run, int sweep, bool key) {
  const RatioRun& heavy = run_of(run->ratios, run->settings.ratio);
  const RatioRun& light = run_of(run->ratios, 1 / run->settings.ratio);
  const double found = sweep < light.error.size() ? 1 - light.error[sweep] : 1;
  return {.state = fmt::format("sweep {}", sweep),
          .alt = fmt::format("After sweep {}: {} has found {:.1f} % of the load on the ground, {} {:.1f} %.",
                             sweep, name_of(heavy.ratio), 100 * (1 - heavy.error[sweep]),
                             name_of(light.ratio), 100 * found),
          .draw = [run, sweep](Page& page) { draw_sweep(page, *run, sweep); },
          .key = key};
}

render::MatrixView map_of(const ExtremesRun& run) {
  render::MatrixView view{.title = "error left (%): each row a stack, each column a number of sweeps"};
  view.colors = render::MatrixColors::magnitude;
  view.values = Eigen::MatrixXd::Zero(run.ratios.size(), map_sweeps.size());
  for (const int sweep : map_sweeps) view.column_names.push_back(fmt::format("{}", sweep));
  for (int i = 0; i < run.ratios.size(); ++i) {
    const double ratio = run.ratios[run.ratios.size() - 1 - i].ratio;
    if (ratio == run.settings.ratio) view.active_row = i;
    view.row_names.push_back(name_of(ratio));
    for (int j = 0; j < map_sweeps.size(); ++j) {
      const double error = 100 * run_of(run.ratios, ratio).error[map_sweeps[j]];
      const double shown = std::round(error * 10) / 10;  // what is below 0.05 % is a dot
      view.values(i, j) = shown;
    }
  }
  return view;
}

void draw_needed(Page& page, const Rect& rect, const ExtremesRun& run) {
  render::Plot plot{.title = "sweeps to 1 %"};
  plot.x = {.title = "mass above / mass below", .scale = render::AxisScale::logarithmic};
  plot.y = {.title = "", .scale = render::AxisScale::logarithmic, .min = 0.7, .max = 1e5};
  render::Series formula{.name = "", .style = page.theme().exact, .markers = false};
  render::Series counted{.name = "", .style = page.theme().si, .line = false};
  for (int i = 0; i <= 70; ++i) {
    const double ratio = std::pow(10, -3 + i / 10.0);
    formula.x.push_back(ratio);
    formula.y.push_back(std::max(1.0, std::log(goal) / std::log(rate_by_formula(ratio))));
  }
  for (const RatioRun& each : run.ratios) {
    if (each.ratio > 10000 || each.ratio < 0.001) continue;
    counted.x.push_back(each.ratio);
    counted.y.push_back(each.counted);
  }
  plot.series = {formula, counted};
  draw_plot(page, rect, plot);
}

void draw_map(Page& page, const ExtremesRun& run) {
  const List<Rect> halves = columns(page.area(), {0.54, 0.46}, page.sizes().gap);
  draw_matrix(page, page.panel(halves[0], ""), map_of(run));
  const List<Rect> right = rows(halves[1], {0.62, 0.38}, page.sizes().gap);
  draw_needed(page, right[0], run);
  page.note(right[1], "What decides",
            "A sweep leaves R / (1 + R) of the error, where R is the mass above over the mass below. "
            "The line is ln 100 / ln(1 + 1/R), about 4.6R; the squares are counted.");
}

/// The two stacks, sweep by sweep, and the map of all ratios.
List<Shot> ratio_shots(const Run& run) {
  const int last = run_of(run->ratios, run->settings.ratio).counted;
  List<Shot> shots;
  for (const int sweep : {1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000}) {
    if (sweep < last) shots.push_back(sweep_shot(run, sweep, sweep == 1 || sweep == 10));
  }
  shots.push_back(sweep_shot(run, last, true));
  shots.push_back({.state = "all masses",
                   .alt = "A map of the error that is left, by ratio of masses and number of sweeps, and the "
                          "sweeps that each ratio takes to 1 %: about 4.6 times the ratio.",
                   .draw = [run](Page& page) { draw_map(page, *run); },
                   .key = true});
  return shots;
}

}  // namespace

std::string name_of(double ratio) {
  return ratio >= 1 ? fmt::format("{:g} on 1", ratio) : fmt::format("1 on {:g}", 1 / ratio);
}

List<Shot> extremes_shots(const ExtremesRun& recorded) {
  const Run run = std::make_shared<const ExtremesRun>(recorded);
  const int heavy = run_of(run->ratios, run->settings.ratio).counted;
  const int light = run_of(run->ratios, 1 / run->settings.ratio).counted;
  const auto stacks = [&](int sweep, const std::string& state, const std::string& alt) {
    const auto scene = [run, sweep](Page& page, const Rect& rect) { draw_stacks(page, rect, *run, sweep); };
    return QuestionFrame{.state = state, .alt = alt, .scene = scene, .place = ScenePlace::above};
  };
  List<Shot> shots = {question_shot(
      card(), stacks(0, "before the first sweep",
                     fmt::format("Two stacks of two boxes, {} and {} kilograms, and the question.",
                                 name_of(run->settings.ratio), name_of(1 / run->settings.ratio))))};
  for (const List<Shot>& part : {ratio_shots(run), wall_shots(run)})
    shots.insert(shots.end(), part.begin(), part.end());
  shots.push_back(answer_shot(
      card(),
      stacks(
          heavy, "the answer",
          fmt::format("Both stacks with their loads found, and the answer: {} sweeps and {}.", heavy, light)),
      fmt::format("{} with the heavy box above, {} with the light one. The ground acts through the light "
                  "box, so a sweep leaves R\u00a0/\u00a0(1\u00a0+\u00a0R) of the error. With the heavy box "
                  "below, the first guess is nearly right.",
                  heavy, light)));
  return shots;
}

}  // namespace cairn::edges
