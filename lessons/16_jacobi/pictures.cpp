// The box on its feet: who pushes how hard, the sum of it, and the speed that it leaves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "parts.hpp"
#include "render/bars.hpp"
#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn::everybody {

namespace {

using render::fixed;
using render::Page;
using render::Point;
using render::Rect;

using Feet = std::shared_ptr<const FeetRun>;

const double box_middle = 0.62;  // [m] as the snapshot has it
const int shown_sweeps = 6;      // in the plot of speeds: behind them all but one are at rest

/// The box with what each foot has given so far, and how fast it moves.
void draw_feet(Page& page, const Rect& rect, const FeetRun& run, int sweep) {
  const Rect inside = page.panel(rect, "");
  const render::Camera camera = render::fit(inside, {{-0.85, -0.1}, {0.85, 1.35}});
  draw_world(page, camera, run.snapshot, {.numbers = false, .contacts = false});
  const FeetHistory& plain = history_of(run, Method::plain);
  const double weight = box_mass * gravity;
  const render::ArrowScale forces{
      .pixels_per_unit = 0.75 * camera.scale / weight, .longest = 0.9 * camera.scale, .unit = "N"};
  const List<double>& lambda = plain.lambda[sweep];
  const bool labels = lambda.size() <= 4;
  for (int i = 0; i < lambda.size(); ++i) {
    if (!(lambda[i] > 0)) continue;
    draw_arrow(page, camera, forces,
               {.tail = {run.problem.rows[i].jacobian_b.z(), box_middle - 0.5},
                .value = {0, lambda[i]},
                .label = labels ? fixed(lambda[i], 1) : ""});
  }
  const double fastest = gravity * time_step * std::max(1.0, run.answer - 1);
  const render::ArrowScale speeds{
      .pixels_per_unit = 0.5 * camera.scale / fastest, .longest = camera.scale, .unit = "m/s"};
  const double speed = plain.speed[sweep];
  draw_arrow(
      page, camera, speeds,
      {.kind = render::ArrowKind::velocity, .tail = {0.66, box_middle}, .value = {0, speed}, .label = ""});
  render::TextStyle style = page.value();
  style.align = render::Align::right;
  page.canvas().text(Point(inside.x + inside.width, inside.y + style.size),
                     fmt::format("v = {} m/s", fixed(speed, 3, render::Sign::always)), style);
}

void draw_lambda(Page& page, const Rect& rect, const FeetRun& run, int sweep) {
  const FeetHistory& plain = history_of(run, Method::plain);
  const List<double>& now = plain.lambda[sweep];
  const List<double> none(now.size(), 0.0);
  const List<double>& before = sweep > 0 ? plain.lambda[sweep - 1] : none;
  const double weight = box_mass * gravity;
  render::BarChart chart{.title = "λ of each foot (N)", .largest = weight * std::max(run.answer, 1.2)};
  chart.decimals = 1;
  for (int i = 0; i < now.size(); ++i) {
    chart.bars.push_back(
        {.name = fmt::format("foot {}", i + 1), .before = before[i], .added = now[i] - before[i]});
  }
  const double sum = together(before);
  chart.bars.push_back({.name = "together",
                        .before = sum,
                        .added = together(now) - sum,
                        .exact = weight,
                        .active = sweep > 0});
  draw_bars(page, rect, chart);
}

/// The box left, the bars right; returns what is free below the bars.
Rect draw_moment(Page& page, const FeetRun& run, int sweep) {
  const List<Rect> halves = columns(page.area(), {0.42, 0.58}, page.sizes().gap);
  draw_feet(page, halves[0], run, sweep);
  const List<Rect> right = rows(halves[1], {0.57, 0.43}, page.sizes().gap);
  draw_lambda(page, right[0], run, sweep);
  return right[1];
}

void draw_sweep(Page& page, const FeetRun& run, int sweep) {
  const Rect rest = draw_moment(page, run, sweep);
  const FeetHistory& plain = history_of(run, Method::plain);
  const double before = plain.lambda[sweep - 1][0];
  const double after = plain.lambda[sweep][0];
  const double speed = plain.speed[sweep - 1];
  page.equation(
      rest,
      {.number = "eq (22), foot 1; the others do the same at the same time",
       .symbols = "λ ← max(0, λ − j·v / (A_{11} Δt))",
       .numbers = fmt::format("= max(0, {} − {} / ({} × {:g}))", fixed(before, 2),
                              speed < 0 ? "(" + fixed(speed, 3) + ")" : fixed(speed, 3),
                              fixed(inverse_effective_mass(run.problem, run.problem.rows[0]), 4), time_step),
       .result = fmt::format("= {} N", fixed(after, 2)),
       .algorithm = fmt::format("then v: {} → {} m/s", fixed(speed, 3), fixed(plain.speed[sweep], 3)),
       .color = page.theme().normal});
}

Shot sweep_shot(const Feet& run, int sweep) {
  const FeetHistory& plain = history_of(*run, Method::plain);
  return {.state = fmt::format("plain Jacobi · sweep {}", sweep),
          .alt = fmt::format("Plain Jacobi after sweep {}: the feet push with {:.1f} N together, the weight "
                             "being 60 N, and the box moves at {:.3f} m/s upwards.",
                             sweep, together(plain.lambda[sweep]), plain.speed[sweep]),
          .draw = [run, sweep](Page& page) { draw_sweep(page, *run, sweep); },
          .key = sweep <= 3};
}

/// The four methods' speeds, and the number that decides.
void draw_speeds(Page& page, const FeetRun& run) {
  const List<Rect> parts = rows(page.area(), {0.62, 0.38}, page.sizes().gap);
  render::Plot plot{.title = "speed of the box after each sweep (m/s)"};
  plot.x = {.title = "sweep"};
  plot.y = {.title = ""};
  for (const FeetHistory& history : run.histories) {
    List<double> first = history.speed;
    first.resize(std::min(shown_sweeps + 1, first.size()));
    plot.series.push_back(over_steps(method_name(history.method, run.settings.omega),
                                     style_of(page.theme(), history.method), first));
  }
  draw_plot(page, parts[0], plot);
  render::TableView table;
  table.header = {"method", "the speed", "q = ω Σ c", "left after 5"};
  table.text_columns = 2;
  for (const FeetHistory& history : run.histories) {
    const bool in_turn = history.method == Method::sequential;
    const double taken = taken_at_once(run, history.method);
    const std::string verdict = taken > 2   ? "repeats for ever"
                                : taken > 1 ? "overshoots, converges"
                                            : "converges";
    table.rows.push_back({method_name(history.method, run.settings.omega), in_turn ? "converges" : verdict,
                          in_turn ? "·" : fixed(taken, 3),
                          fixed(100 * std::abs(history.speed[5]) / (gravity * time_step), 2) + " %"});
  }
  const List<Rect> below = columns(parts[1], {0.6, 0.4}, page.sizes().gap);
  page.table(below[0], "", table);
  page.note(below[1], "What decides",
            "One sweep leaves 1 − q of the speed. q = 1: done at once; q < 2: "
            "converges; q > 2: grows, or never ends.");
}

List<Shot> feet_shots(const FeetRun& feet) {
  const Feet run = std::make_shared<const FeetRun>(feet);
  List<Shot> shots;
  shots.push_back(question_shot(
      card(), {.state = "before the first sweep",
               .alt = "A box on feet, all of them idle, and the question.",
               .scene = [run](Page& page, const Rect& rect) { draw_feet(page, rect, *run, 0); }}));
  for (int sweep = 1; sweep <= run->settings.sweeps; ++sweep) shots.push_back(sweep_shot(run, sweep));
  shots.push_back(
      {.state = fmt::format("four methods, {} sweeps", std::min(shown_sweeps, run->settings.sweeps)),
       .alt = "Speed of the box against sweeps: plain Jacobi, damped, with split masses, and SI; below it "
              "the share q that one sweep of each removes.",
       .draw = [run](Page& page) { draw_speeds(page, *run); },
       .key = true});
  return shots;
}

/// "43.6 + 60.0 + 43.6", where there is room for so many.
std::string summands(const List<double>& lambda) {
  if (lambda.size() > 4) return fmt::format("{} feet", lambda.size());
  std::string text;
  for (const double each : lambda) text += (text.empty() ? "" : " + ") + fixed(each, 1);
  return text;
}

Shot last_shot(const Feet& run) {
  const List<double>& first = history_of(*run, Method::plain).lambda[1];
  const std::string text = fmt::format(
      "{} N: {}. Each foot stops the whole fall, as if it were alone, and the box is thrown up. Damped, or "
      "with "
      "split masses, Jacobi converges.",
      fixed(together(first), 1), summands(first));
  return answer_shot(card(),
                     {.state = "after the first sweep",
                      .alt = "The box after the first sweep, with what each foot has given, and the answer.",
                      .scene = [run](Page& page, const Rect& rect) { draw_feet(page, rect, *run, 1); }},
                     text);
}

}  // namespace

std::string method_name(Method method, double omega) {
  switch (method) {
    case Method::plain:
      return "Jacobi";
    case Method::damped:
      return fmt::format("Jacobi, ω = {:.2g}", omega);
    case Method::split:
      return "Jacobi, split";
    case Method::sequential:
      break;
  }
  return "SI";
}

render::SeriesStyle style_of(const render::Theme& theme, Method method) {
  render::SeriesStyle style = theme.jacobi;
  switch (method) {
    case Method::plain:
      return style;
    case Method::damped:
      style.dash = {12, 5};
      style.marker = render::Marker::circle;
      return style;
    case Method::split:
      style.dash = {};
      style.marker = render::Marker::triangle;
      return style;
    case Method::sequential:
      break;
  }
  return theme.si;
}

List<Shot> everybody_shots(const FeetRun& feet, const PileRun& pile) {
  List<Shot> shots = feet_shots(feet);
  for (Shot& shot : pile_shots(pile)) shots.push_back(std::move(shot));
  shots.push_back(last_shot(std::make_shared<const FeetRun>(feet)));
  return shots;
}

}  // namespace cairn::everybody
