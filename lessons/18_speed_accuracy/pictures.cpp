// The tower and its loads, sweep by sweep under four solvers; the question, and the answer.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/question.hpp"
#include "lessons/tower_panel.hpp"
#include "math/list.hpp"
#include "parts.hpp"
#include "render/plot.hpp"

namespace cairn::cost {

namespace {

using render::fixed;
using render::Page;
using render::Rect;

constexpr double least_asked = 1e-9;  // of the error
const FixedList<int, 8> shown = {1, 2, 5, 10, 20, 50, 100, 200};

const List<double>& lambda_after(const Curve& curve, int sweep) {
  return curve.lambda[std::min(sweep, curve.lambda.size() - 1)];
}

double error_after(const Curve& curve, int sweep) {
  return curve.error[std::min(sweep, curve.error.size() - 1)];
}

std::string error_text(double error) {
  if (error <= least_error) return "< 10^{−12}";
  return error > 5e-4 ? fixed(100 * error, 1) + " %" : render::significant(error, 2);
}

/// The tower; beside each box what it is given after so many sweeps of SI, and a tick at what it should be.
void draw_tower(Page& page, const Rect& rect, const CostRun& run, int sweep) {
  const Curve& curve = run.curves[si_curve];
  const List<double>& lambda = lambda_after(curve, sweep);
  const Rect inside = page.panel(rect, fmt::format("λ after {} sweeps of SI, tick: exact", sweep));
  draw_tower_loads(page, inside, run.tower, lambda,
                   {.box_weight = gravity,
                    .largest = exact_lambda(run.settings.boxes)[0],
                    .color = style_of(page, si_curve).color});
}

void draw_loads(Page& page, const Rect& rect, const CostRun& run, int which, int sweep) {
  const Curve& curve = run.curves[which];
  const List<double>& lambda = lambda_after(curve, sweep);
  const List<double> exact = exact_lambda(run.settings.boxes);
  const Rect inside = page.panel(rect, short_name(run, which));
  page.canvas().rect({rect.x, rect.y, rect.width, 4}, {.fill = style_of(page, which).color});
  const double line = page.value().size * 1.5;
  const double pitch = (inside.height - line) / exact.size();
  const double per_newton = (inside.width - 8) / (1.15 * exact[0]);
  for (int i = 0; i < exact.size(); ++i) {
    const double top = inside.y + line + pitch * (exact.size() - 1 - i);
    const double width = std::min(lambda[i] * per_newton, inside.width);
    page.canvas().rect(
        {inside.x, top + 0.2 * pitch, width, 0.6 * pitch},
        {.fill = style_of(page, which).color, .outline = page.theme().outline, .outline_width = 1});
    const double tick = inside.x + exact[i] * per_newton;
    page.canvas().line({tick, top + 0.05 * pitch}, {tick, top + 0.95 * pitch},
                       {.width = 2, .color = page.theme().exact.color});
  }
  render::TextStyle text = page.value();
  text.align = render::Align::right;
  page.canvas().text({inside.x + inside.width, inside.y + text.size},
                     "off: " + error_text(error_after(curve, sweep)), text);
}

render::Series series_of(const Page& page, const CostRun& run, int which, int sweeps) {
  const List<double>& error = run.curves[which].error;
  List<double> shown_errors;
  for (int k = 0; k <= sweeps && k < error.size(); ++k)
    shown_errors.push_back(std::max(error[k], least_error));
  return over_steps(short_name(run, which), style_of(page, which), shown_errors);
}

void draw_sweep(Page& page, const CostRun& run, int sweep) {
  const List<Rect> parts = rows(page.area(), {0.5, 0.5}, page.sizes().gap);
  const List<Rect> panels = columns(parts[0], {1, 1, 1, 1}, page.sizes().gap);
  render::Plot plot{.title = "largest error of λ, over the largest λ"};
  plot.x = {.title = "sweep", .min = 0, .max = sweep <= 20 ? 20.0 : kept_sweeps};
  plot.y = {.title = "", .scale = render::AxisScale::logarithmic, .min = 1e-6, .max = 2};
  if (sweep <= 20) plot.y = {.title = "", .min = 0, .max = 1.05};  // the first sweeps leave most of it
  for (int which = 0; which < run.curves.size(); ++which) {
    draw_loads(page, panels[which], run, which, sweep);
    plot.series.push_back(series_of(page, run, which, static_cast<int>(*plot.x.max)));
  }
  if (sweep > 20) plot.goals.push_back({0.01, "1 %"});
  plot.now = sweep;
  draw_plot(page, parts[1], plot);
}

Shot sweep_shot(const Runs& run, int sweep, bool key) {
  std::string alt = fmt::format("After {} sweeps the largest error is", sweep);
  for (int which = 0; which < run->curves.size(); ++which)
    alt += fmt::format(" {:.2g} with {},", error_after(run->curves[which], sweep), run->curves[which].name);
  alt.back() = '.';
  return {.state = fmt::format("sweep {}", sweep),
          .alt = alt,
          .draw = [run, sweep](Page& page) { draw_sweep(page, *run, sweep); },
          .key = key};
}

/// The tower, and SI's error until so many sweeps; behind them are those up to a billionth.
QuestionFrame moment(const Runs& run, int sweep, render::AxisScale scale, const std::string& state,
                     const std::string& alt) {
  const auto scene = [run, sweep, scale](Page& page, const Rect& rect) {
    const List<Rect> parts = columns(rect, {0.44, 0.56}, page.sizes().gap);
    draw_tower(page, parts[0], *run, sweep);
    const bool is_linear = scale == render::AxisScale::linear;
    render::Plot plot{.title = "largest error of λ, over the largest λ"};
    plot.x = {.title = "sweep", .min = 0, .max = std::max(sweep, 20)};
    plot.y = {.title = "", .scale = scale, .min = is_linear ? 0 : least_asked, .max = is_linear ? 1.05 : 2};
    plot.series.push_back(series_of(page, *run, si_curve, sweep));
    if (is_linear) plot.goals.push_back({0.01, "1 %"});
    draw_plot(page, parts[1], plot);
  };
  return {.state = state, .alt = alt, .scene = scene};
}

std::string answer_text(const CostRun& run) {
  const Curve& si = run.curves[si_curve];
  const int tenth = sweeps_to(si.error, 0.1);
  return fmt::format(
      "{} sweeps: each leaves the same {} of the error, however small it is. The first digit costs {}, the "
      "second {}, and so does every digit after it. With the best ω it is {}.",
      sweeps_to(si.error, least_asked), fixed(si.rate, 4), tenth, sweeps_to(si.error, 0.01) - tenth,
      fixed(std::log(10) / -std::log(run.best_omega - 1), 1));
}

}  // namespace

// SOR is SI with another factor, and momentum is given to PGS: each keeps its colour, and has a dash of its
// own.
render::SeriesStyle style_of(const Page& page, int curve) {
  if (curve == si_curve) return page.theme().si;
  if (curve == jacobi_curve) return page.theme().jacobi;
  if (curve == sor_curve) return {page.theme().si.color, {}, render::Marker::circle};
  return {page.theme().pgs.color, {2, 5}, render::Marker::triangle};
}

std::string short_name(const CostRun& run, int curve) {
  if (curve == jacobi_curve) return "Jacobi ½";
  if (curve == sor_curve) return fmt::format("ω = {}", fixed(run.omega, 2));
  return curve == si_curve ? "SI" : "momentum";
}

List<Shot> cost_shots(const CostRun& recorded) {
  const Runs run = std::make_shared<const CostRun>(recorded);
  List<Shot> shots;
  shots.push_back(question_shot(
      card(),
      moment(run, sweeps_to(run->curves[si_curve].error, 0.01), render::AxisScale::linear,
             "until 1 % is left",
             "A tower of boxes, its loads and SI's error until 1 % of it is left, and the question.")));
  for (const int sweep : shown)
    shots.push_back(sweep_shot(run, sweep, sweep == 1 || sweep == 10 || sweep == 50 || sweep == 200));
  for (const List<Shot>& more : {digit_shots(run), clock_shots(run)})
    shots.insert(shots.end(), more.begin(), more.end());
  shots.push_back(answer_shot(
      card(),
      moment(run, sweeps_to(run->curves[si_curve].error, least_asked), render::AxisScale::logarithmic,
             "answer",
             "SI's error until a billionth of it is left: a line on a logarithmic axis; and the answer."),
      answer_text(*run)));
  return shots;
}

}  // namespace cairn::cost
