// Errors against sweeps, work and time; tower sizes, precision, warm starts.
#include <fmt/format.h>

#include <algorithm>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/plot.hpp"

namespace cairn::cost {

namespace {

using render::AxisScale;
using render::fixed;
using render::Page;
using render::Rect;

/// Every error of a curve against `unit` times its sweep; sparsely, as the axis is logarithmic.
render::Series against(const Page& page, const CostRun& run, int which, double unit) {
  render::Series series{.name = short_name(run, which), .style = style_of(page, which)};
  const Curve& curve = run.curves[which];
  double next = 1;
  for (int k = 1; k < curve.error.size(); ++k) {
    if (k < next && k + 1 < curve.error.size()) continue;
    next = std::max(k + 1.0, k * 1.03);
    series.x.push_back(unit * k);
    series.y.push_back(std::max(curve.error[k], least_error));
  }
  return series;
}

/// A chart with a note below it.
List<Rect> chart_and_note(const Page& page) { return rows(page.area(), {0.74, 0.26}, page.sizes().gap); }

/// One more curve, and its name where it passes 10^-4: the ends of the curves are close to each other.
void add_curve(render::Plot& plot, const Page& page, const CostRun& run, int which, double unit) {
  render::Series& series = plot.series.emplace_back(against(page, run, which, unit));
  series.name.clear();
  const int sweep = sweeps_to(run.curves[which].error, 1e-4);
  if (sweep > 0) plot.labels.push_back({unit * sweep, 1e-4, short_name(run, which)});
}

render::Axis error_axis(double least) {
  return {.title = "", .scale = AxisScale::logarithmic, .min = least, .max = 2};
}

void draw_digits(Page& page, const CostRun& run) {
  const List<Rect> halves = rows(page.area(), {1, 1}, page.sizes().gap);
  render::Plot sweeps{.title = "error of λ against sweeps",
                      .x = {.title = "sweeps", .scale = AxisScale::logarithmic},
                      .y = error_axis(1e-6)};
  render::Plot work{.title = "error of λ against multiply-adds",
                    .x = {.title = "multiply-adds", .scale = AxisScale::logarithmic},
                    .y = error_axis(1e-6)};
  for (int which = 0; which < run.curves.size(); ++which) {
    add_curve(sweeps, page, run, which, 1);
    add_curve(work, page, run, which, run.curves[which].work);
  }
  draw_plot(page, halves[0], sweeps);
  const double n = run.settings.boxes;
  const double elimination = n * n * n / 3 + n * n;
  work.front = {.x = {elimination, elimination}, .y = {1e-6, 2}};
  work.labels.push_back({elimination, 1e-4, "elimination: all digits"});
  draw_plot(page, halves[1], work);
}

void draw_sizes(Page& page, const CostRun& run) {
  const List<Rect> halves = columns(page.area(), {0.56, 0.44}, page.sizes().gap);
  render::Plot plot{.title = "sweeps until 1 % is left"};
  plot.x = {.title = "boxes", .scale = AxisScale::logarithmic, .min = 2, .max = 30};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 1, .max = 3000};
  render::Series square{.name = "1.78 n²", .style = page.theme().exact, .markers = false};
  square.style.marker = render::Marker::none;
  for (const double n : {2.0, 30.0}) {
    square.x.push_back(n);
    square.y.push_back(1.78 * n * n);
  }
  render::Series si{.name = "SI", .style = style_of(page, si_curve)};
  render::Series sor{.name = "best ω", .style = style_of(page, sor_curve)};
  render::TableView table{.header = {"boxes", "SI", "best ω", "ratio"}};
  for (const SizeCost& size : run.sizes) {
    si.x.push_back(size.boxes);
    si.y.push_back(size.si);
    sor.x.push_back(size.boxes);
    sor.y.push_back(size.sor);
    table.rows.push_back({fmt::format("{}", size.boxes), fmt::format("{}", size.si),
                          fmt::format("{}", size.sor), fixed(static_cast<double>(size.si) / size.sor, 1)});
  }
  plot.series = {square, si, sor};
  draw_plot(page, halves[0], plot);
  const List<Rect> right = rows(halves[1], {0.38, 0.62}, page.sizes().gap);
  page.table(right[0], "sweeps until 1 % is left", table);
  page.note(right[1], "The scene decides",
            "A sweep passes loads on from box to box. Twice as many boxes take four times "
            "the sweeps, and each sweep has twice the rows. With the best ω it is only "
            "twice the sweeps, but nobody knows the best ω of a pile.");
}

void draw_precision(Page& page, const CostRun& run) {
  const List<Rect> halves = chart_and_note(page);
  render::Plot plot{.title = "error of λ, sweep by sweep"};
  plot.x = {.title = "sweep", .min = 0, .max = run.pgs.error.size()};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 1e-15, .max = 2};
  plot.series = {over_steps("float", page.theme().si, run.single.error),
                 over_steps("double", page.theme().pgs, run.pgs.error)};
  draw_plot(page, halves[0], plot);
  const std::string least = render::significant(run.single.error.back(), 2);
  page.note(
      halves[1], "The last digits",
      fmt::format("Both lose the same share of the error in every sweep. In float the digits end at {}: "
                  "each sweep rounds, and a rounding spreads through the tower like any other error. A "
                  "game needs far fewer digits; sweeps after that are wasted.",
                  least));
}

void draw_frames(Page& page, const CostRun& run) {
  const List<Rect> halves = chart_and_note(page);
  render::Plot plot{.title = fmt::format("error of λ after each step, {} sweep{} a step", run.settings.sweeps,
                                         run.settings.sweeps == 1 ? "" : "s")};
  plot.x = {.title = "step", .min = 0, .max = frames};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .max = 2};
  render::SeriesStyle cold = page.theme().si;
  cold.dash = {2, 5};
  cold.marker = render::Marker::diamond;
  plot.series = {over_steps("warm", page.theme().si, run.frames.warm),
                 over_steps("cold", cold, run.frames.cold)};
  plot.goals.push_back({0.01, "1 %"});
  draw_plot(page, halves[0], plot);
  page.note(halves[1], "Spread over steps",
            "Each step starts with what the last one found, so a digit is paid in instalments. The "
            "price: the first steps leave the boxes a speed, and the loads swing about the exact "
            "ones. Cold, the loads become right only because the boxes fall fast enough.");
}

render::Plot update_plot(const Page& page, const CostRun& run) {
  render::Plot plot{.title = "time of one row update (ns), this machine"};
  plot.x = {.title = "rows", .scale = AxisScale::logarithmic, .min = 8, .max = 250};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 5};
  const render::Color color = page.theme().pgs.color;
  const FixedList<std::pair<int, render::SeriesStyle>, 4> chosen = {
      {{si_time, page.theme().si},
       {sparse_time, {color, {2, 5}, render::Marker::diamond}},
       {dense_time, page.theme().pgs},
       {naive_time, {color, {10, 5, 2, 5}, render::Marker::triangle}}}};
  for (const auto& one : chosen) {
    const SolverTime& time = run.times[one.first];
    render::Series series{.name = time.name, .style = one.second};
    for (int k = 0; k < timed_rows.size(); ++k) {
      series.x.push_back(timed_rows[k]);
      series.y.push_back(time.nanoseconds[k]);
    }
    plot.series.push_back(series);
  }
  return plot;
}

render::TableView update_table(const CostRun& run) {
  render::TableView table{.header = {"ns", "10 rows", "50", "200"}};
  for (const SolverTime& time : run.times) {
    table.rows.push_back({time.name});
    for (int k = 0; k < timed_rows.size(); ++k) {
      table.rows.back().push_back(render::significant(time.nanoseconds[k], 2));
    }
  }
  return table;
}

void draw_updates(Page& page, const CostRun& run) {
  const List<Rect> halves = columns(page.area(), {0.5, 0.5}, page.sizes().gap);
  draw_plot(page, halves[0], update_plot(page, run));
  const List<Rect> right = rows(halves[1], {0.64, 0.36}, page.sizes().gap);
  page.table(right[0], "one row update of a tower, preparation included", update_table(run));
  page.note(
      right[1], "The machine",
      "A row of a dense A has as many entries as there are rows, and naive PGS computes all velocities "
      "for each λ: both grow with the tower. The last line knows this tower by heart and looks nothing up.");
}

void draw_clock(Page& page, const CostRun& run) {
  const List<Rect> parts = chart_and_note(page);
  render::Plot plot{.title = "error of λ against time (µs), this machine",
                    .x = {.title = "µs", .scale = AxisScale::logarithmic},
                    .y = error_axis(least_error)};
  const FixedList<int, 4> clock = {si_time, jacobi_time, si_time, accelerated_time};
  const int size = run.settings.boxes > 20 ? 1 : 0;
  for (int which = 0; which < run.curves.size(); ++which) {
    const double sweep = 1e-3 * run.times[clock[which]].nanoseconds[size] * run.settings.boxes;
    add_curve(plot, page, run, which, sweep);
  }
  draw_plot(page, parts[0], plot);
  const double factor = run.times[accelerated_time].nanoseconds[size] / run.times[si_time].nanoseconds[size];
  page.note(
      parts[1], "Which is the fastest?",
      fmt::format("A sweep with momentum takes {} times as long as one of SI. Whether that pays depends "
                  "on the digits that are asked for, and on the tower: look where curves cross.",
                  fixed(factor, 1)));
}

}  // namespace

List<Shot> digit_shots(const Runs& run) {
  return {
      {.state = "sweeps, and work",
       .alt = "Errors of four solvers against sweeps and against multiply-adds: SI and Jacobi creep, SOR and "
              "momentum fall.",
       .draw = [run](Page& page) { draw_digits(page, *run); },
       .key = true},
      {.state = "3, 5, 10, 20 boxes",
       .alt =
           "Sweeps until 1 % is left against the number of boxes: SI's grow like its square, those with the "
           "best ω like the number.",
       .draw = [run](Page& page) { draw_sizes(page, *run); },
       .key = true},
      {.state = "float, double",
       .alt = fmt::format("Errors of SI in float and in double, sweep by sweep: float ends at {:.1e}.",
                          run->single.error.back()),
       .draw = [run](Page& page) { draw_precision(page, *run); },
       .key = true},
      {.state = "step after step",
       .alt = "Errors after each of 50 steps, warm and cold, with few sweeps a step.",
       .draw = [run](Page& page) { draw_frames(page, *run); },
       .key = true}};
}

List<Shot> clock_shots(const Runs& run) {
  return {
      {.state = "time of a row update",
       .alt =
           "Time of one row update against the number of rows: the same for SI and sparse PGS at any size, "
           "growing with the rows for dense and naive PGS.",
       .draw = [run](Page& page) { draw_updates(page, *run); },
       .key = true},
      {.state = "error against time",
       .alt = "Errors of four solvers against the time that they take on this machine.",
       .draw = [run](Page& page) { draw_clock(page, *run); },
       .key = true}};
}

}  // namespace cairn::cost
