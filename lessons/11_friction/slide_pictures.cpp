// Lesson 11. The slide in two engines, the four slopes, and the acceleration over the angle.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/list.hpp"
#include "parts.hpp"
#include "render/draw.hpp"
#include "render/plot.hpp"

namespace cairn::friction {

namespace {

using namespace render;

/// One engine's block with its earlier outlines and its velocity, under a bar in the engine's colour.
void draw_engine(Page& page, const Rect& rect, const std::string& name, const SeriesStyle& style,
                 const List<Snapshot>& frames, const Slide& slide, int step) {
  const Rect inside = page.panel(rect, name);
  page.canvas().rect({rect.x, rect.y, rect.width, 6}, {.fill = style.color});
  const Slope& slope = slide.slope;
  const double side = 0.1;
  const Camera camera = fit(
      inside, {{-side, -side},
               {slope.length * std::cos(slope.angle) + side, slope.length * std::sin(slope.angle) + 0.8}});
  List<Snapshot> earlier;
  for (int ghost = 0; ghost < 4; ++ghost) {
    const int at = ghost * slope.steps / 4;
    if (at < step) earlier.push_back(frames[at]);
  }
  draw_ghosts(page, camera, earlier);
  const Snapshot& now = frames[step];
  draw_world(page, camera, now, {.names = {"", "", ""}, .contacts = false});
  const double fastest = std::max(slide.speed.back(), slope.gravity * slope.dt);
  const SnapshotBody& block = now.bodies[first_block];
  const Vec2<double> velocity = block.velocity.head<2>();
  draw_arrow(page, camera,
             {.pixels_per_unit = 1.2 * camera.scale / fastest, .longest = 2 * camera.scale, .unit = "m/s"},
             {.kind = ArrowKind::velocity, .tail = block.pose.position, .value = velocity});
  TextStyle value = page.value();
  value.align = Align::right;
  const double speed = slope.downhill().dot(velocity);
  page.canvas().text({inside.x + inside.width, inside.y + value.size}, fixed(speed, 3) + " m/s", value);
}

Series speed_series(const std::string& name, const SeriesStyle& style, const Slide& slide,
                    const List<double>& speed, int step) {
  Series series = {.name = name, .style = style};
  for (int k = 0; k <= step; ++k) {
    series.x.push_back(slide.time[k]);
    series.y.push_back(speed[k]);
  }
  return series;
}

void draw_speed(Page& page, const Rect& rect, const Slide& slide, int step) {
  const double acceleration = coulomb(slide.slope, slide.block).acceleration;
  Plot plot = {.title = "speed down the slope (m/s)"};
  plot.x = {.title = "t (s)", .min = 0, .max = slide.time.back()};
  plot.y = {.title = "", .min = 0, .max = std::max(1.1 * acceleration * slide.time.back(), 0.01)};
  Series exact = {.name = "exact", .style = page.theme().exact, .markers = false};
  exact.x = {0, slide.time.back()};
  exact.y = {0, acceleration * slide.time.back()};
  plot.series.push_back(exact);
  plot.series.push_back(speed_series("Cairn", page.theme().si, slide, slide.speed, step));
  if (!slide.box2d_speed.empty()) {
    plot.series.push_back(speed_series("Box2D", page.theme().box2d, slide, slide.box2d_speed, step));
  }
  plot.cursor = slide.time[step];
  draw_plot(page, rect, plot);
}

void draw_slide(Page& page, const Slide& slide, int step) {
  const bool both = !slide.box2d_frames.empty();
  const double gap = page.sizes().gap;
  const List<Rect> halves = rows(page.area(), {56, 44}, gap);
  const List<Rect> engines = columns(halves[0], {50, 50}, gap);
  draw_engine(page, both ? engines[0] : halves[0], "Cairn, sequential impulses", page.theme().si,
              slide.frames, slide, step);
  if (both) {
    draw_engine(page, engines[1], "Box2D 2.4.1", page.theme().box2d, slide.box2d_frames, slide, step);
  }
  draw_speed(page, halves[1], slide, step);
}

/// "holds", or how far it has slid.
std::string outcome(double way) {
  if (way < 1e-3) return "holds";
  return "slides " + (way < 1 ? fixed(1000 * way, 0) + " mm" : fixed(way, 2) + " m");
}

/// The same piece of the world for every slope: up to where the fastest block ends.
Aabb<double> seen_by(const Study& study) {
  double length = 4;
  double rise = 0;
  for (const Trial& trial : study.trials) {
    const Snapshot& last = trial.contest.frames.back();
    length = std::max(length, last.bodies[{first_block.index + 1}].pose.position.x() + 1.2);
    rise = std::max(rise, last.bodies[first_block].pose.position.y() + 0.8);
  }
  return {{-0.1, -0.1}, {length, rise}};
}

void draw_trial(Page& page, const Rect& rect, const Study& study, const Trial& trial) {
  const std::string rough = "μ " + significant(study.settings.rough, 2);
  const std::string slippery = "μ " + significant(study.settings.slippery, 2);
  const Rect inside =
      page.panel(rect, fmt::format("{}°:  {} {},  {} {}", fixed(trial.degrees, 0), rough,
                                   outcome(trial.contest.ways[0]), slippery, outcome(trial.contest.ways[1])));
  const Camera camera = fit(inside, seen_by(study));
  draw_ghosts(page, camera, {&trial.contest.frames.front(), 1});
  const PerBody<std::string> names = {"", "", significant(study.settings.rough, 2),
                                      significant(study.settings.slippery, 2)};
  draw_world(page, camera, trial.contest.frames.back(), {.names = names, .contacts = false});
}

Series formula_series(const Study& study, const Curve& curve, const SeriesStyle& style) {
  Series series = {.name = "μ = " + fixed(curve.friction, 2), .style = style, .markers = false};
  const int points = 200;
  for (int i = 0; i <= points; ++i) {
    const double degrees =
        curve.degrees.front() + (curve.degrees.back() - curve.degrees.front()) * i / points;
    Slope slope = study.settings.slope;
    slope.angle = degrees * pi / 180;
    series.x.push_back(degrees);
    series.y.push_back(coulomb(slope, {.friction = curve.friction}).acceleration);
  }
  return series;
}

Plot curve_plot(const Page& page, const Study& study) {
  Plot plot = {.title = "acceleration down the slope (m/s²);  line: g (sin α − μ cos α)"};
  plot.x = {.title = "α (°)"};
  plot.y = {.title = "", .min = -0.05};
  SeriesStyle thin = page.theme().exact;
  thin.marker = Marker::none;
  for (const Curve& curve : study.curves) plot.series.push_back(formula_series(study, curve, thin));
  Series cairn = {.name = "", .style = page.theme().si, .line = false};
  Series box2d = {.name = "", .style = page.theme().box2d, .line = false};
  for (const Curve& curve : study.curves) {
    for (int i = 0; i < curve.degrees.size(); ++i) {
      Series& series = i % 2 == 1 && !curve.box2d.empty() ? box2d : cairn;
      series.x.push_back(curve.degrees[i]);
      series.y.push_back(i % 2 == 1 && !curve.box2d.empty() ? curve.box2d[i] : curve.cairn[i]);
    }
  }
  plot.series.push_back(cairn);
  if (!box2d.x.empty()) plot.series.push_back(box2d);
  return plot;
}

TableView threshold_table(const Study& study) {
  TableView table = {.header = {"μ", "atan μ", "Cairn"}};
  if (has_box2d()) table.header.push_back("Box2D");
  for (const Threshold& threshold : study.thresholds) {
    List<std::string> row = {fixed(threshold.friction, 2), fixed(threshold.formula, 3),
                             fixed(threshold.cairn, 3)};
    if (has_box2d()) row.push_back(fixed(threshold.box2d, 3));
    table.rows.push_back(row);
  }
  return table;
}

/// The slippery block after `step` steps, in Cairn and in Box2D, and its speed over time.
Shot slide_shot(const SharedStudy& study, int step) {
  const Slide& slide = study->slippery;
  const int steps = slide.slope.steps;
  Shot shot;
  shot.key = step == steps / 2 || step == steps;
  shot.state = fmt::format("μ = {} · t = {} s", fixed(slide.block.friction, 2), fixed(slide.time[step], 2));
  shot.alt = fmt::format(
      "After {} s the block slides at {} m/s in Cairn{}; the points lie on the exact line.",
      fixed(slide.time[step], 2), fixed(slide.speed[step], 3),
      slide.box2d_speed.empty() ? "" : " and at " + fixed(slide.box2d_speed[step], 3) + " in Box2D");
  shot.draw = [study, step](Page& page) { draw_slide(page, study->slippery, step); };
  return shot;
}

/// Both blocks on four slopes.
Shot trial_shot(const SharedStudy& study) {
  Shot shot;
  shot.key = true;
  const double time = study->settings.slope.steps * study->settings.slope.dt;
  shot.state = "after " + significant(time) + " s";
  shot.alt = "Four slopes, each with a rough and a slippery block:";
  for (const Trial& trial : study->trials) {
    shot.alt += fmt::format(" at {}° the rough one {} and the slippery one {};", fixed(trial.degrees, 0),
                            outcome(trial.contest.ways[0]), outcome(trial.contest.ways[1]));
  }
  shot.draw = [study](Page& page) {
    const List<Rect> halves = rows(page.area(), {50, 50}, page.sizes().gap);
    for (int i = 0; i < study->trials.size(); ++i) {
      const List<Rect> cells = columns(halves[i / 2], {50, 50}, page.sizes().gap);
      draw_trial(page, cells[i % 2], *study, study->trials[i]);
    }
  };
  return shot;
}

/// Acceleration over the angle.
Shot curve_shot(const SharedStudy& study) {
  Shot shot;
  shot.key = true;
  shot.state = "holds, then slides";
  shot.alt =
      "Acceleration over the angle for both blocks: zero up to the critical angle, then along the formula; "
      "squares of Cairn and triangles of Box2D on the line.";
  shot.draw = [study](Page& page) {
    const List<Rect> parts = columns(page.area(), {62, 38}, page.sizes().gap);
    draw_plot(page, parts[0], curve_plot(page, *study));
    const List<Rect> halves = rows(parts[1], {45, 55}, page.sizes().gap);
    page.table(halves[0], "slides above (°)", threshold_table(*study));
    const std::string points = has_box2d() ? "Squares are Cairn, triangles Box2D." : "Squares are Cairn.";
    page.note(halves[1], "what is drawn",
              points + " The lines are the formula: g (sin α − μ cos α), and 0 where friction suffices.");
  };
  return shot;
}

}  // namespace

List<Shot> pictures(const Study& study, const std::string& question) {
  const SharedStudy shared = std::make_shared<const Study>(study);
  List<Shot> shots;
  shots.push_back(question_shot(shared, question));
  shots.push_back(force_shot(shared, shared->rough));
  shots.push_back(force_shot(shared, shared->slippery));
  shots.push_back(sweep_shot(shared));
  for (int step = 1; step <= study.settings.slope.steps; ++step) shots.push_back(slide_shot(shared, step));
  shots.push_back(trial_shot(shared));
  shots.push_back(curve_shot(shared));
  shots.push_back(answer_shot(shared, question));
  return shots;
}

}  // namespace cairn::friction
