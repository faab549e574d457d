// Balls that begin inside the ground: what pushes them out, and how deep is too deep.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn::drift {

namespace {

using render::fixed;
using render::Page;
using render::Rect;

const double ball_pitch = 1.3;  // [m] from ball to ball

/// All balls on one ground, side by side.
Snapshot balls_together(const DriftRuns& all, int step) {
  Snapshot scene = all.balls[0].steps[step];
  scene.bodies.resize(1);
  scene.contacts.clear();
  for (int i = 0; i < all.balls.size(); ++i) {
    scene.bodies.push_back(all.balls[i].steps[step].bodies[{1}]);
    scene.bodies.back().pose.position.x() += i * ball_pitch;
  }
  return scene;
}

double highest_peak(const DriftRuns& all) {
  double peak = 0;
  for (const BallRun& run : all.balls) peak = std::max(peak, run.peak);
  return peak;
}

int last_step(const DriftRuns& all) { return all.balls[0].steps.size() - 1; }

render::Equation equation_of(const Page& page, const DriftRuns& all, int step) {
  const BallRun& run = ball_of(all, all.settings.beta);
  const double free = run.speed[step - 1] - gravity * all.settings.dt;
  const double wanted = (run.zeta[step] - free) / all.settings.dt;
  const bool is_clamped = wanted < -1e-9;
  return {.number = fmt::format("eq (22), β = {:g}", run.beta),
          .symbols = "λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)",
          .numbers = fmt::format("= ({} − {}) / (1 × {:.4g})", fixed(run.zeta[step], 3),
                                 free < 0 ? "(" + fixed(free, 3) + ")" : fixed(free, 3), all.settings.dt),
          .result = fmt::format("= {} N{}", fixed(wanted + 0.0, 2), is_clamped ? ", clamped to 0" : ""),
          .color = page.theme().normal};
}

void draw_ball_step(Page& page, const DriftRuns& all, int step) {
  const List<Rect> halves = columns(page.area(), {0.5, 0.5}, page.sizes().gap);
  const List<Rect> left = rows(halves[0], {0.64, 0.36}, page.sizes().gap);
  const List<Rect> right = rows(halves[1], {0.64, 0.36}, page.sizes().gap);
  draw_balls(page, left[0], all, step, step);
  draw_ball_table(page, left[1], all, step);
  draw_heights(page, right[0], all, step);
  page.equation(right[1], equation_of(page, all, step));
}

Shot ball_shot(const Runs& all, int step, bool key) {
  std::string alt = fmt::format("Balls after step {}. Height above the ground and push of the ground:", step);
  for (const BallRun& run : all->balls) {
    alt +=
        fmt::format(" {:.3f} m, {:.1f} N with β = {:g};", run.height[step], run.lambda[step] + 0.0, run.beta);
  }
  alt.back() = '.';
  return {.state = fmt::format("ball · step {}", step),
          .alt = alt,
          .draw = [all, step](Page& page) { draw_ball_step(page, *all, step); },
          .key = key};
}

/// The largest depth that is held, by formula and by bisection.
void draw_limits(Page& page, const DriftRuns& all) {
  const List<Rect> parts = columns(page.area(), {0.62, 0.38}, page.sizes().gap);
  render::Plot plot{.title = "how deep a ball may begin so that the ground still pushes in step 2 (m)"};
  plot.x = {.title = "β", .scale = render::AxisScale::logarithmic, .min = 0.05, .max = 1.1};
  plot.y = {.title = "", .scale = render::AxisScale::logarithmic, .min = 3e-4, .max = 3};
  render::Series formula{.name = "g Δt² / β²", .style = page.theme().exact, .markers = false};
  for (int i = 0; i <= 40; ++i) {
    const double beta = 0.05 * std::pow(20, i / 40.0);
    const double limit = limit_by_formula(all.settings.dt, beta);
    if (limit > 3) continue;
    formula.x.push_back(beta);
    formula.y.push_back(limit);
  }
  render::Series measured{.name = "", .style = page.theme().si, .line = false};
  for (const DepthLimit& limit : all.limits) {
    measured.x.push_back(limit.beta);
    measured.y.push_back(limit.measured);
  }
  plot.series = {formula, measured};
  plot.goals.push_back({all.settings.depth, fmt::format("d = {:g} m", all.settings.depth)});
  draw_plot(page, parts[0], plot);
  const List<Rect> right = rows(parts[1], {0.58, 0.42}, page.sizes().gap);
  page.note(right[0], "Held, or let go",
            "In step 1 the ball gets the speed βd/Δt. In step 2 the row asks for (1−β) times as much. If "
            "gravity takes less than that away, λ would have to pull, and the ground lets the ball go. "
            "The line is the formula, the squares are measured.");
  render::TableView table;
  table.header = {"β", "formula (mm)", "measured (mm)"};
  for (const DepthLimit& limit : all.limits) {
    if (limit.beta == all.settings.beta) table.active_row = table.rows.size();
    table.rows.push_back(
        {fmt::format("{:g}", limit.beta), fixed(1000 * limit.formula, 2), fixed(1000 * limit.measured, 2)});
  }
  page.table(right[1], "", table);
}

}  // namespace

void draw_balls(Page& page, const Rect& rect, const DriftRuns& all, int step, int ghosts) {
  const Rect inside = page.panel(rect, "β of each ball");
  const double right = ball_pitch * (all.balls.size() - 1);
  const double top = 2 * ball_radius + std::max(highest_peak(all), 0.0) + 0.1;
  const double bottom = -0.35;  // [m] at the lower edge of the panel
  render::Camera camera = render::fit(inside, {{-0.65, bottom}, {right + 0.65, top}});
  camera.center.y() = bottom + 0.5 * camera.viewport.height / camera.scale;
  List<Snapshot> earlier;
  for (int k = std::max(0, step - ghosts); k < step; ++k) {
    earlier.push_back(balls_together(all, k));
  }
  draw_ghosts(page, camera, earlier);
  render::WorldLook look;
  look.names = {""};
  for (const BallRun& run : all.balls) look.names.push_back(fmt::format("{:g}", run.beta));
  look.numbers = camera.scale >= 45;
  draw_world(page, camera, balls_together(all, step), look);
}

void draw_ball_table(Page& page, const Rect& rect, const DriftRuns& all, int step) {
  render::TableView table;
  table.header = {"β", "ζ (m/s)", "λ (N)", "v (m/s)", "c (mm)"};
  for (const BallRun& run : all.balls) {
    if (run.beta == all.settings.beta) table.active_row = table.rows.size();
    // A speed that asks for nothing (c > 0) is of no interest.
    table.rows.push_back({fmt::format("{:g}", run.beta), fixed(std::max(run.zeta[step], 0.0), 2),
                          fixed(run.lambda[step] + 0.0, 1), fixed(run.speed[step] + 0.0, 2),
                          fixed(1000 * run.height[step] + 0.0, 0)});
  }
  std::string title = fmt::format("step {}", step);
  for (const BallRun& run : all.balls) {
    const bool lands = step > 1 && run.lambda[step] > 2 * gravity;  // at rest it is g times 1 kg
    if (lands) title += fmt::format(": the ball with β = {:g} lands, and its λ is an impact", run.beta);
  }
  page.table(rect, title, table);
}

void draw_heights(Page& page, const Rect& rect, const DriftRuns& all, int step) {
  // The first steps are small beside the flight: they get a chart of their own.
  const int shown = step <= 10 ? std::min(10, last_step(all)) : last_step(all);
  double highest = 0;
  for (const BallRun& run : all.balls) {
    for (int k = 0; k <= shown; ++k) highest = std::max(highest, run.height[k]);
  }
  render::Plot plot{.title = "c: height of the lowest point (m)"};
  plot.x = {.title = "step", .min = 0, .max = static_cast<double>(shown)};
  plot.y = {.title = "", .min = -1.3 * all.settings.depth, .max = 1.15 * highest + 0.02};
  for (int i = 0; i < all.balls.size(); ++i) {
    render::Series series{
        .name = beta_name(all.balls[i].beta), .style = curve_style(page.theme(), i), .markers = false};
    for (int k = 0; k <= step; ++k) {
      series.x.push_back(k);
      series.y.push_back(all.balls[i].height[k]);
    }
    plot.series.push_back(series);
  }
  plot.goals.push_back({0, ""});
  if (step < shown) plot.cursor = step;
  draw_plot(page, rect, plot);
}

int highest_step(const DriftRuns& all) {
  const List<double>& height = ball_of(all, 1).height;
  return static_cast<int>(std::max_element(height.begin(), height.end()) - height.begin());
}

List<Shot> ball_shots(const Runs& all) {
  const int last = last_step(*all);
  const std::set<int> keys = {1, 2, 5, std::max(highest_step(*all), 6), last};
  const int stride = std::max(1, last / 80);
  List<Shot> shots;
  for (int step = 1; step <= last; ++step) {
    if (step % stride != 0 && !keys.contains(step)) continue;
    shots.push_back(ball_shot(all, step, keys.contains(step)));
  }
  shots.push_back({.state = "how deep is too deep",
                   .alt = "The largest depth that the ground can hold falls like one over β squared; the "
                          "library's own limits lie on the formula.",
                   .draw = [all](Page& page) { draw_limits(page, *all); },
                   .key = true});
  return shots;
}

}  // namespace cairn::drift
