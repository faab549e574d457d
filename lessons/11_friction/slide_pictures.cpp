// Lesson 11. The slide in two engines.
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

/// The slippery block after `step` steps, in Cairn and in Box2D, and its speed over time.
Shot slide_shot(const Study& study, int step) {
  const Slide& slide = study.slippery;
  Shot shot;
  shot.state = fmt::format("μ = {} · t = {} s", fixed(slide.block.friction, 2), fixed(slide.time[step], 2));
  shot.alt = fmt::format(
      "After {} s the block slides at {} m/s in Cairn{}; below, how far both are from the exact speed.",
      fixed(slide.time[step], 2), fixed(slide.speed[step], 3),
      slide.box2d_speed.empty() ? "" : " and at " + fixed(slide.box2d_speed[step], 3) + " in Box2D");
  shot.draw = [&study, step](Page& page) { draw_slide(page, study.slippery, step); };
  return shot;
}

}  // namespace

List<Shot> slide_shots(const Study& study) {
  List<Shot> shots;
  for (int step = 1; step <= study.settings.slope.steps; ++step) shots.push_back(slide_shot(study, step));
  return shots;
}

}  // namespace cairn::friction
