// A weight on a soft row beside one on a row without gamma: every step, the question, and the answer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn::soft {

namespace {

using render::fixed;
using render::Page;
using render::Point;
using render::Rect;

const double soft_x = 0;  // [m] where the weights stand in the picture
const double rigid_x = 0.95;
const double left_x = -0.4;
const double right_x = 1.55;
const int most_frames = 75;  // of the motion

int last_step(const SoftRuns& all) { return all.spring.steps.size() - 1; }

/// Ground, the length without load (dashed) and the soft row's place of rest (dotted).
void draw_levels(Page& page, const render::Camera& camera, const SoftRuns& all) {
  const Point left = camera.project({left_x, 0});
  const Point right = camera.project({right_x, -0.05});
  page.canvas().rect({left.x(), left.y(), right.x() - left.x(), right.y() - left.y()},
                     {.fill = page.theme().static_hatch});
  page.canvas().line(camera.project({left_x, rest_length}), camera.project({right_x, rest_length}),
                     {.width = 1.5, .color = page.theme().inactive, .dash = {8, 5}});
  const double rest = rest_length - all.settings.mass * gravity / stiffness(all.settings);
  page.canvas().line(camera.project({left_x, rest}), camera.project({soft_x - left_x, rest}),
                     {.width = 1.5, .color = page.theme().secondary_text, .dash = {2, 4}});
}

/// The weight's own 10 N per kg are a fifth of a metre long; the kick of a row without gamma is cut.
void draw_push(Page& page, const render::Camera& camera, const SoftRuns& all, const Vec2<double>& foot,
               double lambda) {
  const double weight = all.settings.mass * gravity;
  const render::ArrowScale scale{
      .pixels_per_unit = 0.2 * camera.scale / weight, .longest = 0.55 * camera.scale, .unit = "N"};
  draw_arrow(page, camera, scale,
             {.kind = render::ArrowKind::joint, .tail = foot + Vec2<double>(0.24, 0), .value = {0, lambda}});
  if (std::abs(lambda) * scale.pixels_per_unit > scale.longest) return;  // then it says so itself
  render::TextStyle text = page.value();
  text.halo = page.theme().panel;
  const bool is_up = lambda > -0.2 * weight;  // shorter ones are dots
  const Point at = camera.project(foot + Vec2<double>(0.2, 0));
  const double below = is_up ? 1.3 * text.size : -0.5 * text.size;
  page.canvas().text({at.x(), at.y() + below}, fixed(lambda + 0.0, weight < 1 ? 3 : 1) + " N", text);
}

/// A zig-zag from the foot of a spring at x up to its end [m].
void draw_spring(Page& page, const render::Camera& camera, double x, double bottom, double top,
                 const render::SeriesStyle& style) {
  const int turns = 7;
  const double straight = 0.08 * (top - bottom);
  const double pitch = (top - bottom - 2 * straight) / turns;
  List<Point> points = {camera.project({x, bottom}), camera.project({x, bottom + straight})};
  for (int i = 0; i < turns; ++i) {
    const double side = i % 2 == 0 ? 0.1 : -0.1;
    points.push_back(camera.project({x + side, bottom + straight + pitch * (i + 0.5)}));
  }
  points.push_back(camera.project({x, top - straight}));
  points.push_back(camera.project({x, top}));
  page.canvas().polyline(points, {.width = page.sizes().curve, .color = style.color});
}

void draw_weight(Page& page, const render::Camera& camera, const SoftRuns& all, const WeightRun& run,
                 int step, double x) {
  Snapshot scene = run.steps[step];
  scene.joints.clear();
  scene.bodies[{1}].pose.position.x() += x;
  const double foot = rest_length + run.error[step];
  const bool is_soft = run.gamma > 0;
  const render::SeriesStyle style = is_soft ? style_of_soft(page) : style_of_rigid(page);
  if (is_soft) {
    draw_spring(page, camera, x, 0, foot, style);
  } else {
    page.canvas().line(camera.project({x, 0}), camera.project({x, foot}),
                       {.width = page.sizes().curve, .color = style.color});
  }
  render::WorldLook look;
  look.names = {"", fmt::format("{:g} kg", all.settings.mass)};
  draw_world(page, camera, scene, look);
  if (step > 0) draw_push(page, camera, all, {x, foot}, run.rows[step].lambda);
  render::TextStyle name = page.label();
  name.align = render::Align::center;
  const Point at = camera.project({x, -0.08});
  page.canvas().text({at.x(), at.y() + name.size}, is_soft ? "soft row" : "γ = 0, same β", name);
}

/// Both weights.
void draw_weights(Page& page, const Rect& rect, const SoftRuns& all, int step) {
  const Rect inside = page.panel(rect, "dashed: no load, dotted: at rest");
  const render::Camera camera = render::fit(inside, {{left_x, -0.2}, {right_x, 1.6}});
  draw_levels(page, camera, all);
  draw_weight(page, camera, all, all.spring, step, soft_x);
  draw_weight(page, camera, all, all.rigid, step, rigid_x);
}

/// c against time, up to `step`; the exact swing all the way.
void draw_errors(Page& page, const Rect& rect, const SoftRuns& all, int step) {
  render::Plot plot{.title = "c (mm), 0 without load"};
  plot.x = {.title = "t (s)", .min = 0, .max = seconds};
  render::Series exact{.name = "exact", .style = page.theme().exact, .markers = false};
  exact.style.marker = render::Marker::none;
  const int points = std::clamp(static_cast<int>(40 * all.settings.frequency * seconds), 200, 4000);
  double lowest = 0;
  double highest = 0;
  for (int i = 0; i <= points; ++i) {
    exact.x.push_back(seconds * i / points);
    exact.y.push_back(1000 * exact_error(all.settings, exact.x.back()));
    lowest = std::min(lowest, exact.y.back());
    highest = std::max(highest, exact.y.back());
  }
  plot.y = {.title = "", .min = lowest - 10, .max = highest + 20};
  plot.series.push_back(exact);
  const auto add = [&](const std::string& name, const WeightRun& run, const render::SeriesStyle& style) {
    render::Series series{.name = name, .style = style};
    for (int k = 0; k <= step; ++k) {
      series.x.push_back(k * all.settings.dt);
      series.y.push_back(1000 * run.error[k]);
    }
    plot.series.push_back(series);
  };
  add("soft row", all.spring, style_of_soft(page));
  add("γ = 0", all.rigid, style_of_rigid(page));
  draw_plot(page, rect, plot);
}

/// Weights left, curves right, up to step `last`; returns what is free below the curves.
Rect draw_moment(Page& page, const SoftRuns& all, int step, int last) {
  const List<Rect> halves = columns(page.area(), {0.46, 0.54}, page.sizes().gap);
  const double top = 0.58;
  const List<Rect> right = rows(halves[1], {top, 1 - top}, page.sizes().gap);
  draw_weights(page, halves[0], all, step);
  draw_errors(page, right[0], all, last);
  return right[1];
}

void draw_step(Page& page, const SoftRuns& all, int step) {
  const Rect panel = draw_moment(page, all, step, step);
  const StepRow& row = all.spring.rows[step];
  const std::string free = fixed(row.free, 3);
  page.equation(panel, {.number = "eq (22), the soft row",
                        .symbols = "λ = (ζ − j·v) / ((A + γ) Δt)",
                        .numbers = fmt::format("= ({} − {}) / (({:.3g} + {:.3g}) × {:.3g})",
                                               fixed(row.zeta, 3), row.free < 0 ? "(" + free + ")" : free,
                                               1 / all.settings.mass, all.spring.gamma, all.settings.dt),
                        .result = fmt::format("= {} N", fixed(row.lambda, 2)),
                        .algorithm = fmt::format("ζ = −β c / Δt, β = {:.4f} in both", all.spring.beta),
                        .color = style_of_soft(page).color});
}

Shot step_shot(const Runs& all, int step, bool key) {
  const double time = step * all->settings.dt;
  return {
      .state = fmt::format("step {} · t = {} s", step, fixed(time, 2)),
      .alt = fmt::format("After {:.2f} s the weight on the soft row is {:.1f} mm from where its spring has "
                         "no load, exactly it would be {:.1f} mm; the one without γ {:.1f} mm. The rows push "
                         "with {:.1f} and {:.1f} N.",
                         time, 1000 * all->spring.error[step], 1000 * exact_error(all->settings, time),
                         1000 * all->rigid.error[step] + 0.0, all->spring.rows[step].lambda,
                         all->rigid.rows[step].lambda),
      .draw = [all, step](Page& page) { draw_step(page, *all, step); },
      .key = key};
}

void draw_question(Page& page, const SoftRuns& all) {
  page.note(draw_moment(page, all, 0, 0), "The question", card().question);
}

/// The weights after the first step, which was asked for, and what became of them.
void draw_answer(Page& page, const SoftRuns& all) {
  const StepRow& row = all.spring.rows[1];
  page.note(
      draw_moment(page, all, 1, last_step(all)), "The answer",
      fmt::format("{} N, less than the spring's −k c = {} N at the beginning of the step. The row pushes "
                  "with what the spring will have at its end, when it is longer and its damper resists. "
                  "The rod takes back its share β of the error at once, whatever that takes.",
                  fixed(row.lambda, 1), fixed(stiffness(all.settings) * all.settings.pressed, 1)));
}

}  // namespace

render::SeriesStyle style_of_soft(const Page& page) { return page.theme().si; }
render::SeriesStyle style_of_rigid(const Page& page) { return page.theme().jacobi; }

List<Shot> soft_shots(const SoftRuns& recorded) {
  const Runs all = std::make_shared<const SoftRuns>(recorded);
  List<Shot> shots;
  shots.push_back({.state = "before the first step",
                   .alt = "Two weights, one on a spring and one on a rod, both pressed down; the chart of "
                          "their motion; and the question.",
                   .draw = [all](Page& page) { draw_question(page, *all); },
                   .key = true});
  const int frames = std::min(last_step(*all), most_frames);
  const std::set<int> keys = {1, 5, 20, frames};
  for (int frame = 1; frame <= frames; ++frame)
    shots.push_back(step_shot(all, frame * last_step(*all) / frames, keys.contains(frame)));
  for (const List<Shot>& more : {stiff_shots(all), column_shots(all), harsh_shots(all)})
    shots.insert(shots.end(), more.begin(), more.end());
  shots.push_back(
      {.state = "answer",
       .alt = "Both weights after the first step with the push of their rows, the chart of their motion, "
              "and the answer.",
       .draw = [all](Page& page) { draw_answer(page, *all); },
       .key = true});
  return shots;
}

}  // namespace cairn::soft
