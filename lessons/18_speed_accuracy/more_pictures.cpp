// Errors against sweeps and work, and tower sizes.
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
          draw_sizes)};
}

}  // namespace cairn::cost
