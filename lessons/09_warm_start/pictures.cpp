// Three towers side by side, cold, warm and one row off, above one chart that all three share.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "lessons/question.hpp"
#include "lessons/tower_panel.hpp"
#include "math/list.hpp"
#include "parts.hpp"
#include "render/plot.hpp"

namespace cairn::warm {

namespace {

using render::fixed;
using render::Page;
using render::Rect;
using render::SeriesStyle;

FixedList<const StartRun*, 3> runs_of(const WarmStart& all) { return {&all.cold, &all.warm, &all.shifted}; }

double largest_load(const WarmStart& all) {
  double largest = all.settings.weight();
  for (const StartRun* run : runs_of(all)) {
    for (const List<double>& frame : run->loads) {
      largest = std::max(largest, *std::max_element(frame.begin(), frame.end()));
    }
  }
  return largest;
}

double top_of(const StartRun& run, int frame) {
  return run.frames[frame].bodies.back().pose.position.y() + 0.5;
}

constexpr int lately = 15;  // steps: a little more than one swing of the warm load

/// The least and the most that each contact has carried lately [N].
struct Range {
  List<double> least = {};
  List<double> most = {};
};

Range lately_carried(const StartRun& run, int frame) {
  Range range{.least = run.loads[frame], .most = run.loads[frame]};
  for (int k = std::max(1, frame - lately + 1); k < frame; ++k) {
    for (int i = 0; i < range.least.size(); ++i) {
      range.least[i] = std::min(range.least[i], run.loads[k][i]);
      range.most[i] = std::max(range.most[i], run.loads[k][i]);
    }
  }
  return range;
}

/// Where the top of the tower was at the start.
void draw_start_line(Page& page, const render::Camera& camera, double boxes) {
  page.canvas().line(camera.project({-1, boxes}), camera.project({1, boxes}),
                     {.width = 1.5, .color = page.theme().secondary_text, .dash = {6, 4}});
}

/// What the top of the tower does, and not only where it is.
std::string motion_of(const StartRun& run, int frame) {
  const double speed = run.frames[frame].bodies.back().velocity.y();
  return std::abs(speed) < 0.005 ? "stands still" : fixed(speed, 2, render::Sign::always) + " m/s";
}

/// One start: its tower, its loads, and within which bounds the loads have been lately.
void draw_start(Page& page, const Rect& rect, const WarmStart& all, const StartRun& run, int frame,
                const SeriesStyle& style) {
  const double moved = 1000 * (top_of(run, frame) - all.settings.boxes);
  const std::string top = "top " + fixed(moved, 0, render::Sign::always) + " mm";
  const bool is_wide = rect.width > 300;  // or there is room for the tower alone
  const Rect view = draw_solver_panel(page, rect, style, run.name, is_wide ? top : "");
  const Range range = lately_carried(run, frame);
  const render::Camera camera = draw_tower_loads(page, view, run.frames[frame], run.loads[frame],
                                                 {.box_weight = gravity,
                                                  .largest = largest_load(all),
                                                  .color = style.color,
                                                  .least = range.least,
                                                  .most = range.most});
  draw_start_line(page, camera, all.settings.boxes);
  if (frame == 0 || !is_wide) return;
  render::TextStyle text = page.value();
  text.align = render::Align::right;
  const double right = view.x + view.width, line = 1.5 * text.size;
  page.canvas().text({right, view.y + line}, motion_of(run, frame), text);
  page.canvas().text({right, view.y + 2 * line},
                     range.most[0] - range.least[0] < 1
                         ? fmt::format("λ_{{1}} {:.0f} N", range.most[0])
                         : fmt::format("λ_{{1}} {:.0f} to {:.0f} N", range.least[0], range.most[0]),
                     text);
}

void draw_towers(Page& page, const Rect& rect, const WarmStart& all, int frame) {
  const List<Rect> panels = columns(rect, {1, 1, 1}, page.sizes().gap);
  const FixedList<SeriesStyle, 3> styles = start_styles(page.theme());
  const FixedList<const StartRun*, 3> runs = runs_of(all);
  for (int s = 0; s < runs.size(); ++s) draw_start(page, panels[s], all, *runs[s], frame, styles[s]);
}

void draw_load_plot(Page& page, const Rect& rect, const WarmStart& all, int frame) {
  render::Plot plot{.title = fmt::format("load λ_{{1}} on the lowest box, step by step; to carry: {:g} N",
                                         all.settings.weight())};
  constexpr int near = 30;  // steps that the first frames show
  const int shown = frame <= near ? near : all.settings.steps;
  plot.x = {.min = 0, .max = shown};
  plot.y = {.min = 0, .max = 1.15 * largest_load(all)};
  const FixedList<SeriesStyle, 3> styles = start_styles(page.theme());
  const FixedList<const StartRun*, 3> runs = runs_of(all);
  for (int s = 0; s < runs.size(); ++s) {
    render::Series series{.name = runs[s]->name, .style = styles[s]};
    for (int k = 0; k <= shown; ++k) {
      series.x.push_back(k);
      series.y.push_back(runs[s]->loads[k][0]);
    }
    plot.series.push_back(series);
  }
  plot.goals.push_back({all.settings.weight(), ""});
  plot.now = frame;
  draw_plot(page, rect, plot);
}

void draw_step(Page& page, const WarmStart& all, int frame) {
  const List<Rect> parts = rows(page.area(), {0.62, 0.38}, page.sizes().gap);
  draw_towers(page, parts[0], all, frame);
  draw_load_plot(page, parts[1], all, frame);
}

QuestionFrame towers_at(const All& all, int frame, std::string state, std::string alt) {
  return {.state = std::move(state),
          .alt = std::move(alt),
          .scene = [all, frame](Page& page, const Rect& rect) { draw_towers(page, rect, *all, frame); }};
}

Shot step_shot(const All& all, int frame) {
  return {.state = fmt::format("step {} · t = {} s", frame, fixed(frame * all->settings.dt, 2)),
          .alt = fmt::format(
              "Step {}: the lowest box carries {:.2f} N cold, {:.2f} N warm and {:.2f} N one row "
              "off; the towers are {:.3f} m, {:.3f} m and {:.3f} m high.",
              frame, all->cold.loads[frame][0], all->warm.loads[frame][0], all->shifted.loads[frame][0],
              top_of(all->cold, frame), top_of(all->warm, frame), top_of(all->shifted, frame)),
          .draw = [all, frame](Page& page) { draw_step(page, *all, frame); }};
}

std::string answer_text(const WarmStart& all) {
  const double weight = all.settings.weight();
  std::string text =
      fmt::format("{} sweeps in one step. Warm, the {} sweeps of a step go on where the last ones ended.",
                  all.own.needed, all.settings.sweeps);
  text += unrest(all.cold.loads, weight) > wanted_error * weight
              ? " Cold, the tower sinks into itself."
              : " Cold, the loads come out right in the end, but the tower sinks for ever.";
  if (unrest(all.shifted.loads, weight) > wanted_error * weight) {
    text += " One row off, it never comes to rest: its loads keep swinging (pale: the last 15 steps).";
  }
  return text;
}

}  // namespace

FixedList<SeriesStyle, 3> start_styles(const render::Theme& theme) {
  return {{{theme.box2d.color, {10, 6}, render::Marker::square},
           {theme.si.color, {}, render::Marker::circle},
           theme.jacobi}};
}

List<Shot> start_shots(const WarmStart& recorded) {
  const All all = std::make_shared<const WarmStart>(recorded);
  const int last = all->settings.steps;
  const std::set<int> keys = {1, 2, 5, 10, 20, last};
  List<Shot> shots = {question_shot(
      card(), towers_at(all, 0, "before the first step",
                        "Three equal towers named cold, warm and one row off, without any load yet, and the "
                        "question."))};
  for (int k = 1; k <= last; ++k) {
    shots.push_back(step_shot(all, k));
    shots.back().key = keys.contains(k);
  }
  for (Shot& shot : order_shots(all)) shots.push_back(std::move(shot));
  shots.push_back(answer_shot(
      card(),
      towers_at(all, last, fmt::format("after {} steps", last),
                fmt::format("The three towers at the end, and the answer: {} sweeps.", all->own.needed)),
      answer_text(*all)));
  return shots;
}

}  // namespace cairn::warm
