// Each row update of both solvers, then each sweep, and the digits in which they part.
#include "lesson.hpp"

namespace cairn::twice {

namespace {

const char* const title_of_pairs = "λ of rows 1 to 20 (N), a pair for each:";

/// The row whose λ is farthest from the answer after a sweep of PGS.
struct Farthest {
  int row = 0;
  double off = 0;  // [%] of the largest λ
};

Farthest farthest(const TwiceRun& run, int sweep) {
  Farthest found;
  double largest = 0;
  for (int i = 0; i < run.exact.size(); ++i) {
    const double off = 100 * std::abs(run.pgs[sweep][i] - run.exact[i]);
    if (off > found.off) found = {i, off};
    largest = std::max(largest, std::abs(run.exact[i]));
  }
  found.off /= largest;
  return found;
}

Moment after_row(const TwiceRun& run, int row) {
  Moment moment{
      .pgs = run.pgs[0], .si = run.si[0], .active = row, .unclamped = run.si[0], .exact = run.exact};
  for (int i = 0; i <= row; ++i) {
    moment.pgs[i] = run.steps[i].pgs;
    moment.si[i] = run.steps[i].si;
    moment.unclamped[i] = run.steps[i].by_27;
  }
  return moment;
}

std::string power(double value) { return value == 0 ? "0" : significant(value, 2); }

/// What either solver reads for this row.
std::string reads(const TwiceRun& run, int row) {
  int entries = 0;
  for (int j = 0; j < run.problem.row_count(); ++j) entries += run.system.A(row, j) != 0;
  const ConstraintRow<double>& line = run.problem.rows[row];
  return fmt::format(
      "PGS reads {} entries of the framed row, and the λ that belong to them. SI reads two velocities, of "
      "bodies {} and {}: j·v = {} m/s.",
      entries, line.a.index + 1, line.b.index + 1, fixed(run.steps[row].row_velocity, 3));
}

void draw_row(Page& page, const TwiceRun& run, int row) {
  const List<Rect> parts = in_columns(page, {{0.36, {0.76, 0.24}}, {0.64, {0.56, 0.44}}});
  draw_system(page, parts[0], run, row);
  page.note(parts[1], "", reads(run, row));
  draw_pairs(page, parts[2], title_of_pairs, after_row(run, row), range_of(run));
  const RowStep& step = run.steps[row];
  const auto digits = [](double value) { return all_digits(value, 17); };
  const std::string clamped = step.si == step.by_27 ? "" : "; clamped to 0";
  draw_digits(page, parts[3],
              fmt::format("the λ of row {} before clamping, computed in three ways (N)", row + 1),
              {{"(27) SI: from v", digits(step.by_27)},
               {"(29) in between", digits(step.by_29)},
               {"(28) PGS: from A, b", digits(step.by_28)}},
              fmt::format("(27) − (28) = {} N{}", power(step.by_27 - step.by_28), clamped));
}

void draw_sweep(Page& page, const TwiceRun& run, int sweep) {
  const List<Rect> parts = in_rows(page, {0.6, {0.4, {0.6, 0.4}}});
  const Farthest far = farthest(run, sweep);
  draw_pairs(page, parts[0], title_of_pairs,
             {.pgs = run.pgs[sweep], .si = run.si[sweep], .active = far.row, .exact = run.exact},
             range_of(run));
  TableView table;
  table.header = {"precision", "largest |λ_{PGS} − λ_{SI}|", "of the largest λ"};
  for (const PrecisionRun& precision : run.precisions) {
    const double difference = precision.difference[sweep];
    table.rows.push_back({precision.name, power(difference) + " N", power(difference / precision.scale)});
  }
  page.table(parts[1], fmt::format("after sweep {}", sweep), table);
  const auto spacings = [&](int p) {
    const PrecisionRun& precision = run.precisions[p];
    return fixed(precision.difference[sweep] / precision.scale / precision.epsilon, 0);
  };
  page.note(parts[2], "",
            fmt::format("Row {} is farthest from its tick, by {} % of the largest λ. The two have parted by "
                        "{}, {} and {} spacings ε of their numbers.",
                        far.row + 1, fixed(far.off, 2), spacings(0), spacings(1), spacings(2)));
}

/// What each solver looks at in one update of the row that is farthest off, and how far PGS has come, or
/// both.
void draw_both(Page& page, const Rect& rect, const TwiceRun& run, bool shows_si) {
  const List<Rect> parts = in_rows(page, rect, {0.6, 0.4});
  const List<Rect> upper = in_columns(page, parts[0], {{0.58, {0.5, 0.5}}, 0.42});
  const int sweep = std::min(asked_sweeps, run.settings.sweeps);
  const Farthest far = farthest(run, sweep);
  page.equation(upper[0], {.number = "PGS reads λ of the other strong lines",
                           .symbols = "λ_{i} ← (b_{i} − Σ_{j≠i} A_{ij} λ_{j}) / A_{ii}"});
  page.equation(upper[1], {.number = "SI reads velocities of the two lit bodies",
                           .symbols = "λ_{i} ← λ_{i} + (ζ − j·v) / (j M^{−1} j^{T} Δt)"});
  draw_bodies(page, upper[2], run, far.row);
  Moment moment{.pgs = run.pgs[sweep], .active = far.row, .exact = run.exact};
  if (shows_si) moment.si = run.si[sweep];
  const std::string title =
      shows_si
          ? fmt::format("λ (N) after {} sweeps; row {} is {} % off:", sweep, far.row + 1, fixed(far.off, 0))
          : fmt::format("λ (N) after {} sweeps; largest error: row {}", sweep, far.row + 1);
  draw_pairs(page, parts[1], title, moment, range_of(run));
}

void draw_differences(Page& page, const Rect& rect, const TwiceRun& run) {
  const Color color = page.theme().outline;
  const List<SeriesStyle> styles = {
      {color, {}, Marker::circle}, {color, {}, Marker::square}, {color, {}, Marker::diamond}};
  Plot plot{.title = "largest |λ_{PGS} − λ_{SI}| over the largest λ, with the spacing ε of each precision"};
  plot.x = {.title = "sweep", .min = 0, .max = run.settings.sweeps};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 1e-21, .max = 1e-4};
  for (int p = 0; p < run.precisions.size(); ++p) {
    const PrecisionRun& precision = run.precisions[p];
    Series series{.name = precision.name, .style = styles[p]};
    for (int k = 1; k < precision.difference.size(); ++k)
      series.add(k, precision.difference[k] / precision.scale);
    plot.series.push_back(series);
    plot.goals.push_back({precision.epsilon, fmt::format("ε = {}", significant(precision.epsilon, 2))});
  }
  draw_plot(page, rect, plot);
}

Shot row_shot(const TwiceRun& run, int row) {
  const RowStep& step = run.steps[row];
  return {.state = fmt::format("sweep 1 · row {} of {}", row + 1, run.problem.row_count()),
          .alt = fmt::format(
              "Row {} of the first sweep: SI arrives at {:.12g} N by (27), PGS at {:.12g} N by (28).",
              row + 1, step.by_27, step.by_28),
          .draw = [&run, row](Page& page) { draw_row(page, run, row); },
          .key = row == 15};  // it is clamped, for most seeds
}

Shot sweep_shot(const TwiceRun& run, int sweep) {
  const double difference = run.precisions[1].difference[sweep];
  return {.state = fmt::format("after sweep {} of {}", sweep, run.settings.sweeps),
          .alt = fmt::format("After sweep {} the impulses of PGS and SI differ by {:.1e} N at most.", sweep,
                             difference),
          .draw = [&run, sweep](Page& page) { draw_sweep(page, run, sweep); }};
}

/// Where the digits part in two precisions, and how the difference goes on.
void draw_rounding(Page& page, const TwiceRun& run) {
  const List<Rect> parts = in_rows(page, {0.23, 0.23, 0.54});
  for (int p = 0; p < 2; ++p) {
    const PrecisionRun& precision = run.precisions[p];
    draw_digits(page, parts[p],
                fmt::format("{}: λ (N) of row {}, which differs most", precision.name, precision.row + 1),
                {{"PGS", precision.pgs}, {"SI", precision.si}}, "");
  }
  draw_differences(page, parts[2], run);
}

}  // namespace

List<Shot> twice_shots(const TwiceRun& run) {
  const int last = run.settings.sweeps;
  List<Shot> shots = {question_shot(
      card(), {.state = "after ten sweeps of PGS",
               .alt = "Eight bodies and the twenty rows between them, what PGS and what SI look at in one "
                      "update, the λ of PGS after ten sweeps, and the question.",
               .scene = [&run](Page& page, const Rect& rect) { draw_both(page, rect, run, false); }})};
  for (int row = 0; row < run.problem.row_count(); ++row) shots.push_back(row_shot(run, row));
  for (int sweep = 2; sweep <= last; ++sweep) shots.push_back(sweep_shot(run, sweep));
  shots.push_back(key_shot(run, fmt::format("rounding, after {} sweeps", last),
                           "The digits in which both solvers agree, in float and in double, and their "
                           "differences against sweeps in three precisions.",
                           draw_rounding));
  shots.push_back(answer_shot(
      card(),
      {.state = "after ten sweeps of both",
       .alt = "The same bodies, rows and updates; SI has the same λ as PGS in every row; and the answer.",
       .scene = [&run](Page& page, const Rect& rect) { draw_both(page, rect, run, true); }},
      fmt::format("{}: every λ is the same, and both are {} % off. They are one algorithm. The velocities "
                  "that SI reads hold what all rows have given so far.",
                  fixed(run.pgs_off / run.si_off, 0), fixed(run.si_off, 0))));
  return shots;
}

}  // namespace cairn::twice
