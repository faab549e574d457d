// Two stacks of two boxes: the load that each sweep finds, and how many sweeps any ratio of masses takes.
#include "lesson.hpp"

#include "render/lint.hpp"
#include "render/solver_style.hpp"

namespace cairn::edges {

namespace {

std::string sweeps_text(int count) { return fmt::format("{} sweep{}", count, count == 1 ? "" : "s"); }

const FixedList<int, 8> map_sweeps = {1, 3, 10, 30, 100, 300, 1000, 3000};

/// The style of the stack with the heavy box above, and of the other.
SeriesStyle style_of(const Page& page, double ratio) {
  return render::neutral_styles(page.theme())[ratio >= 1 ? 0 : 1];
}

/// The load on the ground as a column that fills up to what both boxes weigh.
void draw_load(Page& page, const Camera& camera, const RatioRun& run, int sweep) {
  const double weight = weight_of(run.ratio), load = run.load[sweep][0];
  const Point left = camera.project({0.75, 0}), full = camera.project({1, 2});
  const double level = left.y() - load / weight * (left.y() - full.y()), width = full.x() - left.x();
  page.canvas().rect({left.x(), level, width, left.y() - level}, {.fill = page.theme().normal});
  page.canvas().rect({left.x(), full.y(), width, left.y() - full.y()},
                     {.outline = page.theme().outline, .outline_width = page.sizes().axis});
  TextStyle text = page.value();
  page.canvas().text({left.x(), full.y() - 0.5 * text.size}, fmt::format("right: {:g} N", weight), text);
  text.bold = true;
  if (sweep == 0) return;
  page.canvas().text(
      {full.x() + 0.5 * text.size, std::min(left.y() - 0.3 * text.size, level + 0.9 * text.size)},
      significant(load, 4) + " N", text);
}

/// Left of a stack, which contact a sweep visits first, and which second.
void draw_visits(Page& page, const Camera& camera) {
  const TextStyle text = aligned(page.label(), Align::right);
  for (const int contact : {0, 1}) {
    const Point at = camera.project({-0.5, static_cast<double>(contact)}),
                from = camera.project({-0.85, contact + 0.3});
    page.canvas().line(from, at, {.width = page.sizes().axis, .color = page.theme().secondary_text});
    page.canvas().text(from + Point(-4, text.size / 3), contact == 0 ? "visited first" : "visited second",
                       text);
  }
}

/// One stack, its masses written on its boxes, and beside it the load on the ground.
void draw_stack(Page& page, const Rect& rect, const RatioRun& run, int sweep, const std::string& count) {
  const Rect inside = draw_solver_panel(page, rect, style_of(page, run.ratio), name_of(run.ratio), count);
  const Camera camera = fit(inside, {{sweep == 0 ? -2.1 : -0.7, -0.25}, {sweep == 0 ? 2.1 : 2.2, 2.25}});
  page.canvas().push_clip(inside);
  draw_boxes(page, camera, snapshot(two_boxes_scene(run.ratio)), run.ratio);
  draw_load(page, camera, run, sweep);
  if (sweep == 0) draw_visits(page, camera);
  page.canvas().pop_clip();
}

/// The two stacks with the load on the ground after a sweep, or once it is right; `counts` stand above them.
void draw_stacks(Page& page, const Rect& rect, const ExtremesRun& run, int sweep,
                 const List<std::string>& counts) {
  const List<Rect> panels = in_columns(page, rect, {1, 1});
  const RatioRun& heavy = run_of(run.ratios, run.settings.ratio);
  const RatioRun& light = run_of(run.ratios, 1 / run.settings.ratio);
  draw_stack(page, panels[0], heavy, std::min(sweep, heavy.counted), counts[0]);
  draw_stack(page, panels[1], light, std::min(sweep, light.counted), counts[1]);
}

/// The error of the stack with the heavy box above, and where it is right; the other is right after a sweep.
void draw_errors(Page& page, const Rect& rect, const ExtremesRun& run, int sweep) {
  const RatioRun& heavy = run_of(run.ratios, run.settings.ratio);
  const int last = heavy.counted;
  Plot plot{.title = "error of the load on the ground (%), " + name_of(heavy.ratio)};
  plot.x = {.title = "sweep", .min = 0, .max = 1.08 * last};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 0.5, .max = 120};
  Series& series = plot.series.emplace_back();
  series.style = style_of(page, heavy.ratio);
  series.markers = false;
  for (int k = 0; k < heavy.error.size() && 100 * heavy.error[k] > 0.5; ++k)
    series.add(k, 100 * heavy.error[k]);
  if (sweep >= last)
    plot.labels.push_back({static_cast<double>(last), 100 * heavy.error[last], sweeps_text(last)});
  plot.now = sweep;
  plot.goals.push_back({100 * goal, "1 %"});
  draw_plot(page, rect, plot);
}

Equation equation_of(const Page& page, const ExtremesRun& run, int sweep) {
  const RatioRun& heavy = run_of(run.ratios, run.settings.ratio);
  const double jv = heavy.speed_jv[sweep][0];
  return {.number = "eq (22), row 1 of " + name_of(heavy.ratio),
          .symbols = "Δλ_{1} = (ζ − j·v) / (A_{11} Δt)",
          .numbers = fmt::format("= (0 − ({})) / (1 × {:g})", significant(jv, 4), time_step),
          .result = fmt::format("= {} N", fixed(-jv / time_step, 3)),
          .algorithm = fmt::format("λ_{{1}}: {} → {} N", fixed(heavy.load[sweep - 1][0], 2),
                                   fixed(heavy.load[sweep][0], 2)),
          .color = page.theme().normal};
}

/// The sweeps that each stack has taken to 1 %, or has taken so far.
List<std::string> counts_at(const ExtremesRun& run, int sweep) {
  List<std::string> counts;
  for (const double ratio : {run.settings.ratio, 1 / run.settings.ratio})
    counts.push_back(sweeps_text(std::min(sweep, run_of(run.ratios, ratio).counted)));
  return counts;
}

void draw_sweep(Page& page, const ExtremesRun& run, int sweep) {
  const List<Rect> parts = in_columns(page, {{0.54, {0.6, 0.4}}, 0.46});
  draw_stacks(page, parts[0], run, sweep, counts_at(run, sweep));
  draw_errors(page, parts[2], run, sweep);
  page.equation(parts[1], equation_of(page, run, sweep));
}

Shot sweep_shot(const ExtremesRun& run, int sweep, bool key) {
  const RatioRun& heavy = run_of(run.ratios, run.settings.ratio);
  const RatioRun& light = run_of(run.ratios, 1 / run.settings.ratio);
  const double found = sweep < light.error.size() ? 1 - light.error[sweep] : 1;
  return {.state = fmt::format("sweep {}", sweep),
          .alt = fmt::format("After sweep {}: {} has found {:.1f} % of the load on the ground, {} {:.1f} %.",
                             sweep, name_of(heavy.ratio), 100 * (1 - heavy.error[sweep]),
                             name_of(light.ratio), 100 * found),
          .draw = [&run, sweep](Page& page) { draw_sweep(page, run, sweep); },
          .key = key};
}

MatrixView map_of(const ExtremesRun& run) {
  MatrixView view{.title = "error left (%) after so many sweeps"};
  view.colors = MatrixColors::magnitude;
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
  Plot plot{.title = "sweeps to 1 %"};
  plot.x = {.title = "mass above / mass below", .scale = AxisScale::logarithmic};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 0.7, .max = 1e5};
  Series formula{.name = "", .style = page.theme().exact, .markers = false};
  Series counted{.name = "", .style = page.theme().exact, .line = false};
  counted.style.marker = Marker::square;
  for (int i = 0; i <= 70; ++i) {
    const double ratio = std::pow(10, -3 + i / 10.0);
    formula.add(ratio, std::max(1.0, std::log(goal) / std::log(rate_by_formula(ratio))));
  }
  for (const RatioRun& each : run.ratios) {
    if (each.ratio > 10000 || each.ratio < 0.001) continue;
    counted.add(each.ratio, each.counted);
  }
  plot.series = {formula, counted};
  draw_plot(page, rect, plot);
}

void draw_map(Page& page, const ExtremesRun& run) {
  const List<Rect> parts = in_columns(page, {0.54, {0.46, {0.62, 0.38}}});
  draw_matrix(page, page.panel(parts[0], ""), map_of(run));
  draw_needed(page, parts[1], run);
  page.note(parts[2], "What decides",
            "A sweep leaves R / (1 + R) of the error, with R = mass above / mass below. The line is "
            "ln 100 / ln(1 + 1/R), about 4.6 R; the squares are measured.");
}

/// The two stacks, sweep by sweep, and the map of all ratios.
List<Shot> ratio_shots(const ExtremesRun& run) {
  const int last = run_of(run.ratios, run.settings.ratio).counted;
  List<Shot> shots;
  for (const int sweep : {1, 2, 3, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000}) {
    if (sweep < last) shots.push_back(sweep_shot(run, sweep, sweep == 1 || sweep == 10));
  }
  shots.push_back(sweep_shot(run, last, true));
  shots.push_back(
      key_shot(run, "all masses",
               "A map of the error that is left, by ratio of masses and number of sweeps, and the "
               "sweeps that each ratio takes to 1 %: about 4.6 times the ratio.",
               draw_map));
  return shots;
}

}  // namespace

std::string name_of(double ratio) {
  return ratio >= 1 ? fmt::format("{:g} kg on 1 kg", ratio) : fmt::format("1 kg on {:g} kg", 1 / ratio);
}

void draw_boxes(Page& page, const Camera& camera, const Snapshot& now, double ratio) {
  draw_world(page, camera, now, {.numbers = false, .contacts = false, .penetration = false});
  const List<double> masses = masses_of(ratio);
  for (int i = 0; i < 2; ++i) {
    const Vec2<double>& middle = now.bodies[{i + 1}].pose.position;
    const Point corner = camera.project(middle + Vec2<double>(-0.5, 0.5));
    const Color fill = masses[i] > 1 ? page.theme().static_hatch : page.theme().body;
    page.canvas().rect(
        {corner.x(), corner.y(), camera.scale, camera.scale},
        {.fill = fill, .outline = page.theme().outline, .outline_width = page.sizes().outline});
    TextStyle text = camera.scale < 80 ? page.tick() : page.label();
    text.color = render::ink_on(fill), text.bold = true, text.align = Align::center;
    page.canvas().text(camera.project(middle) + Point(0, text.size / 3), fmt::format("{:g} kg", masses[i]),
                       text);
  }
}

List<Shot> extremes_shots(const ExtremesRun& run) {
  const int last = run_of(run.ratios, run.settings.ratio).counted;
  const QuestionFrame asked{.state = "before the first sweep",
                            .alt = fmt::format("Two stacks of two boxes, {} and {}, and the question",
                                               name_of(run.settings.ratio), name_of(1 / run.settings.ratio)),
                            .scene =
                                [&run](Page& page, const Rect& rect) {
                                  draw_stacks(page, rect, run, 0, {"? sweeps", "? sweeps"});
                                },
                            .place = ScenePlace::above};
  const List<std::string> counts = counts_at(run, last);
  const QuestionFrame answered{
      .state = "the answer",
      .alt = fmt::format(
          "Both stacks with their loads found, and their errors sweep by sweep: one is right to 1 % "
          "after {}, the other after {}.",
          counts[0], counts[1]),
      .scene = [&run, last, counts](Page& page, const Rect& rect) {
        const List<Rect> parts = in_rows(page, rect, {1, 1});
        draw_stacks(page, parts[0], run, last, counts);
        draw_errors(page, parts[1], run, last);
      }};
  List<Shot> shots = {question_shot(card(), asked)};
  for (const List<Shot>& part : {ratio_shots(run), step_shots(run)})
    shots.insert(shots.end(), part.begin(), part.end());
  shots.push_back(answer_shot(
      card(), answered,
      fmt::format("{} with the heavy box above, {} with the light one. The ground acts through the "
                  "light box, so a sweep leaves R\u00a0/\u00a0(1\u00a0+\u00a0R) of the error. With "
                  "the heavy box below, the first guess is nearly right.",
                  counts[0], counts[1])));
  return shots;
}

}  // namespace cairn::edges
