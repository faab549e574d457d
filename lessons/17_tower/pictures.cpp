// One tower with the loads of three engines, and charts of these loads and of their differences.
#include "lesson.hpp"
#include "render/solver_style.hpp"

namespace cairn::tower {

namespace {

FixedList<SeriesStyle, 3> engine_styles(const Page& page) {
  return {page.theme().pgs, page.theme().si, page.theme().box2d};
}

double largest_load(const TowerRuns& runs) {
  double largest = runs.settings.boxes * runs.settings.gravity;
  for (const List<double>& frame : runs.warm[1].loads)
    largest = std::max(largest, *std::max_element(frame.begin(), frame.end()));
  return largest;
}

/// A load of each box, and how it is drawn.
struct Bars {
  std::string name = {};
  SeriesStyle style = {};
  const Loads* loads = nullptr;
  double height = 0;  // [m] of a bar
};

/// SI and Box2D; warm also Box2D from the top down, in thin bars.
List<Bars> bars_of(const Page& page, const TowerRuns& runs, const List<EngineRun>& engines) {
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  List<Bars> bars = {{"SI", styles[1], &engines[1].loads, 0.3}, {"Box2D", styles[2], &engines[2].loads, 0.3}};
  if (&engines == &runs.warm)
    bars.push_back({"top down", render::neutral_styles(page.theme())[0], &runs.from_top[1].loads, 0.14});
  return bars;
}

/// Beside each box its loads, one bar below the other, and a tick at the weight above.
void draw_bars(Page& page, const Camera& camera, const TowerRuns& runs, const Snapshot& tower,
               const List<Bars>& bars, int frame) {
  const Rect& view = camera.viewport;
  const double left = camera.project({0.5, 0}).x() + 14;
  const double per_newton = (view.x + view.width - left) / (1.05 * largest_load(runs));
  for (int i = 0; i < runs.settings.boxes; ++i) {
    const double y = camera.project(tower.bodies[{i + 1}].pose.position).y();
    double top = y - 0.38 * camera.scale;
    for (const Bars& each : bars) {
      const double height = each.height * camera.scale;
      page.canvas().rect({left, top, (*each.loads)[frame][i] * per_newton, height},
                         {.fill = each.style.color, .outline = page.theme().panel, .outline_width = 1});
      top += height;
    }
    const double tick = left + (runs.settings.boxes - i) * runs.settings.gravity * per_newton;
    page.canvas().line({tick, y - 0.42 * camera.scale}, {tick, y + 0.42 * camera.scale},
                       {.width = 2, .color = page.theme().exact.color});
  }
}

/// In the corner, what each finds at the ground and in the middle.
void draw_corner(Page& page, const Rect& view, const TowerRuns& runs, const List<Bars>& bars, int frame) {
  const int middle = middle_box(runs);
  const double line = 1.4 * page.label().size;
  page.canvas().text({view.x + view.width, view.y + line},
                     fmt::format("at the ground, under box {}", middle + 1),
                     aligned(page.label(), Align::right));
  for (int e = 0; e < bars.size(); ++e) {
    const List<double>& loads = (*bars[e].loads)[frame];
    TextStyle text{.size = render::large_text, .color = bars[e].style.color, .bold = true};
    text.align = Align::right;
    page.canvas().text({view.x + view.width, view.y + (e + 2) * line},
                       fmt::format("{}: {}, {} N", bars[e].name, fixed(loads[0], 2), fixed(loads[middle], 2)),
                       text);
  }
}

/// SI's tower with loads beside it.
Camera draw_tower(Page& page, const Rect& rect, const TowerRuns& runs, const Snapshot& tower,
                  const List<Bars>& bars, int frame) {
  const Rect view = page.panel(rect, "SI's tower, and loads (N); tick: the weight above");
  Camera camera = fit(view, {{-1.2, -0.6}, {1.2, runs.settings.boxes + 0.4}});
  camera.center.x() = 0.5 * view.width / camera.scale - 1.2;  // the tower at the left
  draw_world(page, camera, tower, {.numbers = camera.scale >= 20, .contacts = false, .penetration = false});
  draw_bars(page, camera, runs, tower, bars, frame);
  return camera;
}

/// SI's tower with SI's loads and the stranger's.
void draw_question(Page& page, const Rect& rect, const TowerRuns& runs) {
  const List<Bars> all = bars_of(page, runs, runs.warm);
  List<Bars> bars = {all.front(), all.back()};
  bars[1].name = "stranger";
  bars[1].height = bars[0].height;
  draw_corner(page, draw_tower(page, rect, runs, runs.warm[1].frames[asked_step], bars, asked_step).viewport,
              runs, bars, asked_step);
}

/// The lowest load step by step, for all three engines: three dashed lines that make one.
Plot load_plot(const Page& page, const TowerRuns& runs, const List<EngineRun>& engines, int frame) {
  const TowerSettings& settings = runs.settings;
  Plot plot{.title = "load λ_{1} on the lowest box (N), step by step"};
  plot.x = {.title = "step", .min = 0, .max = settings.steps};
  plot.y = {.min = 0, .max = 1.15 * largest_load(runs)};
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  for (int e = 0; e < engines.size(); ++e) {
    List<double> lowest;
    for (const List<double>& loads : engines[e].loads) lowest.push_back(loads[0]);
    plot.series.push_back(over_steps(e == 2 ? "Box2D" : engines[e].name, styles[e], lowest));
    plot.series[e].markers = false;
  }
  const double weight = settings.boxes * settings.gravity;
  plot.goals.push_back({weight, fmt::format("the weight: {:g} N", weight)});
  plot.now = frame;
  return plot;
}

/// The largest difference of any load, step by step.
Series gap_series(const std::string& name, const SeriesStyle& style, const Loads& one, const Loads& other) {
  List<double> gaps;
  for (int k = 0; k < one.size(); ++k) {
    double largest = 0;
    for (int i = 0; i < one[k].size(); ++i) largest = std::max(largest, std::abs(one[k][i] - other[k][i]));
    gaps.push_back(largest);
  }
  Series series = over_steps(name, style, gaps);
  series.markers = false;
  return series;
}

/// How far the loads of PGS and Box2D are from SI's, and how far those are from the exact ones.
Plot gap_plot(const Page& page, const TowerRuns& runs, const List<EngineRun>& engines, int frame) {
  Plot plot{.title = "largest difference of any load (N), on a logarithmic axis"};
  plot.x = {.title = "step", .min = 0, .max = runs.settings.steps};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 1e-15, .max = 1e3};
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  List<double> weights;
  for (int i = runs.settings.boxes; i > 0; --i) weights.push_back(i * runs.settings.gravity);
  const Loads exact(engines[1].loads.size(), weights);
  plot.series = {gap_series("SI − exact", styles[1], engines[1].loads, exact),
                 gap_series("Box2D − SI", styles[2], engines[2].loads, engines[1].loads),
                 gap_series("PGS − SI", styles[0], engines[0].loads, engines[1].loads)};
  plot.now = frame;
  return plot;
}

void draw_step(Page& page, const TowerRuns& runs, const List<EngineRun>& engines, int frame) {
  const List<Rect> parts = in_columns(page, {0.48, {0.52, {1, 1}}});
  const List<Bars> bars = bars_of(page, runs, engines);
  draw_corner(page, draw_tower(page, parts[0], runs, engines[1].frames[frame], bars, frame).viewport, runs,
              bars, frame);
  draw_plot(page, parts[1], load_plot(page, runs, engines, frame));
  draw_plot(page, parts[2], gap_plot(page, runs, engines, frame));
}

Shot step_shot(const TowerRuns& runs, bool is_warm, int frame) {
  const List<EngineRun>& engines = is_warm ? runs.warm : runs.cold;
  const std::string start = is_warm ? "warm start" : "cold start";
  return {.state = fmt::format("{} · step {} · t = {:.2f} s", start, frame, frame * runs.settings.dt),
          .alt = fmt::format(
              "Step {}, {}: the lowest box carries {:.2f} N under PGS, {:.2f} N under SI and {:.2f} N "
              "under Box2D; SI's tower is {:.2f} m high.",
              frame, start, engines[0].loads[frame][0], engines[1].loads[frame][0],
              engines[2].loads[frame][0], engines[1].frames[frame].bodies.back().pose.position.y() + 0.5),
          .draw = [&runs, &engines, frame](Page& page) { draw_step(page, runs, engines, frame); }};
}

std::string answer_text(const TowerRuns& runs) {
  return fmt::format(
      "(3). What the ground gives then climbs by one contact a sweep: the load under box {} is late, that at "
      "the ground is not. (1) and (2) change no load by more than {} N; (4) changes the one at the ground, "
      "too, to {} N.",
      middle_box(runs) + 1, fixed(gap_to_box2d(runs), 5), fixed(runs.one_more.loads[asked_step][0], 2));
}

/// How far one load is from SI's under each of the four answers.
Plot guesses_plot(const Page& page, const TowerRuns& runs, const std::string& title, int interface) {
  Plot plot{.title = title + ": difference from SI's load (N)"};
  plot.x = {.title = "step", .min = 0, .max = runs.settings.steps};
  const double largest =
      1.1 * std::max({1.0, gap_of_orders(runs),
                      largest_gap(runs.warm[1].loads, runs.one_more.loads, runs.settings.steps)});
  plot.y = {.title = "", .min = -largest, .max = largest};
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  const List<SeriesStyle> neutral = render::neutral_styles(page.theme());
  const auto add = [&](const std::string& name, const SeriesStyle& style, const Loads& loads) {
    List<double> differences;
    for (int k = 0; k < loads.size(); ++k)
      differences.push_back(loads[k][interface] - runs.warm[1].loads[k][interface]);
    plot.series.push_back(over_steps(name, style, differences));
    plot.series.back().markers = false;
  };
  add(fmt::format("(4) {} sweeps", runs.settings.sweeps + 1), neutral[1], runs.one_more.loads);
  add("(3) top down", neutral[0], runs.from_top[1].loads);
  add("(1) single", styles[2], runs.warm[2].loads);
  add("(2) PGS", styles[0], runs.warm[0].loads);
  plot.cursor = asked_step;
  return plot;
}

void draw_answer(Page& page, const Rect& rect, const TowerRuns& runs) {
  const List<Rect> halves = in_rows(page, rect, {1, 1});
  const int middle = middle_box(runs);
  draw_plot(page, halves[0], guesses_plot(page, runs, "at the ground", 0));
  draw_plot(page, halves[1], guesses_plot(page, runs, fmt::format("under box {}", middle + 1), middle));
}

}  // namespace

List<Shot> tower_shots(const TowerRuns& runs) {
  const int last = runs.settings.steps, wrong = asked_step;
  List<Shot> shots = {question_shot(
      card(), {.state = fmt::format("after step {}", asked_step),
               .alt = fmt::format("A tower of {} boxes with the loads that SI and a stranger's program have "
                                  "found in step {}, and the question",
                                  runs.settings.boxes, asked_step),
               .scene = [&runs](Page& page, const Rect& rect) { draw_question(page, rect, runs); }})};
  for (const bool is_warm : {true, false}) {
    for (int k = 1; k <= last; ++k) {
      shots.push_back(step_shot(runs, is_warm, k));
      shots.back().key = k == last || (is_warm && k == wrong);
    }
  }
  shots.push_back(answer_shot(
      card(),
      {.state = "warm start",
       .alt = "Differences from SI's loads over the steps, one curve for each choice. At the ground only "
              "that of eleven sweeps leaves 0; under the box in the middle that from the top down does, too; "
              "and the answer.",
       .scene = [&runs](Page& page, const Rect& rect) { draw_answer(page, rect, runs); }},
      answer_text(runs)));
  return shots;
}

}  // namespace cairn::tower
