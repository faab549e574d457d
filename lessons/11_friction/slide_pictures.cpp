// Lesson 11. The slide in two engines, the four slopes, and the acceleration over the angle.
#include "lesson.hpp"

namespace cairn::friction {

namespace {

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
  TextStyle value = aligned(page.value(), Align::right);
  const double speed = slope.downhill().dot(velocity);
  page.canvas().text({inside.x + inside.width, inside.y + value.size}, fixed(speed, 3) + " m/s", value);
}

/// How far each engine's speed is from the exact one.
void draw_speed_error(Page& page, const Rect& rect, const Slide& slide, int step) {
  const double acceleration = coulomb(slide.slope, slide.block).acceleration;
  Plot plot = {
      .title = "speed minus exact speed (mm/s)", .y = {.min = -1.5, .max = 1.5}, .now = slide.time[step]};
  plot.x = {.title = "t (s)", .min = 0, .max = slide.time.back()};
  const auto add = [&](const std::string& name, const SeriesStyle& style, const List<double>& speed) {
    Series series = {.name = name, .style = style, .x = slide.time};
    for (int k = 0; k < speed.size(); ++k)
      series.y.push_back(1000 * (speed[k] - acceleration * slide.time[k]));
    plot.series.push_back(series);
  };
  add("Cairn", page.theme().si, slide.speed);
  if (!slide.box2d_speed.empty()) add("Box2D", page.theme().box2d, slide.box2d_speed);
  draw_plot(page, rect, plot);
}

void draw_slide(Page& page, const Slide& slide, int step) {
  const bool both = !slide.box2d_frames.empty();
  const List<Rect> halves = in_rows(page, {60, 40});
  const List<Rect> engines = in_columns(page, halves[0], {50, 50});
  draw_engine(page, both ? engines[0] : halves[0], "Cairn, sequential impulses", page.theme().si,
              slide.frames, slide, step);
  if (both) {
    draw_engine(page, engines[1], "Box2D 2.4.1", page.theme().box2d, slide.box2d_frames, slide, step);
  }
  draw_speed_error(page, halves[1], slide, step);
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
  for (int i = 0; i < trial.contest.ways.size(); ++i) {
    const BodyId block = {first_block.index + i};
    const Vec2<double> from = trial.contest.frames.front().bodies[block].pose.position;
    const Vec2<double> way = trial.contest.frames.back().bodies[block].pose.position - from;
    if (way.norm() * camera.scale < 8) continue;  // it would be a dot
    draw_arrow(page, camera, {.pixels_per_unit = camera.scale, .longest = 1e4},
               {.kind = ArrowKind::velocity, .tail = from + Vec2<double>(0.15, 0.75), .value = way});
  }
}

Series formula_series(const Study& study, const Curve& curve, const SeriesStyle& style) {
  Series series = {.name = "μ = " + fixed(curve.friction, 2), .style = style, .markers = false};
  const int points = 200;
  for (int i = 0; i <= points; ++i) {
    const double degrees =
        curve.degrees.front() + (curve.degrees.back() - curve.degrees.front()) * i / points;
    Slope slope = study.settings.slope;
    slope.angle = degrees * pi / 180;
    series.add(degrees, coulomb(slope, {.friction = curve.friction}).acceleration);
  }
  return series;
}

Plot curve_plot(const Page& page, const Study& study) {
  Plot plot = {.title = "acceleration down the slope (m/s²);  line: g (sin α − μ cos α)"};
  plot.x = {.title = "α (°)"};
  plot.y = {.min = -0.25};
  SeriesStyle thin = page.theme().exact;
  thin.marker = Marker::none;
  Series cairn = {.name = "", .style = page.theme().si, .line = false};
  Series box2d = {.name = "", .style = page.theme().box2d, .line = false};
  for (const Curve& curve : study.curves) {
    plot.series.push_back(formula_series(study, curve, thin));
    for (int i = 0; i < curve.degrees.size(); ++i) {
      const bool other = i % 2 == 1 && !curve.box2d.empty();
      (other ? box2d : cairn).add(curve.degrees[i], other ? curve.box2d[i] : curve.cairn[i]);
    }
  }
  plot.series.push_back(cairn);
  if (!box2d.x.empty()) plot.series.push_back(box2d);
  for (const Threshold& threshold : study.thresholds) {
    plot.labels.push_back(
        {threshold.formula, -0.1,  // below the line of zero
         "atan " + significant(threshold.friction) + " = " + fixed(threshold.formula, 2) + "°"});
  }
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
Shot slide_shot(const Study& study, int step) {
  const Slide& slide = study.slippery;
  const int steps = slide.slope.steps;
  Shot shot;
  shot.key = step == steps;
  shot.state = fmt::format("μ = {} · t = {} s", fixed(slide.block.friction, 2), fixed(slide.time[step], 2));
  shot.alt = fmt::format(
      "After {} s the block slides at {} m/s in Cairn{}; below, how far both are from the exact speed.",
      fixed(slide.time[step], 2), fixed(slide.speed[step], 3),
      slide.box2d_speed.empty() ? "" : " and at " + fixed(slide.box2d_speed[step], 3) + " in Box2D");
  shot.draw = [&study, step](Page& page) { draw_slide(page, study.slippery, step); };
  return shot;
}

/// Both blocks on four slopes.
Shot trial_shot(const Study& study) {
  Shot shot;
  shot.key = true;
  const double time = study.settings.slope.steps * study.settings.slope.dt;
  shot.state = "after " + significant(time) + " s";
  shot.alt = "Four slopes, each with a rough and a slippery block:";
  for (const Trial& trial : study.trials) {
    shot.alt += fmt::format(" at {}° the rough one {} and the slippery one {};", fixed(trial.degrees, 0),
                            outcome(trial.contest.ways[0]), outcome(trial.contest.ways[1]));
  }
  shot.draw = [&study](Page& page) {
    const List<Rect> halves = in_rows(page, {50, 50});
    for (int i = 0; i < study.trials.size(); ++i) {
      const List<Rect> cells = in_columns(page, halves[i / 2], {50, 50});
      draw_trial(page, cells[i % 2], study, study.trials[i]);
    }
  };
  return shot;
}

/// Acceleration over the angle.
Shot curve_shot(const Study& study) {
  Shot shot;
  shot.key = true;
  shot.state = "holds, then slides";
  shot.alt =
      "Acceleration over the angle for both blocks: zero up to the critical angle, then along the formula; "
      "squares of Cairn and triangles of Box2D on the line.";
  shot.draw = [&study](Page& page) {
    const List<Rect> parts = in_columns(page, {62, 38});
    draw_plot(page, parts[0], curve_plot(page, study));
    const Rect rest = page.card(
        parts[1], "what is drawn",
        has_box2d() ? "At every second angle the block ran in Cairn (squares), at the others in "
                      "Box2D (triangles). The lines are the formula, and 0 where friction is enough."
                    : "Squares are Cairn. The lines are the formula, and 0 where friction is enough.");
    page.table(rest, "slides above (°)", threshold_table(study));
  };
  return shot;
}

}  // namespace

List<Shot> slide_shots(const Study& study) {
  List<Shot> shots;
  for (int step = 1; step <= study.settings.slope.steps; ++step) shots.push_back(slide_shot(study, step));
  shots.push_back(trial_shot(study));
  shots.push_back(curve_shot(study));
  return shots;
}

}  // namespace cairn::friction
