// Pendulums that leave their circle.
#include "lesson.hpp"

namespace cairn::drift {

namespace {

/// The true circle of the pendulum, its lower half and a little more.
List<Vec2<double>> true_circle() {
  List<Vec2<double>> points;
  for (int i = 0; i <= 96; ++i) {
    const double angle = std::numbers::pi * (1 - 0.05 + 1.1 * i / 96);
    points.emplace_back(rod_length * std::cos(angle), rod_length * std::sin(angle));
  }
  return points;
}

/// What the body has gone through in the last `steps` steps.
List<Vec2<double>> path_of(const RodRun& run, int step, int steps) {
  List<Vec2<double>> points;
  for (int k = std::max(0, step - steps); k <= step; ++k) {
    points.push_back(run.steps[k].bodies[{1}].pose.position);
  }
  return points;
}

std::string millimetres(double metres) {
  return fixed(1000 * metres, std::abs(metres) < 0.0095 ? 1 : 0) + " mm";
}

void draw_pendulum(Page& page, const Rect& rect, const DriftRuns& all, const RodRun& run, int step) {
  const SeriesStyle style = beta_style(page.theme(), run.beta);
  const Rect field =
      draw_solver_panel(page, rect, style, beta_name(run.beta), "c = " + millimetres(run.error[step]));
  const Camera camera = fit(field, {{-1.7, -1.7}, {1.7, 0.15}});
  draw_trail(page, camera, true_circle(), {.color = page.theme().inactive, .dash = {3, 4}});
  const int second = static_cast<int>(std::lround(1 / all.settings.dt));
  draw_trail(page, camera, path_of(run, step, 2 * second), {.color = style.color});
  draw_world(page, camera, run.steps[step], {.numbers = false});
}

void draw_swing_errors(Page& page, const Rect& rect, const DriftRuns& all, int step) {
  Plot plot{.title = "|c|: how much too long or too short the rod is (m)"};
  plot.x = {.title = "t (s)", .min = 0, .max = swing_time};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 1e-4, .max = 1};
  const int stride = std::max(1, all.swings[0].steps.size() / 250);
  for (const RodRun& run : all.swings) {
    Series series{.name = beta_name(run.beta), .style = beta_style(page.theme(), run.beta), .markers = false};
    for (int k = 1; k <= step; k += stride)
      series.add(k * all.settings.dt, std::max(std::abs(run.error[k]), 1e-5));
    plot.series.push_back(series);
  }
  draw_plot(page, rect, plot);
}

void draw_swing(Page& page, const DriftRuns& all, int step) {
  const List<Rect> parts = in_rows(page, {0.5, 0.5});
  const List<Rect> panels = in_columns(page, parts[0], List<Cut>(all.swings.size(), 1.0));
  for (int i = 0; i < all.swings.size(); ++i) draw_pendulum(page, panels[i], all, all.swings[i], step);
  draw_swing_errors(page, parts[1], all, step);
}

Shot swing_shot(const DriftRuns& all, int step) {
  std::string alt = fmt::format(
      "Pendulums after {:.1f} s, drawn over the true circle: the rod is too long by", step * all.settings.dt);
  for (const RodRun& run : all.swings) {
    alt += fmt::format(" {:.4f} m with β = {:g};", run.error[step], run.beta);
  }
  alt.back() = '.';
  return {.state = fmt::format("pendulum · t = {} s", fixed(step * all.settings.dt, 1)),
          .alt = alt,
          .draw = [&all, step](Page& page) { draw_swing(page, all, step); }};
}

}  // namespace

List<Shot> swing_shots(const DriftRuns& all) {
  const int last = all.swings[0].steps.size() - 1;
  List<Shot> shots;
  for (int frame = 1; frame <= 50; ++frame) shots.push_back(swing_shot(all, frame * last / 50));
  shots.back().key = true;
  return shots;
}

}  // namespace cairn::drift
