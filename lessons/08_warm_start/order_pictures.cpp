// How the error goes, step by step, and impulses that come to the wrong row.
#include "lesson.hpp"

namespace cairn::warm {

namespace {

constexpr double smallest_error = 1e-6;  // of the chart

/// |lambda_1 / W - 1| of every step, as long as `bound` stays above what the chart shows.
Series error_series(const List<List<double>>& loads, double weight, double bound) {
  Series series;
  for (int k = 1; k < loads.size(); ++k) {
    if (std::pow(bound, k) < smallest_error) break;
    series.add(k, std::abs(loads[k][0] / weight - 1));
  }
  return series;
}

void draw_errors(Page& page, const WarmStart& all) {
  const List<Rect> parts = in_columns(page, {0.62, 0.38});
  const StartSettings& settings = all.settings;
  const double share = share_left(settings.boxes, settings.sweeps);
  Series cold = error_series(all.cold.loads, settings.weight(), share);
  cold.style = start_styles(page.theme())[0];
  Series warm = error_series(all.warm.loads, settings.weight(), std::sqrt(share));
  warm.style = start_styles(page.theme())[1];
  Series bound{.style = page.theme().exact, .markers = false};
  for (const double k : warm.x) bound.add(k, std::pow(share, 0.5 * k));
  Plot plot{.title = fmt::format("|λ_{{1}} / {:g} N − 1| after each step", settings.weight())};
  plot.x = {.title = "step", .min = 0, .max = settings.steps};
  plot.y = {.scale = AxisScale::logarithmic, .min = smallest_error, .max = 2};
  plot.series = {cold, warm, bound};
  const int middle = cold.x.size() / 2;
  plot.labels = {{cold.x[middle], cold.y[middle], "cold: ρ^{s} per step"},
                 {bound.x[middle], bound.y[middle], "warm: below ρ^{s/2} per step"}};
  draw_plot(page, parts[0], plot);
  page.note(parts[1], "The price of memory",
            fmt::format("The {} sweeps of a step leave ρ^{{s}} = {:.3f} of what they find. Cold, the loads "
                        "converge at that rate, but the missing force is left as a speed: the tower sinks. "
                        "Warm, it is also missing from the first guess. So the error swings, and a step "
                        "leaves ρ^{{s/2}} = {:.3f} of it.",
                        settings.sweeps, share, std::sqrt(share)));
}

/// The step in which loads by number are most wrong, once the tower has come to rest.
int worst_guest_step(const WarmStart& all) {
  const List<List<double>>& loads = all.guest.by_number;
  int worst = loads.size() / 2;
  for (int k = worst; k < loads.size(); ++k) {
    const double weight = all.settings.weight();
    if (std::abs(loads[k][0] - weight) > std::abs(loads[worst][0] - weight)) worst = k;
  }
  return worst;
}

void draw_guest(Page& page, const WarmStart& all) {
  const List<Rect> parts = in_columns(page, {0.36, {0.64, {0.68, 0.32}}});
  const int step = worst_guest_step(all);
  const Rect inside = page.panel(parts[0], "");
  const Camera camera = fit(inside, {{-2.4, -0.6}, {1.2, all.settings.boxes + 0.4}});
  draw_world(page, camera, all.guest.frames[step],
             {.numbers = false, .contacts = false, .penetration = false});
  Plot plot{.title = "load λ_{1} on the lowest box (N)"};
  const int first = all.guest.by_key.size() / 4;  // once the first swings are over
  plot.x = {.title = "step", .min = first, .max = all.settings.steps};
  plot.series = {{.name = "by key", .style = start_styles(page.theme())[1]},
                 {.name = "by number", .style = start_styles(page.theme())[2], .markers = false}};
  Series touches{
      .name = "ball touches", .style = {page.theme().external, {}, Marker::triangle}, .line = false};
  for (int k = first; k < all.guest.by_key.size(); ++k) {
    plot.series[0].add(k, all.guest.by_key[k][0]);
    plot.series[1].add(k, all.guest.by_number[k][0]);
    if (!all.guest.ball_touches[k]) continue;
    touches.add(k, all.guest.by_number[k][0]);
  }
  plot.series.push_back(touches);
  plot.cursor = step;
  draw_plot(page, parts[1], plot);
  page.note(parts[2], "",
            "A ball bounces beside the tower and never touches it. While the ball touches the "
            "ground, its contact is the first row, and all others shift by one. Matched by number, this "
            "shakes the tower. Matched by key, not one bit of its loads changes.");
}

}  // namespace

List<Shot> order_shots(const WarmStart& all) {
  return {
      key_shot(all, "error against steps",
               "The error of the lowest load against steps, logarithmic: cold falls fast and smoothly, warm "
               "swings below a line that falls half as steeply.",
               draw_errors),
      key_shot(all, "a ball bounces beside it",
               "A tower with a ball beside it, and the lowest load by key, steady, and by number, shaken at "
               "every bounce.",
               draw_guest)};
}

}  // namespace cairn::warm
