// Masses on a rope, the row of J that holds them, and the pull in the rope step by step.
#include "lesson.hpp"

namespace cairn::pulley {

namespace {

const double half_box = 0.3;  // [m] of a mass

/// A wheel, and the bar between its middle and what it hangs on or what hangs on it.
void draw_wheel(Page& page, const Camera& camera, const Vec2<double>& middle, double bar_end) {
  const Point hub = camera.project(middle);
  page.canvas().circle(
      hub, wheel_radius * camera.scale,
      {.fill = page.theme().static_body, .outline = page.theme().outline, .outline_width = 1.5});
  page.canvas().line(hub, camera.project({middle.x(), bar_end}), {.width = 3, .color = page.theme().outline});
  page.canvas().circle(hub, page.sizes().joint * 0.6, {.fill = page.theme().outline});
}

/// Half of a wheel's rim, from the angle `begin` on: clockwise where `turn` is -1.
void add_rim(List<Vec2<double>>& rope, const Vec2<double>& middle, double begin, double turn) {
  for (int i = 0; i <= 24; ++i) {
    const double angle = begin + turn * pi * i / 24;
    rope.push_back(middle + wheel_radius * Vec2<double>(std::cos(angle), std::sin(angle)));
  }
}

/// Half a wave from `top` down to `bottom`, longer by about `room` than the straight line: where slack hangs.
void add_bow(List<Vec2<double>>& rope, const Vec2<double>& top, const Vec2<double>& bottom, double room) {
  const double out = 2 / pi * std::sqrt(std::max(room, 0.0) * (top.y() - bottom.y()));
  for (int i = 0; i <= 24; ++i) {
    const double share = i / 24.0;
    rope.push_back(top + share * (bottom - top) + Vec2<double>(out * std::sin(pi * share), 0));
  }
}

/// The middle of the wheel above the second mass [m].
double loop_height(const PulleyStep& step) {
  return step.snapshot.bodies[{2}].pose.position.y() + half_box + wheel_radius + 0.3;
}

/// The wheels, and the rope over, under and over them, from the first mass to the third.
void draw_rope(Page& page, const Camera& camera, const PulleyStep& step) {
  const PerBody<SnapshotBody>& bodies = step.snapshot.bodies;
  const double r = wheel_radius;
  const double loop = loop_height(step), bar = wheel_height + r + 0.2;
  page.canvas().line(camera.project({-2.4, bar}), camera.project({2.4, bar}),
                     {.width = 4, .color = page.theme().outline});
  draw_wheel(page, camera, {-2 * r, wheel_height}, bar);
  draw_wheel(page, camera, {2 * r, wheel_height}, bar);
  draw_wheel(page, camera, {0, loop}, loop - r - 0.3);
  List<Vec2<double>> rope = {{-3 * r, bodies[{1}].pose.position.y() + half_box}};
  add_rim(rope, {-2 * r, wheel_height}, pi, -1);
  add_rim(rope, {0, loop}, pi, 1);
  add_rim(rope, {2 * r, wheel_height}, pi, -1);
  add_bow(rope, rope.back(), {3 * r, bodies[{3}].pose.position.y() + half_box}, step.room);
  List<Point> line;
  for (const Vec2<double>& place : rope) line.push_back(camera.project(place));
  page.canvas().polyline(line, {.width = 2.5 * page.sizes().outline, .color = page.theme().external});
  page.avoid(line);
}

/// The step in which the rope pulls hardest: that of the jerk, if there is one.
int hardest_pull(const PulleyRuns& all) {
  const List<PulleyStep>& steps = all.runs[0].steps;
  const auto weaker = [](const PulleyStep& a, const PulleyStep& b) { return a.tension < b.tension; };
  return static_cast<int>(std::max_element(steps.begin(), steps.end(), weaker) - steps.begin());
}

/// Newtons as lengths [N/m]: a weight is at most 1 m long, a pull 1.5 m, unless it is far beyond all weights.
double newtons_per_metre(const PulleyRuns& all) {
  const double heaviest = gravity * *std::max_element(all.settings.masses.begin(), all.settings.masses.end());
  const double hardest = all.runs[0].steps[hardest_pull(all)].tension;
  return std::max(std::min(hardest, 6 * heaviest) / 1.5, heaviest);
}

/// All that is ever to be seen, so that the picture stands still: the weights below the lowest places.
Aabb<double> all_of_run(const PulleyRuns& all) {
  double lowest = wheel_height;
  for (const PulleyStep& step : all.runs[0].steps) {
    for (int i = 0; i < 3; ++i) {
      const double weight = gravity * all.settings.masses[i] / newtons_per_metre(all);
      lowest = std::min(lowest, step.snapshot.bodies[{i + 1}].pose.position.y() - half_box - weight);
    }
  }
  return {{-3.5, lowest - 0.2}, {3.85, wheel_height + wheel_radius + 0.4}};
}

/// The masses on their rope.
Camera draw_masses(Page& page, const Rect& rect, const PulleyRuns& all, const PulleyStep& step) {
  const Camera camera = fit(page.panel(rect, ""), all_of_run(all));
  draw_rope(page, camera, step);
  WorldLook look{.names = {""}, .contacts = false};
  for (const double mass : all.settings.masses) look.names.push_back(fmt::format("{:g} kg", mass));
  look.numbers = camera.scale >= 45;
  Snapshot masses = step.snapshot;
  masses.joints.clear();  // the rope is drawn already, as it runs
  draw_world(page, camera, masses, look);
  return camera;
}

/// The weights, and the pull of each of the four parts of the rope.
void draw_pulls(Page& page, const Camera& camera, const PulleyRuns& all, const PulleyStep& step) {
  const ArrowScale scale{
      .pixels_per_unit = camera.scale / newtons_per_metre(all), .longest = 1.52 * camera.scale, .unit = "N"};
  for (int i = 0; i < 3; ++i) {
    const Vec2<double> middle = step.snapshot.bodies[{i + 1}].pose.position;
    const double weight = gravity * all.settings.masses[i];
    draw_arrow(page, camera, scale,
               {.kind = ArrowKind::external,
                .tail = middle - Vec2<double>(0, half_box),
                .value = {0, -weight},
                .label = fixed(weight, 0) + " N"});
    if (!(step.tension > 0)) continue;
    for (const double side : {-1.0, 1.0}) {
      if (i != 1 && side != i - 1) continue;  // the rope's first part is at the left, its last at the right
      const Vec2<double> tail = i == 1 ? Vec2<double>(side * (wheel_radius + 0.22), loop_height(step))
                                       : Vec2<double>(middle + Vec2<double>(side * 0.22, half_box));
      draw_arrow(page, camera, scale,
                 {.kind = ArrowKind::joint,
                  .tail = tail,
                  .value = {0, step.tension},
                  .label = significant(step.tension) + " N"});
    }
  }
}

/// A speed or an acceleration beside a mass.
void draw_motion(Page& page, const Camera& camera, const PulleyStep& step, int mass, double value,
                 double metres, const std::string& label) {
  const double beside = mass == 0 ? -0.7 : 0.55;
  draw_arrow(page, camera, {.pixels_per_unit = camera.scale * metres / std::abs(value), .longest = 1e3},
             {.kind = ArrowKind::velocity,
              .tail = step.snapshot.bodies[{mass + 1}].pose.position +
                      Vec2<double>(beside, value > 0 ? -half_box : half_box),
              .value = {0, value},
              .label = label});
}

void draw_row(Page& page, const Rect& rect, const PulleyRuns& all) {
  MatrixView view{.title = "J: one row, three bodies"};
  view.values = system_matrices(all.first).J.rightCols(9);  // without the ground's columns
  for (int body = 1; body <= 3; ++body) {
    for (const char* name : {"x", "y", "θ"})
      view.column_names.push_back(fmt::format("{}_{{{}}}", name, body));
  }
  view.column_group = 3;
  draw_matrix(page, rect, view);
}

void draw_equation(Page& page, const PulleyRuns& all) {
  const ConstraintRow<double>& row = all.first.rows[0];
  const double jv = row_velocity(all.first, row);
  const double inverse = inverse_effective_mass(all.first, row);
  const List<Rect> parts = in_columns(page, {0.5, {0.5, {0.21, 0.33, 0.46}}});
  draw_pulls(page, draw_masses(page, parts[0], all, all.runs[0].steps[1]), all, all.runs[0].steps[1]);
  draw_row(page, parts[1], all);
  page.equation(parts[2], {.number = "eq (22)",
                           .symbols = "λ = (ζ − j·v) / (j M⁻¹ jᵀ Δt)",
                           .numbers = fmt::format("= (0 − ({})) / ({} × {:g})", fixed(jv, 3),
                                                  fixed(inverse, 4), all.settings.dt),
                           .result = fmt::format("= {} N", fixed(all.runs[0].steps[1].tension, 3)),
                           .color = page.theme().text});
  TableView table{.header = {"solver, one sweep", "λ (N)"}};
  for (const PulleyRun& run : all.runs) table.rows.push_back({run.solver, fixed(run.steps[1].tension, 3)});
  page.table(parts[3], "the same row in seven solvers", table);
}

/// Something of each step, over the steps; what comes after step k is pale.
Plot over_run(const Page& page, const PulleyRuns& all, int k, double (*value)(const PulleyStep&)) {
  Plot plot;
  plot.x = {.title = "step", .min = 0, .max = all.settings.steps};
  List<double> values;
  for (const PulleyStep& step : all.runs[0].steps) values.push_back(value(step));
  const double most = *std::max_element(values.begin(), values.end());
  plot.y = {.min = 0, .max = std::max(1.15 * most, 1e-3)};
  plot.series.push_back(over_steps("", page.theme().si, values));
  plot.now = k;
  return plot;
}

void draw_step(Page& page, const PulleyRuns& all, int k) {
  const List<Rect> parts = in_columns(page, {0.5, {0.5, {0.55, 0.45}}});
  const PulleyStep& step = all.runs[0].steps[k];
  const Camera camera = draw_masses(page, parts[0], all, step);
  draw_pulls(page, camera, all, step);
  if (k == all.settings.lift_step + 1 && all.settings.lift > 0)
    draw_motion(page, camera, step, 2, step.speed[2], 1, significant(step.speed[2]) + " m/s");
  Plot pull = over_run(page, all, k, [](const PulleyStep& one) { return one.tension; });
  pull.series[0].y[0] = std::nan("");  // no step has been made
  pull.title = "pull in the rope, λ (N)";
  const double tension = tension_by_hand(all.settings);
  pull.goals.push_back({tension, fmt::format("by hand: {} N", fixed(tension, 1))});
  const int lift = all.settings.lift_step;
  if (all.settings.lift > 0 && lift < all.settings.steps)
    pull.labels.push_back({0, 0.4 * tension, fmt::format("thrown up after {}", lift)});
  draw_plot(page, parts[1], pull);
  Plot room = over_run(page, all, k, [](const PulleyStep& one) { return 1000 * one.room; });
  room.title = "rope left over, c (mm)";
  draw_plot(page, parts[2], room);
}

Shot step_shot(const PulleyRuns& all, int k, const std::set<int>& keys) {
  const PulleyStep& step = all.runs[0].steps[k];
  const bool slack = step.tension <= 0;
  return {.state = fmt::format("step {} · {}", k, slack ? "the rope is slack" : "the rope is taut"),
          .alt = fmt::format(
              "Step {}: the rope is {} and pulls with {:.2f} N; the masses move at {:.2f}, {:.2f} and "
              "{:.2f} m/s upwards.",
              k, slack ? "slack" : "taut", step.tension, step.speed[0], step.speed[1], step.speed[2]),
          .draw = [&all, k](Page& page) { draw_step(page, all, k); },
          .key = keys.contains(k)};
}

/// The masses before or after the first step, which is asked for; then with their accelerations.
QuestionFrame moment(const PulleyRuns& all, int k) {
  const auto scene = [&all, k](Page& page, const Rect& rect) {
    const PulleyStep& step = all.runs[0].steps[k];
    const Camera camera = draw_masses(page, rect, all, step);
    draw_pulls(page, camera, all, step);
    TextStyle text = page.value();
    text.size *= 1.3;
    if (k == 0) page.canvas().text(camera.project({-3 * wheel_radius + 0.12, 3.6}), "λ = ? N", text);
    for (int mass = 0; k > 0 && mass < 3; ++mass) {
      const double acceleration = step.speed[mass] / all.settings.dt;
      if (std::abs(acceleration) > 1e-6)
        draw_motion(page, camera, step, mass, acceleration, std::abs(acceleration) / 8,
                    fixed(acceleration, 1, Sign::always) + " m/s²");
    }
  };
  return {.state = k == 0 ? "before the first step" : "after the first step",
          .alt = k == 0 ? "Three masses of 1, 2 and 3 kg on one rope over two fixed wheels and one movable "
                          "wheel, and the question."
                        : "The masses with their weights, the pull of each part of the rope and their "
                          "accelerations, and the answer.",
          .scene = scene};
}

}  // namespace

List<Shot> pulley_shots(const PulleyRuns& all) {
  const int last = all.settings.steps;
  const int lift = all.settings.lift_step;
  const std::set<int> keys = {lift + 1, hardest_pull(all)};
  List<Shot> shots = {question_shot(card(), moment(all, 0))};
  shots.push_back(key_shot(
      all, "step 1 · one row, one sweep",
      "Equation (22) for the row of the rope, filled in, and the answer of seven solvers.", draw_equation));
  for (int k = 2; k <= last; ++k) shots.push_back(step_shot(all, k, keys));
  const double tension = tension_by_hand(all.settings);
  shots.push_back(
      answer_shot(card(), moment(all, 1),
                  fmt::format("{} N, in one sweep: (22) has a third term in its sums, and nothing "
                              "else changes. Where the rope pulls with less than the weight, a "
                              "mass goes down.",
                              significant(tension))));
  return shots;
}

}  // namespace cairn::pulley
