// One tower with the loads of three engines, and charts of these loads and of their differences.
#include "lesson.hpp"
#include "render/solver_style.hpp"

namespace cairn::tower {

namespace {

FixedList<SeriesStyle, 3> engine_styles(const Page& page) {
  return {page.theme().pgs, page.theme().si, page.theme().box2d};
}

/// Which engines' loads a picture tells.
enum class Shown { all, si_alone };

double largest_load(const TowerRuns& runs) {
  double largest = runs.settings.boxes * runs.settings.gravity;
  for (const List<double>& frame : runs.warm[1].loads)
    largest = std::max(largest, *std::max_element(frame.begin(), frame.end()));
  return largest;
}

/// Beside each box its load under each engine, one bar below the other, and a tick at the weight above.
void draw_bars(Page& page, const Camera& camera, const TowerRuns& runs, const List<EngineRun>& engines,
               int frame, Shown shown) {
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  const Rect& view = camera.viewport;
  const double left = camera.project({0.5, 0}).x() + 14, height = 0.26 * camera.scale;
  const double per_newton = (view.x + view.width - left) / (1.05 * largest_load(runs));
  for (int i = 0; i < runs.settings.boxes; ++i) {
    const double y = camera.project(engines[1].frames[frame].bodies[{i + 1}].pose.position).y();
    for (int e = 0; e < engines.size(); ++e) {
      if (shown == Shown::si_alone && e != 1) continue;
      page.canvas().rect({left, y + (e - 1.5) * height, engines[e].loads[frame][i] * per_newton, height},
                         {.fill = styles[e].color, .outline = page.theme().panel, .outline_width = 1});
    }
    const double tick = left + (runs.settings.boxes - i) * runs.settings.gravity * per_newton;
    page.canvas().line({tick, y - 1.6 * height}, {tick, y + 1.6 * height},
                       {.width = 2, .color = page.theme().exact.color});
  }
}

/// The box whose load is asked for, from 0.
int middle_box(const TowerRuns& runs) { return (runs.settings.boxes - 1) / 2; }

/// What SI has found at the ground and in the middle, and what is asked of Box2D.
void ask(Page& page, const Camera& camera, const TowerRuns& runs, const List<double>& loads) {
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  const Rect& view = camera.viewport;
  for (const int box : {0, middle_box(runs)}) {
    const double base = camera.project({0, box + 0.75}).y();
    const std::string known = fixed(loads[box], 2) + " N";
    for (int e = 1; e <= 2; ++e) {
      TextStyle text{.size = render::large_text, .color = styles[e].color, .bold = true};
      text.align = Align::right;
      page.canvas().text({view.x + view.width, base + (e - 1.5) * 1.3 * text.size + 0.35 * text.size},
                         fmt::format("{}: {}", e == 1 ? "SI" : "Box2D", e == 1 || box == 0 ? known : "? N"),
                         text);
    }
  }
}

/// SI's tower with the loads of all engines, and in the corner what each finds at the ground.
void draw_tower(Page& page, const Rect& rect, const TowerRuns& runs, const List<EngineRun>& engines,
                int frame, Shown shown) {
  const Rect view = page.panel(rect, "SI's tower, and loads (N); tick: the weight above");
  Camera camera = fit(view, {{-1.2, -0.6}, {1.2, runs.settings.boxes + 0.4}});
  camera.center.x() = 0.5 * view.width / camera.scale - 1.2;  // the tower at the left
  draw_world(page, camera, engines[1].frames[frame],
             {.numbers = camera.scale >= 20, .contacts = false, .penetration = false});
  draw_bars(page, camera, runs, engines, frame, shown);
  const FixedList<SeriesStyle, 3> styles = engine_styles(page);
  const double line = 1.4 * page.label().size;
  if (shown == Shown::si_alone) return ask(page, camera, runs, engines[1].loads[frame]);
  for (int e = 0; e < engines.size(); ++e) {
    TextStyle text{.size = render::large_text, .color = styles[e].color, .bold = true};
    text.align = Align::right;
    page.canvas().text({view.x + view.width, view.y + (e + 1) * line},
                       fmt::format("{}: {} N", engines[e].name, fixed(engines[e].loads[frame][0], 2)), text);
  }
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
  draw_tower(page, parts[0], runs, engines, frame, Shown::all);
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
      "{} N. From the top down, what the ground gives climbs by one contact in each sweep. In SI's order all "
      "loads of Box2D agree to {} N, the rounding of single precision.",
      fixed(runs.from_top[1].loads[1][middle_box(runs)], 2), significant(gap_to_box2d(runs), 2));
}

}  // namespace

List<Shot> tower_shots(const TowerRuns& runs) {
  const int last = runs.settings.steps, wrong = std::min(5, last);
  const auto draw_question = [&runs](Page& page, const Rect& rect) {
    draw_tower(page, rect, runs, runs.warm, 1, Shown::si_alone);
  };
  List<Shot> shots = {question_shot(
      card(), {.state = "after step 1",
               .alt = fmt::format("A tower of {} boxes with the loads that SI has found in step 1, question "
                                  "marks for Box2D, and the question",
                                  runs.settings.boxes),
               .scene = draw_question})};
  for (const bool is_warm : {true, false}) {
    for (int k = 1; k <= last; ++k) {
      shots.push_back(step_shot(runs, is_warm, k));
      shots.back().key = k == last || (is_warm && k == wrong);
    }
  }
  const auto draw_answer = [&runs, last](Page& page, const Rect& rect) {
    Plot plot = gap_plot(page, runs, runs.warm, last);
    plot.now = {};
    plot.series[0] = gap_series("top down − SI", render::neutral_styles(page.theme())[0],
                                runs.from_top[1].loads, runs.warm[1].loads);
    const double gap = gap_to_box2d(runs);
    plot.goals.push_back({gap, significant(gap, 2) + " N"});
    draw_plot(page, rect, plot);
  };
  shots.push_back(
      answer_shot(card(),
                  {.state = "warm start",
                   .alt = "Three curves over the steps: from the top down Box2D differs from SI by "
                          "some newtons, in the same order by some hundred thousandths, PGS by "
                          "less still; and the answer.",
                   .scene = draw_answer},
                  answer_text(runs)));
  return shots;
}

}  // namespace cairn::tower
