// Lesson 00. The pictures of the flight.
#include "lesson.hpp"

namespace cairn::one_body {

namespace {

double height(const List<Vec2<double>>& path, int step) { return path[step].y(); }

/// One step in numbers: the velocity first, then the position with the new velocity.
Equation step_equation(const Story& story, int step) {
  const Flight& flight = story.flight;
  const Throw& thrown = flight.thrown;
  const double before = thrown.velocity.y() - thrown.gravity * thrown.dt * (step - 1);
  const double after = flight.cairn[step].bodies[{1}].velocity.y();
  const std::string dt = significant(thrown.dt);
  return {.number = fmt::format("eq (12), step {}", step),
          .symbols = "v_{y} ← v_{y} − g Δt,   then  y ← y + v_{y} Δt",
          .numbers = fmt::format("v_{{y}}: {} − {} × {} = {} m/s", fixed(before, 2),
                                 significant(thrown.gravity), dt, fixed(after, 2)),
          .result = fmt::format("y: {} {} {} × {} = {} m", fixed(height(flight.semi_implicit, step - 1), 3),
                                after < 0 ? "−" : "+", fixed(std::abs(after), 2), dt,
                                fixed(height(flight.semi_implicit, step), 3)),
          .algorithm =
              fmt::format("position first: {} m, exact: {} m", fixed(height(flight.explicit_euler, step), 3),
                          fixed(height(flight.exact, step), 3))};
}

TableView state_table(const Throw& thrown) {
  const auto number = [](double value, const char* unit) { return fixed(value, 1) + unit; };
  const Vec3<double>& v = thrown.velocity;
  return {.header = {"", "where", "v: how fast"},
          .rows = {{"x", number(thrown.start.x(), " m"), number(v.x(), " m/s")},
                   {"y", number(thrown.start.y(), " m"), number(v.y(), " m/s")},
                   {"θ", number(0, " rad"), number(v.z(), " rad/s")}}};
}

/// Left the scene, right two parts.
List<Rect> layout_of(const Page& page, double upper) {
  return in_columns(page, {0.62, {0.38, {upper, 1 - upper}}});
}

void draw_state(Page& page, const Story& story) {
  const List<Rect> parts = layout_of(page, 0.36);
  draw_scene(page, parts[0], story, {});
  page.table(parts[1], "three numbers, and their rates, eq (1)", state_table(story.flight.thrown));
  const List<Rect> below = in_rows(page, parts[2], {0.62, 0.38});
  const Rect inside = page.panel(below[0], "M⁻¹, eq (2): 1/kg, 1/kg, 1/(kg m²)");
  draw_matrix(page, {inside.x + 0.25 * inside.width, inside.y, 0.75 * inside.width, inside.height},
              {.values = story.flight.inverse_mass.asDiagonal(),
               .row_names = {"x", "y", "θ"},
               .column_names = {"x", "y", "θ"},
               .colors = MatrixColors::magnitude});
  page.equation(below[1], {.number = "1 kg, w = h = 1 m",
                           .symbols = "I = m (w² + h²) / 12",
                           .numbers = "= 1 × (1 + 1) / 12",
                           .result = "= 1/6 kg m²"});
}

Shot step_shot(const Story& story, int step) {
  const Flight& flight = story.flight;
  const int steps = flight.thrown.steps;
  const auto draw = [&story, step](Page& page) {
    const List<Rect> parts = layout_of(page, 0.62);
    draw_scene(page, parts[0], story, {.step = step});
    draw_errors(page, parts[1], story, step);
    page.equation(parts[2], step_equation(story, step));
  };
  return {
      .state = fmt::format("step {}/{} · t = {} s", step, steps, fixed(flight.time[step], 2)),
      .alt = fmt::format(
          "Step {}: the box at a height of {} m, the exact parabola at {} m, with the position first {} m.",
          step, fixed(height(flight.semi_implicit, step), 3), fixed(height(flight.exact, step), 3),
          fixed(height(flight.explicit_euler, step), 3)),
      .draw = draw,
      .key = step == steps};
}

Shot shot_of_answer(const Story& story) {
  const double end = swing_at_end(story.springs.explicit_euler);
  const std::string text = fmt::format(
      "{} m. Each step that moves first takes a velocity that is out of date, and multiplies the swing. With "
      "the velocity first the swing does not grow.",
      significant(end, 2));
  return answer_shot(
      card(),
      {.state = fmt::format("after {} s", significant(swing_seconds)),
       .alt = "Where the box is on its spring over two seconds: with the position first it swings "
              "further each time, up to a dashed line; with the velocity first it does not. " +
              text,
       .scene = [&story](Page& page, const Rect& rect) { draw_swings(page, rect, story.springs); }},
      text);
}

}  // namespace

List<Shot> pictures(const Story& story) {
  List<Shot> shots = {question_shot(card(), {.state = "before it is let go",
                                             .alt = "A box on a spring, pulled 1 m aside, and the question "
                                                    "how large its swing is after two seconds",
                                             .scene = draw_spring_question})};
  shots.push_back(key_shot(
      story, "on a spring",
      "Velocity against position, in the first swing and in all: with the position first a spiral that "
      "runs outwards, with the velocity first an ellipse beside the exact circle.",
      [](Page& page, const Story& of) { draw_loops(page, of.springs); }));
  shots.push_back(key_shot(story, "one body, three numbers",
                           "The box before the throw; a table of its position and its velocity; and M⁻¹ as a "
                           "diagonal matrix: 1, 1 and 6.",
                           draw_state));
  for (int step = 1; step <= story.flight.thrown.steps; ++step) shots.push_back(step_shot(story, step));
  shots.push_back(shot_of_answer(story));
  return shots;
}

}  // namespace cairn::one_body
