// A weight on a soft row beside one on a row without gamma: every step, the question, and the answer.
#include "lesson.hpp"

namespace cairn::soft {

namespace {

const double soft_x = 0;  // [m] where the weights stand in the picture
const double rigid_x = 1.1;
const double left_x = -0.5;
const double right_x = 1.75;
const double asked_right_x = 1.2;  // before the first step, with one weight
const int most_frames = 75;        // of the motion

int last_step(const SoftRuns& all) { return all.spring.steps.size() - 1; }

/// Ground, the height of the weights' lower edges without load, and how far the soft row's is from it.
void draw_levels(Page& page, const Camera& camera, double error, double right) {
  const List<Point> ground_outline = {camera.project({left_x, 0}), camera.project({right, 0}),
                                      camera.project({right, -0.06}), camera.project({left_x, -0.06})};
  page.canvas().polygon(ground_outline, {.fill = page.theme().static_body});
  page.canvas().hatch(ground_outline, {.width = 1, .color = page.theme().static_hatch},
                      page.sizes().hatch_pitch);
  page.canvas().line(camera.project({left_x, rest_length}), camera.project({right, rest_length}),
                     {.width = 1.5, .color = page.theme().secondary_text, .dash = {8, 5}});
  page.canvas().text(camera.project({rigid_x - half_height - 0.03, rest_length + 0.03}), "c = 0: no load",
                     aligned(page.label(), Align::right));
  const Stroke thin{.width = 1.5, .color = page.theme().text};
  const double x = left_x + 0.1, foot = rest_length + error;
  page.canvas().line(camera.project({x, rest_length}), camera.project({x, foot}), thin);
  page.canvas().line(camera.project({x - 0.04, foot}), camera.project({soft_x - half_height, foot}), thin);
  page.canvas().text(camera.project({x - 0.05, std::min(foot, rest_length) - 0.1}),
                     fixed(1000 * error + 0.0, 0) + " mm", page.label());
}

/// The push of a row beside its weight: 110 N are three quarters of a metre long for 1 kg. Its number is
/// `below` px under its tail.
void draw_push(Page& page, const Camera& camera, const SoftRuns& all, const Vec2<double>& tail, double lambda,
               const std::string& text, ArrowKind kind, double below = 24) {
  const double weight = all.settings.mass * gravity;
  const ArrowScale scale{
      .pixels_per_unit = 0.068 * camera.scale / weight, .longest = 0.8 * camera.scale, .unit = "N"};
  draw_arrow(page, camera, scale, {.kind = kind, .tail = tail, .value = {0, lambda}});
  if (lambda * scale.pixels_per_unit > scale.longest) return;  // then it says so itself
  const bool is_up = lambda > -0.2 * weight;                   // shorter ones are dots
  page.canvas().text(camera.project(tail) + Point(-14, is_up ? below : -10), text, page.value());
}

/// Upwards, but of no length that could be measured.
void draw_unknown_push(Page& page, const Point& tail) {
  page.canvas().line(tail, tail - Point(0, 34), {.width = 3, .color = page.theme().inactive, .dash = {6, 5}});
  page.canvas().text(tail + Point(-14, 24), "? N", page.value());
}

std::string newtons(const SoftRuns& all, double lambda) {
  return fixed(lambda + 0.0, all.settings.mass < 0.1 ? 3 : all.settings.mass < 10 ? 1 : 0) + " N";
}

void draw_weight(Page& page, const Camera& camera, const SoftRuns& all, const WeightRun& run, int step,
                 double x) {
  Snapshot scene = run.steps[step];
  scene.joints.clear();
  scene.bodies[{1}].pose.position.x() += x;
  const double foot = rest_length + run.error[step];
  const bool is_soft = run.gamma > 0;
  if (is_soft) {
    draw_spring(page, camera, x, 0, foot, style_of_soft(page));
  } else {
    page.canvas().line(camera.project({x, 0}), camera.project({x, foot}),
                       {.width = page.sizes().curve, .color = style_of_rigid(page).color});
  }
  draw_world(page, camera, scene, {.names = {"", fmt::format("{:g} kg", all.settings.mass)}});
  const double lambda = run.rows[std::max(step, 1)].lambda;
  const double force = stiffness(all.settings) * all.settings.pressed;
  const Vec2<double> tail(x + 0.22, foot);
  if (step == 0 && is_soft) {
    draw_unknown_push(page, camera.project(tail));
  } else {
    draw_push(page, camera, all, tail, lambda, newtons(all, lambda), ArrowKind::joint);
  }
  if (step == 1 && is_soft)
    draw_push(page, camera, all, tail + Vec2<double>(0.12, 0), force, "as a force " + newtons(all, force),
              ArrowKind::inactive, 46);
  TextStyle name = aligned(page.label(), Align::center);
  const Point at = camera.project({x, -0.08});
  page.canvas().text({at.x(), at.y() + name.size}, is_soft ? "soft row" : "rod, same β", name);
}

/// Both weights; of the question the one on the spring, with what is known of it.
void draw_weights(Page& page, const Rect& rect, const SoftRuns& all, int step) {
  const Rect inside = page.panel(rect, "");
  const double right = step == 0 ? asked_right_x : right_x;
  const Camera camera = fit(inside, {{left_x, -0.2}, {right, step == 0 ? 1.25 : 1.7}});
  draw_levels(page, camera, all.spring.error[step], right);
  draw_weight(page, camera, all, all.spring, step, soft_x);
  if (step > 0) return draw_weight(page, camera, all, all.rigid, step, rigid_x);
  TextStyle text = page.value();
  text.size *= 1.3;
  const Point beside = camera.project({soft_x + 0.35, 0.5 * rest_length});
  page.canvas().text(beside, fmt::format("k = {} N/m", fixed(stiffness(all.settings), 1)), text);
  page.canvas().text(beside + Point(0, 1.6 * text.size),
                     fmt::format("d = {} N s/m", fixed(damping_constant(all.settings), 2)), text);
}

/// c against time; what comes after `step` is pale.
void draw_errors(Page& page, const Rect& rect, const SoftRuns& all, int step) {
  Plot plot{.title = "c (mm), 0 without load"};
  plot.x = {.title = "t (s)", .min = 0, .max = seconds};
  Series exact{.name = "exact", .style = page.theme().exact, .markers = false};
  exact.style.marker = Marker::none;
  exact.style.dash = {8, 5};
  const int points = std::clamp(static_cast<int>(40 * all.settings.frequency * seconds), 200, 4000);
  double lowest = 0;
  double highest = 0;
  for (int i = 0; i <= points; ++i) {
    const double time = seconds * i / points;
    exact.add(time, 1000 * exact_error(all.settings, time));
    lowest = std::min(lowest, exact.y.back());
    highest = std::max(highest, exact.y.back());
  }
  plot.y = {.min = lowest - 10, .max = highest + 20};
  plot.series.push_back(exact);
  const auto add = [&](const std::string& name, const WeightRun& run, const SeriesStyle& style) {
    Series series{.name = name, .style = style};
    for (int k = 0; k * all.settings.dt <= seconds + 1e-9 && k < run.error.size(); ++k)
      series.add(k * all.settings.dt, 1000 * run.error[k]);
    plot.series.push_back(series);
  };
  add("soft row", all.spring, style_of_soft(page));
  add("rod", all.rigid, style_of_rigid(page));
  plot.now = step * all.settings.dt;
  draw_plot(page, rect, plot);
}

void draw_step(Page& page, const SoftRuns& all, int step) {
  const List<Rect> parts = in_columns(page, {0.5, {0.5, {0.56, 0.44}}});
  draw_weights(page, parts[0], all, step);
  draw_errors(page, parts[1], all, step);
  const StepRow& row = all.spring.rows[step];
  page.equation(parts[2], {.number = "eq (22), the soft row",
                           .symbols = "λ = (ζ − j·v) / ((A + γ) Δt)",
                           .numbers = fmt::format("= ({} − {}) / (({:.3g} + {:.3g}) × {:.3g})",
                                                  fixed(row.zeta, 3), in_brackets(fixed(row.free, 3)),
                                                  1 / all.settings.mass, all.spring.gamma, all.settings.dt),
                           .result = fmt::format("= {} N", fixed(row.lambda, 2)),
                           .algorithm = fmt::format("ζ = −β c / Δt, β = {:.4f} in both", all.spring.beta),
                           .color = style_of_soft(page).color});
}

Shot step_shot(const SoftRuns& all, int step, bool key) {
  const double time = step * all.settings.dt;
  return {.state = fmt::format("step {} · t = {} s", step, fixed(time, 2)),
          .alt = fmt::format(
              "After {:.2f} s the weight on the soft row is {:.1f} mm from where its spring has "
              "no load, exactly it would be {:.1f} mm; the one on the rod {:.1f} mm. The rows push "
              "with {:.1f} and {:.1f} N.",
              time, 1000 * all.spring.error[step], 1000 * exact_error(all.settings, time),
              1000 * all.rigid.error[step] + 0.0, all.spring.rows[step].lambda, all.rigid.rows[step].lambda),
          .draw = [&all, step](Page& page) { draw_step(page, all, step); },
          .key = key};
}

/// The weights before or after the first step, which is asked for.
QuestionFrame weights_frame(const SoftRuns& all, int step) {
  return {.state = step == 0 ? "before the first step" : "after the first step",
          .alt = step == 0 ? "A weight on a spring, 200 mm too low, with its k and d; the spring's unknown "
                             "push; and the question."
                           : "Both weights after the first step with the pushes of their rows on one scale, "
                             "the spring's as a force in pale beside them; and the "
                             "answer.",
          .scene = [&all, step](Page& page, const Rect& rect) { draw_weights(page, rect, all, step); }};
}

}  // namespace

void draw_spring(Page& page, const Camera& camera, double x, double bottom, double top,
                 const SeriesStyle& style) {
  const int turns = 7;
  const double straight = 0.08 * (top - bottom);
  const double pitch = (top - bottom - 2 * straight) / turns;
  List<Point> points = {camera.project({x, bottom}), camera.project({x, bottom + straight})};
  for (int i = 0; i < turns; ++i) {
    const double side = i % 2 == 0 ? 0.1 : -0.1;
    points.push_back(camera.project({x + side, bottom + straight + pitch * (i + 0.5)}));
  }
  points.push_back(camera.project({x, top - straight}));
  points.push_back(camera.project({x, top}));
  page.canvas().polyline(points, {.width = page.sizes().curve, .color = style.color});
}

SeriesStyle style_of_soft(const Page& page) { return render::neutral_styles(page.theme())[0]; }
SeriesStyle style_of_rigid(const Page& page) { return render::neutral_styles(page.theme())[1]; }

List<Shot> soft_shots(const SoftRuns& all) {
  List<Shot> shots = {question_shot(card(), weights_frame(all, 0))};
  const int frames = std::min(last_step(all), most_frames);
  const std::set<int> keys = {1, 5};
  for (int frame = 1; frame <= frames; ++frame)
    shots.push_back(step_shot(all, frame * last_step(all) / frames, keys.contains(frame)));
  for (const List<Shot>& more : {stiff_shots(all), column_shots(all), harsh_shots(all)})
    shots.insert(shots.end(), more.begin(), more.end());
  shots.push_back(answer_shot(
      card(), weights_frame(all, 1),
      fmt::format(
          "{} N, less than −k c = {}\u00a0N. At the end of the step the spring is longer, and its damper "
          "resists: the row pushes with the force of that moment.",
          fixed(all.spring.rows[1].lambda, 1), fixed(stiffness(all.settings) * all.settings.pressed, 1))));
  return shots;
}

}  // namespace cairn::soft
