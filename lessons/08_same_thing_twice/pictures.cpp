// The matrix that PGS sees, the impulses of both solvers in pairs, and the digits in which they differ.
#include "parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "render/matrix.hpp"
#include "render/plot.hpp"

namespace cairn::twice {

namespace {

using render::fixed;
using render::Page;
using render::Rect;

using Run = std::shared_ptr<const TwiceRun>;

/// Lambda of both solvers at one moment [N].
struct Moment {
  PerRow<double> pgs = {};
  PerRow<double> si = {};
  double largest =
      1;  // what fills the chart: one value for all frames of the first sweep, one for all later ones
  int active = -1;
};

double largest_of_first_sweep(const TwiceRun& run) {
  double largest = 0;
  for (const RowStep& step : run.steps) largest = std::max(largest, std::abs(step.si));
  return largest;
}

double largest_of_all_sweeps(const TwiceRun& run) {
  double largest = 0;
  for (const PerRow<double>& sweep : run.si) {
    for (const double value : sweep) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

Moment after_row(const TwiceRun& run, int row) {
  Moment moment{.pgs = run.pgs[0], .si = run.si[0], .largest = largest_of_first_sweep(run), .active = row};
  for (int i = 0; i <= row; ++i) {
    moment.pgs[i] = run.steps[i].pgs;
    moment.si[i] = run.steps[i].si;
  }
  return moment;
}

Moment after_sweep(const TwiceRun& run, int sweep) {
  return {.pgs = run.pgs[sweep],
          .si = run.si[sweep],
          .largest = sweep > 0 ? largest_of_all_sweeps(run) : largest_of_first_sweep(run)};
}

/// What colours mean, from the right end of a line to the left.
void draw_key(Page& page, const Rect& inside, const List<std::pair<std::string, render::Color>>& entries) {
  const double size = page.label().size;
  double x = inside.x + inside.width;
  for (const auto& [name, color] : entries) {
    x -= page.canvas().text_width(name, page.label());
    page.canvas().text({x, inside.y + size}, name, page.label());
    x -= 18;
    page.canvas().rect({x, inside.y + size - 12, 12, 12},
                       {.fill = color, .outline = page.theme().outline, .outline_width = 1});
    x -= 18;
  }
}

/// Two bars for every row, side by side: they never part.
void draw_pairs(Page& page, const Rect& rect, const Moment& moment) {
  render::Canvas& canvas = page.canvas();
  const Rect inside = page.panel(rect, "accumulated λ of each row (N)");
  draw_key(page, {inside.x, rect.y + 8, inside.width, 20},
           {{"SI", page.theme().si.color}, {"PGS", page.theme().pgs.color}});
  const double largest = moment.largest;
  render::TextStyle tick = page.tick();
  tick.align = render::Align::right;
  const double gutter = canvas.text_width("−000", tick) + 6;
  const Rect field = {inside.x + gutter, inside.y + 6, inside.width - gutter, inside.height - tick.size - 14};
  const double zero = field.y + field.height / 2;
  const double per_newton = 0.5 * field.height / largest;
  const double value = std::pow(10, std::floor(std::log10(largest)));
  const double level = std::floor(largest / value) * value;
  for (const double y : {-level, 0.0, level}) {
    const double at = zero - y * per_newton;
    canvas.line({field.x, at}, {field.x + field.width, at}, {.width = 1, .color = page.theme().grid});
    canvas.text({field.x - 6, at + 0.35 * tick.size}, fixed(y, 0), tick);
  }
  const double pitch = field.width / moment.si.size();
  for (int i = 0; i < moment.si.size(); ++i) {
    const bool active = i == moment.active;
    const double left = field.x + i * pitch;
    const auto bar = [&](double x, double lambda, render::Color color) {
      canvas.rect({x, zero - std::max(lambda, 0.0) * per_newton, 0.4 * pitch, std::abs(lambda) * per_newton},
                  {.fill = color, .outline = page.theme().outline, .outline_width = active ? 2.0 : 0.0});
    };
    bar(left + 0.1 * pitch, moment.pgs[i], page.theme().pgs.color);
    bar(left + 0.5 * pitch, moment.si[i], page.theme().si.color);
    if (i % 5 != 4 && !active && i != 0) continue;
    render::TextStyle name = page.tick();
    name.align = render::Align::center;
    name.bold = active;
    const bool beside = moment.active >= 0 && !active && std::abs(i - moment.active) == 1;
    if (!beside)
      canvas.text({left + 0.5 * pitch, inside.y + inside.height - 4}, fmt::format("{}", i + 1), name);
  }
  canvas.line({field.x, zero}, {field.x + field.width, zero}, {.width = 1.5, .color = page.theme().outline});
}

void draw_system(Page& page, const Rect& rect, const TwiceRun& run, int active) {
  render::MatrixView view{
      .title = "A = J M^{−1} J^{T} (1/kg)", .values = run.system.A, .active_row = active, .numbers = false};
  for (int i = 1; i <= run.problem.row_count(); ++i) {
    const std::string name = i == 1 || i % 5 == 0 ? fmt::format("{}", i) : "";
    view.row_names.push_back(name);
    view.column_names.push_back(name);
  }
  draw_matrix(page, rect, view);
  const double largest = run.system.A.cwiseAbs().maxCoeff();
  draw_key(page, rect,
           {{fixed(-largest, 1), page.theme().negative},
            {fixed(largest, 1, render::Sign::always), page.theme().positive}});
}

/// Matrix left, pairs right on top; returns what is free below the pairs.
Rect draw_moment(Page& page, const TwiceRun& run, const Moment& moment) {
  const List<Rect> halves = columns(page.area(), {0.46, 0.54}, page.sizes().gap);
  draw_system(page, halves[0], run, moment.active);
  const List<Rect> panels = rows(halves[1], {0.56, 0.44}, page.sizes().gap);
  draw_pairs(page, panels[0], moment);
  return panels[1];
}

/// All 17 digits, so that the last ones show where two accounts part.
std::string all_digits(double value) {
  std::string text = fmt::format("{:.16g}", value);
  if (text.front() == '-') text = "−" + text.substr(1);
  return text;
}

std::string power(double value) { return value == 0 ? "0" : render::significant(value, 2); }

void draw_row(Page& page, const TwiceRun& run, int row) {
  const Moment moment = after_row(run, row);
  const Rect panel = draw_moment(page, run, moment);
  const RowStep& step = run.steps[row];
  render::TableView table;
  table.header = {"the same row, three ways", "λ (N)"};
  table.rows = {{"(27) SI: from v", all_digits(step.by_27)},
                {"(29) in between", all_digits(step.by_29)},
                {"(28) PGS: from A, b", all_digits(step.by_28)},
                {"(27) − (28)", power(step.by_27 - step.by_28)},
                {"λ after clamping", all_digits(step.si)}};
  page.table(panel, fmt::format("row {} of {}", row + 1, run.problem.row_count()), table);
}

void draw_sweep(Page& page, const TwiceRun& run, int sweep) {
  const Rect panel = draw_moment(page, run, after_sweep(run, sweep));
  render::TableView table;
  table.header = {"precision", "largest |λ_{PGS} − λ_{SI}|", "of the largest λ"};
  for (const PrecisionRun& precision : run.precisions) {
    const double difference = precision.difference[sweep];
    table.rows.push_back({precision.name, power(difference) + " N", power(difference / precision.scale)});
  }
  page.table(panel, fmt::format("after sweep {}", sweep), table);
}

void draw_differences(Page& page, const Rect& rect, const TwiceRun& run) {
  const render::Color color = page.theme().outline;
  const List<render::SeriesStyle> styles = {{color, {}, render::Marker::circle},
                                            {color, {10, 6}, render::Marker::square},
                                            {color, {2, 5}, render::Marker::diamond}};
  render::Plot plot{
      .title = "largest |λ_{PGS} − λ_{SI}| over the largest λ, with the spacing ε of each precision"};
  plot.x = {.title = "sweep", .min = 0, .max = run.settings.sweeps};
  plot.y = {.title = "", .scale = render::AxisScale::logarithmic, .min = 1e-21, .max = 1e-4};
  for (int p = 0; p < run.precisions.size(); ++p) {
    const PrecisionRun& precision = run.precisions[p];
    render::Series series{.name = precision.name, .style = styles[p]};
    for (int k = 1; k < precision.difference.size(); ++k) {
      series.x.push_back(k);
      series.y.push_back(precision.difference[k] / precision.scale);
    }
    plot.series.push_back(series);
    plot.goals.push_back(
        {precision.epsilon, fmt::format("ε = {}", render::significant(precision.epsilon, 2))});
  }
  draw_plot(page, rect, plot);
}

Shot row_shot(const Run& run, int row) {
  const RowStep& step = run->steps[row];
  const std::set<int> keys = {0, 1, 14, 15, 19};  // the last but one is clamped, for most seeds
  return {.state = fmt::format("sweep 1 · row {} of {}", row + 1, run->problem.row_count()),
          .alt = fmt::format(
              "Row {} of the first sweep: SI arrives at {:.12g} N by (27), PGS at {:.12g} N by (28).",
              row + 1, step.by_27, step.by_28),
          .draw = [run, row](Page& page) { draw_row(page, *run, row); },
          .key = keys.contains(row)};
}

Shot sweep_shot(const Run& run, int sweep) {
  const double difference = run->precisions[1].difference[sweep];
  return {.state = fmt::format("after sweep {} of {}", sweep, run->settings.sweeps),
          .alt = fmt::format("After sweep {} the impulses of PGS and SI differ by {:.1e} N at most.", sweep,
                             difference),
          .draw = [run, sweep](Page& page) { draw_sweep(page, *run, sweep); },
          .key = sweep == 10 || sweep == run->settings.sweeps};
}

}  // namespace

List<Shot> twice_shots(const TwiceRun& recorded) {
  const Run run = std::make_shared<const TwiceRun>(recorded);
  const int last = run->settings.sweeps;
  List<Shot> shots = {question_shot(
      card(), {.state = "before the first sweep",
               .alt = "The matrix A of a random problem of twenty rows, and the question.",
               .scene = [run](Page& page, const Rect& rect) { draw_system(page, rect, *run, -1); }})};
  for (int row = 0; row < run->problem.row_count(); ++row) shots.push_back(row_shot(run, row));
  for (int sweep = 2; sweep <= last; ++sweep) shots.push_back(sweep_shot(run, sweep));
  shots.push_back(
      {.state = fmt::format("{} sweeps, three precisions", last),
       .alt = "Differences of PGS and SI against sweeps in float, double and long double: each stays near "
              "the spacing of its numbers.",
       .draw = [run](Page& page) { draw_differences(page, page.area(), *run); },
       .key = true});
  shots.push_back(answer_shot(
      card(),
      {.state = fmt::format("after sweep {0} of {0}", last),
       .alt = "The differences of both solvers in three precisions, and the answer.",
       .scene = [run](Page& page, const Rect& rect) { draw_differences(page, rect, *run); }},
      fmt::format(
          "{} They are one algorithm, but each solver adds its terms in another order, and each addition is "
          "rounded. After sweep {} they differ by {} of the largest λ in single precision, in double "
          "precision by {}.",
          run->precisions[0].difference.back() > 0 ? "No." : "Here they are.", last,
          power(run->precisions[0].difference.back() / run->precisions[0].scale),
          power(run->precisions[1].difference.back() / run->precisions[1].scale))));
  return shots;
}

}  // namespace cairn::twice
