// Errors against sweeps and work; tower sizes, precision, the time of a row update.
#include "lesson.hpp"

namespace cairn::cost {

namespace {

constexpr double charted_sweeps = 200;  // of SI, and as many products
constexpr double last_error = 1e-6;

/// Every curve's errors against its sweeps, or against the products that these take: where each sweep leaves
/// the same share, a straight line.
void draw_digits(Page& page, const Rect& rect, const CostRun& run, bool is_work) {
  const std::string what = is_work ? "products" : "sweeps";
  const double work = is_work ? run.curves[si_curve].work : 1;
  Plot plot{.title = "error against " + what,
            .x = {.title = what, .min = 0, .max = charted_sweeps * work},
            .y = {.title = "", .scale = AxisScale::logarithmic, .min = last_error, .max = 2}};
  for (int which = 0; which < run.curves.size(); ++which) {
    const Curve& curve = run.curves[which];
    Series& series = plot.series.emplace_back();
    series.name = short_name(run, which);
    series.style = style_of(page, which);
    for (int k = 0; k < curve.error.size() && curve.error[k] > last_error / 10; ++k) {
      const double at = (is_work ? curve.work : 1) * k;
      if (at <= plot.x.max) series.add(at, curve.error[k]);
    }
  }
  if (is_work) {
    const double elimination = 5.0 * run.settings.boxes - 4;
    plot.front = {.x = {elimination, elimination}, .y = {last_error / 2, 2}};
    plot.labels = {{elimination, 1e-4, "elimination, all digits"}};
  }
  draw_plot(page, rect, plot);
}

void draw_sizes(Page& page, const CostRun& run) {
  const List<Rect> parts = in_columns(page, {0.56, {0.44, {0.42, 0.58}}});
  Plot plot{.title = "sweeps until 1 % is left"};
  plot.x = {.title = "boxes", .scale = AxisScale::logarithmic, .min = 2, .max = 30};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 3, .max = 3000};
  Series square{.name = "1.78 n²", .style = page.theme().exact, .markers = false};
  square.style.marker = Marker::none;
  for (const double n : {2.0, 30.0}) square.add(n, 1.78 * n * n);
  Series si{.name = "SI", .style = style_of(page, si_curve)};
  Series sor{.name = "SOR", .style = style_of(page, sor_curve)};
  TableView table{.header = {"boxes", "SI", "SOR", "ratio"}};
  for (const SizeCost& size : run.sizes) {
    si.add(size.boxes, size.si);
    sor.add(size.boxes, size.sor);
    table.rows.push_back({fmt::format("{}", size.boxes), fmt::format("{}", size.si),
                          fmt::format("{}", size.sor), fixed(static_cast<double>(size.si) / size.sor, 1)});
  }
  plot.series = {square, si, sor};
  draw_plot(page, parts[0], plot);
  page.table(parts[1], "sweeps until 1 % is left", table);
  page.note(parts[2], "The scene decides",
            "A sweep passes loads on from box to box. Twice as many boxes take four times "
            "the sweeps, and each sweep has twice the rows. With the best ω they take only twice the sweeps, "
            "but nobody knows the best ω of a pile.");
}

void draw_precision(Page& page, const CostRun& run) {
  const List<Rect> halves = in_rows(page, {0.74, 0.26});
  Plot plot{.title = "error of λ, sweep by sweep"};
  plot.x = {.title = "sweep", .min = 0, .max = run.pgs.error.size()};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 1e-15, .max = 2};
  const List<SeriesStyle> looks = render::neutral_styles(page.theme());
  plot.series = {over_steps("float", looks[2], run.single.error),
                 over_steps("double", looks[0], run.pgs.error)};
  draw_plot(page, halves[0], plot);
  const std::string least = significant(run.single.error.back(), 2);
  page.note(
      halves[1], "The last digits",
      fmt::format(
          "Both lose the same share of the error in every sweep. In float the error stops shrinking at {}: "
          "each sweep rounds, and a rounding error spreads through the tower like any other. A "
          "game needs far fewer digits; sweeps after that are wasted.",
          least));
}

Plot update_plot(const Page& page, const CostRun& run) {
  Plot plot{.title = "time of one row update (ns), this machine"};
  plot.x = {.title = "rows", .scale = AxisScale::logarithmic, .min = 8, .max = 250};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 5};
  const Color color = page.theme().pgs.color;
  const FixedList<std::pair<int, SeriesStyle>, 4> chosen = {
      {{si_time, page.theme().si},
       {sparse_time, {color, {2, 5}, Marker::diamond}},
       {dense_time, page.theme().pgs},
       {naive_time, {color, {10, 5, 2, 5}, Marker::triangle}}}};
  for (const auto& one : chosen) {
    const SolverTime& time = run.times[one.first];
    Series series{.name = time.name, .style = one.second};
    for (int k = 0; k < timed_rows.size(); ++k) series.add(timed_rows[k], time.nanoseconds[k]);
    plot.series.push_back(series);
  }
  return plot;
}

TableView update_table(const CostRun& run) {
  TableView table{.header = {"ns", "10 rows", "50", "200"}};
  for (const SolverTime& time : run.times) {
    table.rows.push_back({time.name});
    for (int k = 0; k < timed_rows.size(); ++k) {
      table.rows.back().push_back(significant(time.nanoseconds[k], 2));
    }
  }
  return table;
}

void draw_updates(Page& page, const CostRun& run) {
  const List<Rect> parts = in_columns(page, {0.5, {0.5, {0.64, 0.36}}});
  draw_plot(page, parts[0], update_plot(page, run));
  page.table(parts[1], "one row update of a tower, preparation included", update_table(run));
  page.note(parts[2], "The machine",
            "A row of a dense A has as many entries as there are rows, and naive PGS computes all velocities "
            "for each λ: both grow with the tower. The last line is written for this tower only and looks "
            "nothing up.");
}

}  // namespace

List<Shot> digit_shots(const CostRun& run) {
  const auto draw_both = [&run](Page& page) {
    const List<Rect> halves = in_rows(page, {1, 1});
    draw_digits(page, halves[0], run, false);
    draw_digits(page, halves[1], run, true);
  };
  return {
      {.state = "sweeps, and work",
       .alt = "Errors of four solvers against sweeps and against products: SI and Jacobi creep, SOR and "
              "momentum fall; by products momentum falls behind SOR.",
       .draw = draw_both,
       .key = true},
      key_shot(
          run, "3, 5, 10, 20 boxes",
          "Sweeps until 1 % is left against the number of boxes: SI's grow like its square, those with the "
          "best ω like the number.",
          draw_sizes),
      key_shot(run, "float, double",
               fmt::format("Errors of SI in float and in double, sweep by sweep: float ends at {:.1e}.",
                           run.single.error.back()),
               draw_precision),
      key_shot(
          run, "time of a row update",
          "Time of one row update against the number of rows: the same for SI and sparse PGS at any size, "
          "growing with the rows for dense and naive PGS.",
          draw_updates)};
}

}  // namespace cairn::cost
