// Errors against sweeps and work.
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

}  // namespace

Shot work_shot(const CostRun& run) {
  return key_shot(run, "sweeps, and work",
                  "Errors of four solvers against sweeps and against products: SI and Jacobi creep, SOR and "
                  "momentum fall; by products momentum falls behind SOR.",
                  [](Page& page, const CostRun& all) {
                    const List<Rect> halves = in_rows(page, {1, 1});
                    draw_digits(page, halves[0], all, false);
                    draw_digits(page, halves[1], all, true);
                  });
}

}  // namespace cairn::cost
