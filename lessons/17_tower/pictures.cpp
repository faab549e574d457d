// Three towers side by side above one chart that all three share.
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

namespace cairn::tower {

namespace {

using render::Page;
using render::Rect;
using render::SeriesStyle;

using Runs = std::shared_ptr<const TowerRuns>;

FixedList<SeriesStyle, 3> engine_styles(const Page& page) {
  return {page.theme().pgs, page.theme().si, page.theme().box2d};
}

double largest_load(const TowerRuns& runs) {
  double largest = runs.settings.boxes * runs.settings.gravity;
  for (const EngineRun& run : runs.warm) {
    for (const List<double>& frame : run.loads) {
      for (const double load : frame) largest = std::max(largest, load);
    }
  }
  return largest;
}

/// One engine: its tower and its loads.
void draw_engine(Page& page, const Rect& rect, const TowerRuns& runs, const EngineRun& run, int frame,
                 const SeriesStyle& style) {
  const std::string lowest = render::fixed(run.loads[frame][0], 2) + " N";
  const Rect view = draw_solver_panel(page, rect, style, run.name, lowest);
  const double height = run.frames[frame].bodies.back().pose.position.y() + 0.5;
  render::TextStyle small = page.tick();
  small.align = render::Align::right;
  page.canvas().text({view.x + view.width, view.y + 0.6 * small.size},
                     fmt::format("top: {} m", render::fixed(height, 2)), small);
  draw_tower_loads(
      page, view, run.frames[frame], run.loads[frame],
      {.box_weight = runs.settings.gravity, .largest = largest_load(runs), .color = style.color});
}

/// The lowest load over the frames so far, for all three engines.
render::Plot load_plot(const Page& page, const TowerRuns& runs, const List<EngineRun>& engines, int frame) {
  const TowerSettings& settings = runs.settings;
  render::Plot plot;
  plot.title = "load λ_{1} on the lowest box (N), step by step";
  plot.x = {.title = "step", .min = 0, .max = settings.steps};
  plot.y = {.min = 0, .max = 1.15 * largest_load(runs)};
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  for (int e = 0; e < engines.size(); ++e) {
    List<double> lowest;
    for (const List<double>& loads : engines[e].loads) lowest.push_back(loads[0]);
    plot.series.push_back(over_steps(e == 2 ? "Box2D" : engines[e].name, styles[e], lowest));
  }
  const double weight = settings.boxes * settings.gravity;
  plot.goals.push_back({weight, fmt::format("the weight: {:g} N", weight)});
  plot.now = frame;
  return plot;
}

/// The largest difference of a load from the same under SI, step by step.
render::Plot gap_plot(const Page& page, const TowerRuns& runs, const List<EngineRun>& engines, int frame) {
  render::Plot plot{.title = "largest difference of a load from SI's (N)"};
  plot.x = {.title = "step", .min = 0, .max = runs.settings.steps};
  plot.y = {.title = "", .scale = render::AxisScale::logarithmic, .min = 1e-16, .max = 100};
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  for (const int e : {0, 2}) {
    List<double> gaps;
    for (int k = 0; k < engines[e].loads.size(); ++k) {
      double largest = 0;
      for (int i = 0; i < engines[e].loads[k].size(); ++i) {
        largest = std::max(largest, std::abs(engines[e].loads[k][i] - engines[1].loads[k][i]));
      }
      gaps.push_back(largest);
    }
    plot.series.push_back(over_steps(e == 2 ? "Box2D" : engines[e].name, styles[e], gaps));
  }
  plot.now = frame;
  return plot;
}

void draw_towers(Page& page, const Rect& rect, const TowerRuns& runs, const List<EngineRun>& engines,
                 int frame) {
  const List<Rect> panels = columns(rect, {1, 1, 1}, page.sizes().gap);
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  for (int e = 0; e < engines.size(); ++e) draw_engine(page, panels[e], runs, engines[e], frame, styles[e]);
}

void draw_three(Page& page, const TowerRuns& runs, const List<EngineRun>& engines, int frame) {
  const List<Rect> parts = rows(page.area(), {0.6, 0.4}, page.sizes().gap);
  draw_towers(page, parts[0], runs, engines, frame);
  const List<Rect> plots = columns(parts[1], {1, 1}, page.sizes().gap);
  draw_plot(page, plots[0], load_plot(page, runs, engines, frame));
  draw_plot(page, plots[1], gap_plot(page, runs, engines, frame));
}

std::string heights(const EngineRun& run, int frame) {
  const SnapshotBody& top = run.frames[frame].bodies.back();
  return fmt::format("{:.2f} m", top.pose.position.y() + 0.5);
}

Shot step_shot(const Runs& runs, bool warm, int frame) {
  const List<EngineRun>& engines = warm ? runs->warm : runs->cold;
  return {
      .state = fmt::format("{} · step {} · t = {} s", warm ? "warm start" : "cold start", frame,
                           render::fixed(frame * runs->settings.dt, 2)),
      .alt = fmt::format("{} start, step {}: the lowest box carries {:.2f} N under PGS, {:.2f} N under "
                         "SI and {:.2f} N under Box2D; the towers are {}, {} and {} high.",
                         warm ? "Warm" : "Cold", frame, engines[0].loads[frame][0],
                         engines[1].loads[frame][0], engines[2].loads[frame][0], heights(engines[0], frame),
                         heights(engines[1], frame), heights(engines[2], frame)),
      .draw = [runs, warm, frame](Page& page) {
        draw_three(page, *runs, warm ? runs->warm : runs->cold, frame);
      }};
}

QuestionFrame warm_towers(const Runs& runs, int frame, const std::string& state, const std::string& alt) {
  const auto scene = [runs, frame](Page& page, const Rect& rect) {
    draw_towers(page, rect, *runs, runs->warm, frame);
  };
  return {.state = state, .alt = alt, .scene = scene, .place = ScenePlace::above};
}

std::string answer_text(const TowerRuns& runs, int step) {
  return fmt::format(
      "By at most {} N, since Box2D computes in single precision; PGS and SI differ less still. In step {} "
      "the "
      "ground carries {} N instead of {}, under all three: they are one algorithm, and equally wrong.",
      render::significant(gap_to_box2d(runs), 2), step, render::fixed(runs.warm[1].loads[step][0], 2),
      render::fixed(runs.settings.boxes * runs.settings.gravity, 0));
}

}  // namespace

List<Shot> tower_shots(const TowerRuns& all) {
  const Runs runs = std::make_shared<const TowerRuns>(all);
  const int last = runs->settings.steps, wrong = std::min(5, last);
  const std::set<int> warm_keys = {1, 2, 5, 10, 20, last};
  const std::set<int> cold_keys = {5, last / 2, last};
  List<Shot> shots = {question_shot(
      card(),
      warm_towers(runs, 0, "before the first step",
                  "Three towers of boxes, not yet loaded, named PGS, SI and Box2D, and the question."))};
  for (int k = 1; k <= last; ++k) {
    shots.push_back(step_shot(runs, true, k));
    shots.back().key = warm_keys.contains(k);
  }
  for (int k = 1; k <= last; ++k) {
    shots.push_back(step_shot(runs, false, k));
    shots.back().key = cold_keys.contains(k);
  }
  shots.push_back(answer_shot(
      card(),
      warm_towers(runs, wrong, fmt::format("after {} steps", wrong),
                  "The three towers while their loads are still wrong, and the answer: how far these "
                  "differ."),
      answer_text(*runs, wrong)));
  return shots;
}

}  // namespace cairn::tower
