// The box on its feet: who pushes how hard, the sum of it, and the speed that it leaves.
#include "lesson.hpp"

namespace cairn::everybody {

namespace {

const double box_middle = 0.62;  // [m] as the snapshot has it
const double sum_place = 1.1;    // [m] where the pushes stand upon each other, beside the box
const double weight_place = 1.42;

/// The pushes of all feet at their feet, and once more tip to tail beside the weight.
void draw_pushes(Page& page, const Camera& camera, const FeetRun& run, int sweep) {
  const List<double>& lambda = history_of(run, Method::plain).lambda[sweep];
  const double weight = box_mass * gravity;
  const ArrowScale forces{.pixels_per_unit = 1.3 * camera.scale / (weight * std::max(1.0, run.answer)),
                          .longest = 2 * camera.scale};
  const double metres = forces.pixels_per_unit / camera.scale;  // for a newton
  TextStyle text = aligned(page.value(), Align::center);
  draw_arrow(page, camera, forces,
             {.kind = ArrowKind::external, .tail = {weight_place, weight * metres}, .value = {0, -weight}});
  const Point top = camera.project({weight_place, weight * metres + 0.03});
  page.canvas().text(top - Point(0, 1.3 * text.size), "weight", text);
  page.canvas().text(top, fmt::format("{:g} N", weight), text);
  text.bold = true;
  double height = 0;
  for (int i = 0; i < lambda.size(); ++i) {
    if (!(lambda[i] > 0)) continue;
    const Vec2<double> foot(run.problem.rows[i].jacobian_b.z(), box_middle - 0.5);
    draw_arrow(page, camera, forces, {.tail = foot, .value = {0, lambda[i]}});
    draw_arrow(page, camera, forces, {.tail = {sum_place, height}, .value = {0, lambda[i]}});
    height += lambda[i] * metres;
    if (lambda.size() <= 3) {
      page.canvas().text(camera.project(foot + Vec2<double>(0, lambda[i] * metres + 0.03)),
                         fixed(lambda[i], 1) + " N", text);
    }
  }
  text.size = page.sizes().question;
  page.canvas().text(camera.project({sum_place, height + 0.03}),
                     sweep == 0 ? "? N" : fixed(together(lambda), 1) + " N", text);
}

/// The box with what each foot has given so far, and how fast it moves.
void draw_feet(Page& page, const Rect& rect, const FeetRun& run, int sweep) {
  const Rect inside = page.panel(rect, "");
  Camera camera = fit(inside, {{-0.6, -0.1}, {1.6, 1.35}});
  camera.center.y() = 0.5 * inside.height / camera.scale - 0.15;  // little of the ground
  draw_world(page, camera, run.snapshot, {.numbers = false, .contacts = false});
  draw_pushes(page, camera, run, sweep);
  const double speed = history_of(run, Method::plain).speed[sweep];
  const double fastest = gravity * time_step * std::max(1.0, run.answer - 1);
  draw_arrow(page, camera, {.pixels_per_unit = 0.3 * camera.scale / fastest, .longest = camera.scale},
             {.kind = ArrowKind::velocity, .tail = {0.62, box_middle}, .value = {0, speed}});
  page.canvas().text(camera.project({0.67, box_middle + 0.12 * speed / fastest}),
                     fixed(speed, 3, Sign::always) + " m/s", page.value());
}

/// What a sweep of plain Jacobi does.
std::string sweep_text(const FeetRun& run, int sweep) {
  if (sweep == 1) {
    return fmt::format(
        "Each foot sees the whole fall, and stops it as if it were alone. Together they give {} times "
        "the weight.",
        fixed(run.answer, 2));
  }
  if (run.answer <= 2)
    return fmt::format("Every sweep leaves 1 − q = {} of the speed.", fixed(1 - run.answer, 2));
  if (sweep % 2 == 1) return "The same as sweep 1: it repeats for ever.";
  return "The box goes up, so every foot would have to pull. A contact cannot: all λ go back to 0, and the "
         "box falls as before. The next sweep is the first one again, and so on for ever.";
}

void draw_sweep(Page& page, const FeetRun& run, int sweep) {
  const List<Rect> parts = in_columns(page, {0.56, {0.44, {0.5, 0.5}}});
  draw_feet(page, parts[0], run, sweep);
  const FeetHistory& plain = history_of(run, Method::plain);
  const double before = plain.lambda[sweep - 1][0];
  const double after = plain.lambda[sweep][0];
  const double speed = plain.speed[sweep - 1];
  page.equation(
      parts[1],
      {.number = "eq (22), foot 1; the others do the same at the same time",
       .symbols = "λ ← max(0, λ − j·v / (A_{11} Δt))",
       .numbers =
           fmt::format("= max(0, {} − {} / ({} × {:g}))", fixed(before, 2), in_brackets(fixed(speed, 3)),
                       fixed(inverse_effective_mass(run.problem, run.problem.rows[0]), 4), time_step),
       .result = fmt::format("= {} N", fixed(after, 2)),
       .algorithm = fmt::format("then v: {} → {} m/s", fixed(speed, 3), fixed(plain.speed[sweep], 3)),
       .color = page.theme().normal});
  page.note(parts[2], fmt::format("Sweep {}", sweep), sweep_text(run, sweep));
}

Shot sweep_shot(const FeetRun& run, int sweep) {
  const FeetHistory& plain = history_of(run, Method::plain);
  return {.state = fmt::format("plain Jacobi · sweep {}", sweep),
          .alt = fmt::format("Plain Jacobi after sweep {}: the feet push with {:.1f} N together, the weight "
                             "being 60 N, and the box moves at {:.3f} m/s upwards.",
                             sweep, together(plain.lambda[sweep]), plain.speed[sweep]),
          .draw = [&run, sweep](Page& page) { draw_sweep(page, run, sweep); },
          .key = sweep <= 2};
}

/// The four methods' speeds, and the number that decides.
void draw_speeds(Page& page, const FeetRun& run) {
  const List<Rect> parts = in_rows(page, {0.62, {0.38, {0.6, 0.4}}});
  Plot plot{.title = "|v| of the box after each sweep (m/s), on a logarithmic axis"};
  plot.x = {.title = "sweep"};
  plot.y = {.title = "", .scale = AxisScale::logarithmic, .min = 1e-10, .max = 1};
  for (const FeetHistory& history : run.histories) {
    List<double> size;
    for (const double speed : history.speed) {
      if (std::abs(speed) < plot.y.min) break;  // a name stands where its curve ends
      size.push_back(std::abs(speed));
    }
    plot.series.push_back(over_steps(method_name(history.method, run.settings.omega),
                                     style_of(page.theme(), history.method), size));
  }
  draw_plot(page, parts[0], plot);
  TableView table;
  table.header = {"method", "the speed", "q = ω Σ c", "left after 5"};
  table.text_columns = 2;
  for (const FeetHistory& history : run.histories) {
    const bool in_turn = history.method == Method::sequential;
    const double taken = taken_at_once(run, history.method);
    const std::string verdict = taken > 2   ? "repeats for ever"
                                : taken > 1 ? "overshoots, converges"
                                            : "converges";
    table.rows.push_back({method_name(history.method, run.settings.omega), in_turn ? "converges" : verdict,
                          in_turn ? "·" : fixed(taken, 3),
                          fixed(100 * std::abs(history.speed[5]) / (gravity * time_step), 2) + " %"});
  }
  page.table(parts[1], "", table);
  page.note(parts[2], "What decides",
            "One sweep leaves 1 − q of the speed. q = 1: done in one sweep; q < 2: "
            "converges; q > 2: grows, or never ends.");
}

List<Shot> feet_shots(const FeetRun& run) {
  List<Shot> shots;
  shots.push_back(question_shot(
      card(),
      {.state = "before the first sweep",
       .alt = fmt::format("A box that comes down on {} feet, none of which pushes yet, and the question",
                          run.settings.feet),
       .scene = [&run](Page& page, const Rect& rect) { draw_feet(page, rect, run, 0); }}));
  for (int sweep = 1; sweep <= run.settings.sweeps; ++sweep) shots.push_back(sweep_shot(run, sweep));
  shots.push_back(
      key_shot(run, fmt::format("four methods, {} sweeps", run.settings.sweeps),
               "Speed of the box against sweeps: plain Jacobi, damped, with split masses, and SI; below it "
               "the share q that one sweep of each removes.",
               draw_speeds));
  return shots;
}

/// "43.6 + 60.0 + 43.6", where there is room for so many.
std::string summands(const List<double>& lambda) {
  if (lambda.size() > 4) return fmt::format("{} feet", lambda.size());
  std::string text;
  for (const double each : lambda) text += (text.empty() ? "" : " + ") + fixed(each, 1);
  return text;
}

Shot last_shot(const FeetRun& run) {
  const List<double>& first = history_of(run, Method::plain).lambda[1];
  const std::string text = fmt::format(
      "{} N: {}. Each foot stops the whole fall, as if it were alone, and the box is thrown up. So in sweep "
      "2 "
      "all let go: {:.0f} N. Damped, or with split masses, Jacobi converges.",
      fixed(together(first), 1), summands(first), together(history_of(run, Method::plain).lambda[2]));
  return answer_shot(card(),
                     {.state = "after the first sweep",
                      .alt = "The box after the first sweep: the three pushes, tip to tail, are more than "
                             "twice as long as the weight.",
                      .scene = [&run](Page& page, const Rect& rect) { draw_feet(page, rect, run, 1); }},
                     text);
}

}  // namespace

std::string method_name(Method method, double omega) {
  if (method == Method::plain) return "Jacobi";
  if (method == Method::damped) return fmt::format("Jacobi, ω = {:.2g}", omega);
  return method == Method::split ? "Jacobi, split" : "SI";
}

SeriesStyle style_of(const Theme& theme, Method method) {
  if (method == Method::plain) return theme.jacobi;
  if (method == Method::damped) return render::style_of_solver(theme, "jacobi-damped");
  if (method == Method::split) return render::style_of_solver(theme, "jacobi-split");
  return theme.si;
}

List<Shot> everybody_shots(const FeetRun& feet, const PileRun& pile) {
  List<Shot> shots = feet_shots(feet);
  for (Shot& shot : pile_shots(pile)) shots.push_back(std::move(shot));
  shots.push_back(last_shot(feet));
  return shots;
}

}  // namespace cairn::everybody
