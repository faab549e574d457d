// Balls that begin inside the ground: what pushes them out, and how deep is too deep; the question, the
// frames of the scenes, and the answer.
#include "lesson.hpp"

namespace cairn::drift {

namespace {

const double ball_pitch = 1.3;  // [m] from ball to ball

constexpr int speeds_until = 2;  // steps that show what rows ask for and what balls have

/// All balls on one ground, side by side.
Snapshot balls_together(const DriftRuns& all, int step) {
  Snapshot scene = all.balls[0].steps[step];
  scene.bodies.resize(1);
  scene.contacts.clear();
  for (int i = 0; i < all.balls.size(); ++i) {
    scene.bodies.push_back(all.balls[i].steps[step].bodies[{1}]);
    Pose<double>& pose = scene.bodies.back().pose;
    pose.position.x() += i * ball_pitch;
    pose.angle = pi / 2;  // its mark upwards, where it is no minus behind the number
  }
  return scene;
}

double highest_peak(const DriftRuns& all) {
  double peak = 0;
  for (const BallRun& run : all.balls) peak = std::max(peak, run.peak);
  return peak;
}

/// Of those balls that have left the ground, what was before `step`.
List<Snapshot> flights(const DriftRuns& all, int step) {
  List<Snapshot> earlier;
  for (int k = 0; k < step; ++k) {
    Snapshot scene = balls_together(all, k), flying = scene;
    flying.bodies.resize(1);
    for (int i = 0; i < all.balls.size(); ++i)
      if (all.balls[i].peak > 0) flying.bodies.push_back(scene.bodies[{i + 1}]);
    earlier.push_back(flying);
  }
  return earlier;
}

/// Above each ball, before the push of the next step: the speed that its row asks for, and the one that it
/// has.
void draw_speeds(Page& page, const Camera& camera, const DriftRuns& all, int step) {
  const ArrowScale scale = arrow_scale(all.settings.depth / all.settings.dt, "m/s", camera);
  TextStyle text = aligned(page.value(), Align::center);
  for (int i = 0; i < all.balls.size(); ++i) {
    const BallRun& run = all.balls[i];
    const auto draw = [&](double side, ArrowKind kind, double speed) {
      const Vec2<double> tail(i * ball_pitch + 0.3 * side, run.height[step] + 2 * ball_radius + 0.1);
      draw_arrow(page, camera, scale, {.kind = kind, .tail = tail, .value = {0, speed}});
      const Point tip = camera.project(tail) - Point(0, std::max(0.0, speed) * scale.pixels_per_unit);
      page.canvas().text(tip - Point(0, 10), fixed(speed + 0.0, 2), text);
    };
    draw(-1, ArrowKind::external, run.zeta[step + 1]);
    draw(1, ArrowKind::velocity, run.speed[step] - gravity * all.settings.dt);
  }
}

int last_step(const DriftRuns& all) { return all.balls[0].steps.size() - 1; }

Equation equation_of(const Page& page, const DriftRuns& all, int step) {
  const BallRun& run = ball_of(all, 1);
  const double free = run.speed[step - 1] - gravity * all.settings.dt;
  const double wanted = (run.zeta[step] - free) / all.settings.dt;
  const double above = run.height[step - 1];
  if (above > 1e-9)
    return {.number = "β = 1, in the air",
            .symbols = "ζ = −c/Δt",
            .numbers = fmt::format("= −{}/{:.4g} = {} m/s", fixed(above, 3), all.settings.dt,
                                   fixed(run.zeta[step], 1)),
            .result = "λ = 0: it does not fall that fast",
            .color = page.theme().normal};
  const char* const clamped = wanted < -1e-9 ? ", clamped to 0: it cannot pull" : "";
  return {.number = "eq (22), β = 1",
          .symbols = "λ = (ζ − j·v) / (j M⁻¹ j^{T} Δt)",
          .numbers = fmt::format("= ({} − {}) / (1 × {:.4g})", fixed(run.zeta[step] + 0.0, 2),
                                 in_brackets(fixed(free, 2)), all.settings.dt),
          .result = fmt::format("= {} N{}", fixed(wanted + 0.0, 0), clamped),
          .color = page.theme().normal};
}

/// What (7) asked for, what it took, and what came of it, in this step.
void draw_ball_table(Page& page, const Rect& rect, const DriftRuns& all, int step) {
  TableView table{.header = {"β", "ζ (m/s)", "λ (N)", "v (m/s)", "c (mm)"}};
  std::string title = fmt::format("step {}", step);
  for (const BallRun& run : all.balls) {
    if (run.beta == 1) table.active_row = table.rows.size();
    table.rows.push_back({fmt::format("{:g}", run.beta), fixed(run.zeta[step] + 0.0, 2),
                          fixed(run.lambda[step] + 0.0, 1), fixed(run.speed[step] + 0.0, 2),
                          fixed(1000 * run.height[step] + 0.0, 0)});
    const bool lands = step > 1 && run.lambda[step] > 2 * gravity;  // at rest it is g times 1 kg
    if (lands) title += fmt::format(": the ball with β = {:g} lands, and its λ is an impact", run.beta);
  }
  page.table(rect, title, table);
}

/// Their heights against steps, up to `step`.
void draw_heights(Page& page, const Rect& rect, const DriftRuns& all, int step) {
  // The first steps are small beside the flight: they get charts of their own.
  const int shown = std::min(step <= 2 ? 4 : step <= 10 ? 10 : last_step(all), last_step(all));
  double highest = 0;
  Plot plot{.title = "c: height of the lowest point (m)"};
  for (const BallRun& run : all.balls) {
    for (int k = 0; k <= shown; ++k) highest = std::max(highest, run.height[k]);
    plot.series.push_back(over_steps(beta_name(run.beta), beta_style(page.theme(), run.beta),
                                     {run.height.begin(), run.height.begin() + step + 1}));
    plot.series.back().markers = false;
  }
  plot.x = {.title = "step", .min = 0, .max = static_cast<double>(shown)};
  plot.y = {.title = "", .min = -1.3 * all.settings.depth, .max = 1.15 * highest + 0.02};
  plot.goals.push_back({0, ""});
  if (step < shown) plot.cursor = step;
  draw_plot(page, rect, plot);
}

void draw_ball_step(Page& page, const DriftRuns& all, int step) {
  const List<Rect> parts = in_columns(page, {{0.5, {0.64, 0.36}}, {0.5, {0.64, 0.36}}});
  const bool speeds = step <= speeds_until;
  draw_balls(page, parts[0], all, {.step = speeds ? step - 1 : step, .speeds = speeds});
  draw_ball_table(page, parts[1], all, step);
  draw_heights(page, parts[2], all, step);
  page.equation(parts[3], equation_of(page, all, step));
}

Shot ball_shot(const DriftRuns& all, int step, bool key) {
  std::string alt = fmt::format("Balls after step {}. Height above the ground and push of the ground:", step);
  for (const BallRun& run : all.balls) {
    alt +=
        fmt::format(" {:.3f} m, {:.1f} N with β = {:g};", run.height[step], run.lambda[step] + 0.0, run.beta);
  }
  alt.back() = '.';
  return {.state = fmt::format("ball · step {}", step),
          .alt = alt,
          .draw = [&all, step](Page& page) { draw_ball_step(page, all, step); },
          .key = key};
}

/// The largest depth that is held, by formula and by bisection.
void draw_limits(Page& page, const DriftRuns& all) {
  const List<Rect> parts = in_columns(page, {0.62, 0.38});
  Plot plot{.title = "how deep a ball may begin so that the ground still pushes in step 2 (mm)"};
  plot.x = {.title = "β", .scale = AxisScale::logarithmic, .min = 0.09, .max = 1.1};
  plot.y = {.title = "", .scale = AxisScale::logarithmic};
  Series formula{.style = {.color = page.theme().text}, .markers = false};
  for (const double beta : {0.1, 1.0}) {  // a straight line on these axes
    formula.add(beta, 1000 * limit_by_formula(all.settings.dt, beta));
  }
  Series measured{.style = {page.theme().text, {}, Marker::square}, .line = false};
  TableView table{.header = {"β", "formula (mm)", "measured (mm)"}};
  for (const DepthLimit& limit : all.limits) {
    measured.add(limit.beta, 1000 * limit.measured);
    if (limit.beta == all.settings.beta) table.active_row = table.rows.size();
    table.rows.push_back(
        {fmt::format("{:g}", limit.beta), fixed(1000 * limit.formula, 2), fixed(1000 * limit.measured, 2)});
  }
  plot.series = {formula, measured};
  plot.labels = {{0.4, 1000 * limit_by_formula(all.settings.dt, 0.4), "g Δt² / β²"}};
  plot.goals.push_back({1000 * all.settings.depth, fmt::format("d = {:g} mm", 1000 * all.settings.depth)});
  draw_plot(page, parts[0], plot);
  const Rect rest =
      page.card(parts[1], "Held, or let go",
                "In step 1 the ball gets the speed β\u00a0d/Δt. In step 2 the row asks for (1\u00a0−\u00a0β) "
                "times as much. If "
                "gravity takes away less than the difference, λ would have to pull: the ground lets the ball "
                "go. The line is the formula, the squares are measured.");
  page.table(rest, "", table);
}

/// How deep the ball begins, and how high it comes: both, or the height alone.
void draw_lengths(Page& page, const Camera& camera, const DriftRuns& all, const BallLook& look) {
  const double depth = all.settings.depth;
  TextStyle style{.size = 18, .color = page.theme().text, .bold = true, .halo = page.theme().panel};
  const Stroke stroke{.width = page.sizes().outline, .color = page.theme().text};
  if (look.measured) {
    const double peak = ball_of(all, 1).height[look.step];
    draw_length(page, camera.project({0.75, 0}), camera.project({0.75, peak}), stroke);
    page.canvas().text(camera.project({0.8, 0.5 * peak}), significant(peak) + " m", style);
  }
  if (!look.asks) return;
  const double top = camera.unproject({0, camera.viewport.y}).y();  // from the ground to where?
  const FixedList<Point, 2> way = {camera.project({0.75, 0}), camera.project({0.75, top})};
  page.canvas().polyline(way, {.width = page.sizes().outline, .color = page.theme().text, .dash = {8, 6}});
  style.size = 20;
  page.canvas().text(camera.project({0.8, 0.8 * top}), "? m", style);
  const double between = -0.75;  // beside the ball
  draw_length(page, camera.project({between, 0}), camera.project({between, -depth}), stroke);
  style.align = Align::center;
  style.halo = page.theme().static_body;
  page.canvas().text(camera.project({between, -depth - 0.16}), fmt::format("{:g} mm", 1000 * depth), style);
}

}  // namespace

void draw_balls(Page& page, const Rect& rect, const DriftRuns& all, const BallLook& look) {
  const bool is_alone = all.balls.size() == 1;
  const std::string title = is_alone ? "" : "β of each ball";
  const std::string more = look.speeds ? "; before the push (m/s), grey: asked, blue: has" : "";
  const Rect inside = page.panel(rect, title + more);
  const double right = ball_pitch * (all.balls.size() - 1);
  const double top = 2 * ball_radius + std::max(highest_peak(all), 0.0) + 0.1;
  const double bottom = -0.35;                  // [m] at the lower edge of the panel
  const double beside = is_alone ? 1.2 : 0.65;  // [m] of room, for lengths
  Camera camera = fit(inside, {{-beside, bottom}, {right + beside, top}});
  camera.center.y() = bottom + 0.5 * camera.viewport.height / camera.scale;
  if (!look.speeds) draw_ghosts(page, camera, flights(all, look.step));
  WorldLook world{.numbers = camera.scale >= 45, .names = {""}};
  for (const BallRun& run : all.balls)
    world.names.push_back(fmt::format("{}{:g}", is_alone ? "β = " : "", run.beta));
  draw_world(page, camera, balls_together(all, look.step), world);
  if (look.speeds) draw_speeds(page, camera, all, look.step);
  draw_lengths(page, camera, all, look);
}

int highest_step(const DriftRuns& all) {
  const List<double>& height = ball_of(all, 1).height;
  return static_cast<int>(std::max_element(height.begin(), height.end()) - height.begin());
}

List<Shot> ball_shots(const DriftRuns& all) {
  const int last = last_step(all);
  const std::set<int> keys = {2};
  const int stride = std::max(1, last / 80);
  List<Shot> shots;
  for (int step = 1; step <= last; ++step) {
    if (step % stride != 0 && !keys.contains(step)) continue;
    shots.push_back(ball_shot(all, step, keys.contains(step)));
  }
  shots.push_back(key_shot(all, "how deep is too deep",
                           "The largest depth that the ground can hold falls like one over β squared; the "
                           "library's own limits lie on the formula.",
                           draw_limits));
  return shots;
}

namespace {

/// The ball of the question alone.
QuestionFrame frame_of(const DriftRuns& all, const std::string& state, const std::string& alt,
                       const BallLook& look) {
  return {.state = state, .alt = alt, .scene = [&all, look](Page& page, const Rect& rect) {
            draw_balls(page, rect, {.settings = all.settings, .balls = {ball_of(all, 1)}}, look);
          }};
}

std::string answer_text(const DriftRuns& all) {
  return fmt::format(
      "{} m. To be out in one step the ball needs {} m/s. It keeps that speed when it is out, because the "
      "ground can push but not pull.",
      significant(ball_of(all, 1).peak), significant(all.settings.depth / all.settings.dt));
}

}  // namespace

std::string beta_name(double beta) { return fmt::format("β = {:g}", beta); }

SeriesStyle beta_style(const Theme& theme, double beta) {
  if (beta == 0) return {.color = theme.text};
  if (beta == 0.1) return {.color = theme.secondary_text, .dash = {14, 6}};
  if (beta == 0.5) return {.color = theme.text, .dash = {2, 5}};
  if (beta == 1) return {.color = theme.secondary_text, .dash = {10, 5, 2, 5}};
  if (beta == 1.8) return {.color = theme.secondary_text, .dash = {4, 4}};
  if (beta == 2.1) return {.color = theme.text, .dash = {16, 4}};
  return {.color = theme.text, .dash = {10, 6}};  // the reader's
}

List<Shot> drift_shots(const DriftRuns& all) {
  List<Shot> shots = {question_shot(
      card(),
      frame_of(all, "before the first step",
               fmt::format("A ball with β = 1, {:g} mm inside the ground, and the question how high it comes",
                           1000 * all.settings.depth),
               {.asks = true}))};
  for (const List<Shot>& part : {ball_shots(all), swing_shots(all)})
    shots.insert(shots.end(), part.begin(), part.end());
  const int highest = highest_step(all);
  shots.push_back(answer_shot(card(),
                              frame_of(all, fmt::format("step {} · answer", highest),
                                       "The ball where it is highest, its height measured, and the answer.",
                                       {.step = highest, .measured = true}),
                              answer_text(all)));
  return shots;
}

}  // namespace cairn::drift
