// What becomes of the box, and how it depends on its feet.
#include "lesson.hpp"

namespace cairn::feet {

namespace {

constexpr int outline_steps = 8;  // between the outlines of earlier poses

double height_at(const List<Snapshot>& motion, int step) {
  return 1000 * (motion[step].bodies[{1}].pose.position.y() - motion[0].bodies[{1}].pose.position.y());
}

void draw_motion(Page& page, const Rect& rect, const List<Snapshot>& motion, int step, Clamped clamped) {
  const Rect inside = clamp_panel(page, rect, clamped);
  const Camera camera = fit(inside, {{-1.3, -0.1}, {1.3, 1.5}});
  page.canvas().push_clip(inside);
  List<Snapshot> earlier;
  for (int k = 0; k < step; k += outline_steps) earlier.push_back(motion[k]);
  draw_ghosts(page, camera, earlier);
  draw_world(page, camera, motion[step], {.numbers = false, .contacts = false, .penetration = false});
  page.canvas().pop_clip();
}

Series heights(const Page& page, const List<Snapshot>& motion, Clamped clamped) {
  Series series{.name = clamped == Clamped::sum ? "the sum" : "each push",
                .style = style_of(page.theme(), clamped)};
  for (int k = 0; k < motion.size(); ++k) series.add(k * time_step, height_at(motion, k));
  return series;
}

void draw_step(Page& page, const FeetRun& run, int step) {
  const List<Rect> parts = in_rows(page, {{0.56, {0.5, 0.5}}, 0.44});
  draw_motion(page, parts[0], run.hop, step, Clamped::increment);
  draw_motion(page, parts[1], run.still, step, Clamped::sum);
  Plot plot{.title = fmt::format("how far the middle of the box has risen (mm): {} at most",
                                 fixed(1000 * run.hop_height, 0))};
  plot.x = {.title = "t (s)", .min = 0, .max = motion_steps * time_step};
  plot.series = {heights(page, run.hop, Clamped::increment), heights(page, run.still, Clamped::sum)};
  const List<double>& hop = plot.series[0].y;
  plot.y = {.min = 1.2 * *std::min_element(hop.begin(), hop.end()) - 1, .max = 1200 * run.hop_height + 1};
  plot.now = step * time_step;
  const int settled = 3 * motion_steps / 4;
  if (std::abs(run.hop[settled].bodies[{1}].pose.angle) > 1)
    plot.labels = {{settled * time_step, hop[settled], "the box lies on its side"}};
  draw_plot(page, parts[2], plot);
}

void draw_spread(Page& page, const FeetRun& run) {
  const List<Rect> parts = in_columns(page, {0.64, {0.36, {0.55, 0.45}}});
  Series foot{.style = style_of(page.theme(), Clamped::increment)};
  Series box = foot;
  box.style.marker = Marker::circle;
  box.style.dash = {2, 5};
  Series sum{.style = page.theme().exact, .markers = false};
  for (const Spread& spread : run.spreads) {
    sum.add(spread.foot, 0);
    if (spread.foot > harmless_distance()) continue;
    foot.add(spread.foot, spread.formula_speed - spread.foot * spread.formula_spin);
    box.add(spread.foot, spread.formula_speed);
  }
  // Where q and with it both speeds are 0.
  for (Series* series : {&foot, &box}) series->add(harmless_distance(), 0);
  Plot plot{.title = "each push clamped: speed afterwards (m/s)"};
  plot.x = {.title = "r: from the middle to each foot (m)", .min = 0, .max = 0.5};
  plot.y = {.title = "", .min = 0};
  plot.series = {foot, box, sum};
  const auto peak = static_cast<int>(std::max_element(foot.y.begin(), foot.y.end()) - foot.y.begin());
  plot.labels = {{foot.x[peak + 4], foot.y[peak + 4], "the left foot rises"},
                 {box.x[peak], box.y[peak], "the box rises"},
                 {sum.x[peak], 0, "the sum clamped: nothing rises"}};
  plot.cursor = harmless_distance();
  draw_plot(page, parts[0], plot);
  page.note(parts[1], "Where the mistake does not show",
            "Right of the vertical line A_{12} ≤ 0: a push at one foot makes the other one sink. "
            "No foot has to take anything back, and both clamps do the same.");
  page.equation(parts[2], {.number = "A_{12} = 1/m − r²/I = 0",
                           .symbols = "r = √(I/m)",
                           .numbers = fmt::format("= √({:g}/{:g})", box_inertia, box_mass),
                           .result = fmt::format("= {} m", fixed(harmless_distance(), 3))});
}

Shot motion_shot(const FeetRun& run, int step) {
  return {.state = fmt::format("t = {} s · outlines every {} s", fixed(step * time_step, 2),
                               fixed(outline_steps * time_step, 2)),
          .alt = fmt::format(
              "{:.2f} s after the landing: with each push clamped the middle of the box is {:.1f} mm "
              "{} and it has turned by {:.0f} degrees, with the sum clamped it has risen by {:.1f} mm.",
              step * time_step, std::abs(height_at(run.hop, step)),
              height_at(run.hop, step) < 0 ? "lower" : "higher",
              std::abs(run.hop[step].bodies[{1}].pose.angle) * 180 / pi, height_at(run.still, step)),
          .draw = [&run, step](Page& page) { draw_step(page, run, step); },
          .key = step == motion_steps};
}

}  // namespace

List<Shot> motion_shots(const FeetRun& run) {
  List<Shot> shots;
  for (int step = 1; step < run.hop.size(); ++step) shots.push_back(motion_shot(run, step));
  return shots;
}

Shot spread_shot(const FeetRun& run) {
  return key_shot(
      run, "feet at any distance",
      "How fast the box and its left foot rise after a landing with each push clamped, against the "
      "distance of the feet: nothing from 0.408 m on.",
      draw_spread);
}

}  // namespace cairn::feet
