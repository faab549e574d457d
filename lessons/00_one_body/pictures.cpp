// Lesson 00. The pictures of the flight.
#include "parts.hpp"

#include <fmt/core.h>

#include <cmath>
#include <memory>

#include "lessons/question.hpp"
#include "math/list.hpp"
#include "render/matrix.hpp"
#include "render/plot.hpp"
#include "render/rects.hpp"
#include "scene.hpp"

namespace cairn::one_body {

namespace {

using namespace render;

double height(const List<Vec2<double>>& path, int step) { return path[step].y(); }

/// One step in numbers: the velocity first, then the position with the new velocity.
Equation step_equation(const Story& story, int step) {
  const Throw& thrown = story.flight.thrown;
  const double before = thrown.velocity.y() - thrown.gravity * thrown.dt * (step - 1);
  const double after = story.flight.cairn[step].bodies[{1}].velocity.y();
  const std::string dt = significant(thrown.dt, 3);
  Equation equation;
  equation.number = fmt::format("left half of (12), step {}", step);
  equation.symbols = "v ← v + g Δt,   then  y ← y + v_{y} Δt";
  equation.numbers = fmt::format("v_{{y}}: {} − {} × {} = {} m/s", fixed(before, 2),
                                 significant(thrown.gravity, 3), dt, fixed(after, 2));
  equation.result =
      fmt::format("y: {} {} {} × {} = {} m", fixed(height(story.flight.semi_implicit, step - 1), 3),
                  after < 0 ? "−" : "+", fixed(std::abs(after), 2), dt,
                  fixed(height(story.flight.semi_implicit, step), 3));
  equation.algorithm =
      fmt::format("explicit Euler {} m, exact {} m", fixed(height(story.flight.explicit_euler, step), 3),
                  fixed(height(story.flight.exact, step), 3));
  return equation;
}

using SharedStory = std::shared_ptr<const Story>;

TableView known_table(const Story& story) {
  const Throw& thrown = story.flight.thrown;
  TableView table;
  table.rows.push_back(
      {"velocity", fixed(thrown.velocity.x(), 1) + ", " + fixed(thrown.velocity.y(), 1) + " m/s"});
  table.rows.push_back({"gravity", significant(thrown.gravity) + " m/s²"});
  table.rows.push_back({"time step Δt", significant(thrown.dt) + " s"});
  table.rows.push_back({"steps", std::to_string(thrown.steps)});
  table.rows.push_back({"height above the parabola", "? m"});
  table.active_row = table.rows.size() - 1;
  return table;
}

Shot question_shot(const SharedStory& story) {
  Shot shot;
  shot.key = true;
  shot.state = "before the throw";
  shot.alt =
      "A box of 1 kg before its flight, its velocity as an arrow, the exact parabola as a thin line. " +
      story->question;
  shot.draw = [story](Page& page) {
    const Layout layout = layout_of(page);
    draw_scene(page, *story, 0);
    const List<Rect> parts = rows(united(layout.upper, layout.lower), {32, 26, 42}, page.sizes().gap);
    page.note(parts[0], "The question", story->question);
    page.equation(
        parts[1],
        {.number = "each step", .symbols = "v ← v + g Δt", .numbers = "x ← x + v Δt, with the new v"});
    page.table(parts[2], "what is given", known_table(*story));
  };
  return shot;
}

Shot answer_shot(const SharedStory& story) {
  const double error = final_error(story->flight, story->flight.semi_implicit);
  const std::string text = fmt::format(
      "Below, by {} m = g Δt t/2: each step takes the velocity of its end. Explicit Euler takes that of its "
      "beginning, and ends as far above.",
      fixed(-error, 3));
  Shot shot;
  shot.key = true;
  shot.state = fmt::format("after {} s", significant(story->flight.time.back(), 3));
  shot.alt =
      "The box at the end of its flight below the exact parabola, explicit Euler as far above it. " + text;
  shot.draw = [story, text](Page& page) {
    const Layout layout = layout_of(page);
    draw_scene(page, *story, story->flight.thrown.steps);
    draw_errors(page, layout.upper, *story, story->flight.thrown.steps);
    page.note(layout.lower, "The answer", text, question_growth);
  };
  return shot;
}

MatrixView inverse_mass_view(const Story& story) {
  MatrixView view = {.title = "M⁻¹   eq (2)"};
  view.values = story.flight.inverse_mass.asDiagonal();
  view.row_names = {"x", "y", "θ"};
  view.column_names = {"x", "y", "θ"};
  view.colors = MatrixColors::magnitude;
  return view;
}

Equation inertia_equation() {
  return {.number = "1 kg, w = h = 1 m",
          .symbols = "I = m (w² + h²) / 12",
          .numbers = "= 1 × (1 + 1) / 12",
          .result = "= 1/6 kg m²"};
}

TableView state_table(const Story& story) {
  const Throw& thrown = story.flight.thrown;
  TableView table = {.header = {"", "where", "rate v", "M⁻¹"}};
  const Vec3<double>& w = story.flight.inverse_mass;
  table.rows.push_back({"x", fixed(thrown.start.x(), 1) + " m", fixed(thrown.velocity.x(), 1) + " m/s",
                        fixed(w.x(), 1) + " /kg"});
  table.rows.push_back({"y", fixed(thrown.start.y(), 1) + " m", fixed(thrown.velocity.y(), 1) + " m/s",
                        fixed(w.y(), 1) + " /kg"});
  table.rows.push_back(
      {"θ", fixed(0, 1) + " rad", fixed(thrown.velocity.z(), 1) + " rad/s", fixed(w.z(), 1) + " /(kg m²)"});
  return table;
}

Shot state_shot(const SharedStory& story) {
  Shot shot;
  shot.key = true;
  shot.state = "one body, three numbers";
  shot.alt =
      "The box before the throw; a table of its position, its velocity and its inverse masses; and M⁻¹ as a "
      "diagonal matrix: 1, 1 and 6.";
  shot.draw = [story](Page& page) {
    const Layout layout = layout_of(page);
    draw_scene(page, *story, 0);
    const List<Rect> parts = rows(united(layout.upper, layout.lower), {30, 26, 44}, page.sizes().gap);
    page.table(parts[0], "where it is, how fast, how light   eq (1), (2)", state_table(*story));
    page.equation(parts[1], inertia_equation());
    draw_matrix(page, parts[2], inverse_mass_view(*story));
  };
  return shot;
}

Shot step_shot(const SharedStory& story, int step) {
  const Flight& flight = story->flight;
  const int steps = flight.thrown.steps;
  Shot shot;
  shot.key = step <= 3 || step == steps / 3 || step == 2 * steps / 3 || step == steps;
  shot.state = fmt::format("step {}/{} · t = {} s", step, steps, fixed(flight.time[step], 2));
  shot.alt =
      fmt::format("Step {}: the box at a height of {} m, the exact parabola at {} m, explicit Euler at {} m.",
                  step, fixed(height(flight.semi_implicit, step), 3), fixed(height(flight.exact, step), 3),
                  fixed(height(flight.explicit_euler, step), 3));
  shot.draw = [story, step](Page& page) {
    const Layout layout = layout_of(page);
    draw_scene(page, *story, step);
    draw_errors(page, layout.upper, *story, step);
    page.equation(layout.lower, step_equation(*story, step));
  };
  return shot;
}

/// Measured points of one method; both methods miss by the same, so they lie on each other.
Series measured(const std::string& name, SeriesStyle style, const List<double>& dt,
                const List<double>& errors) {
  Series series = {.name = name, .style = style, .line = false};
  for (int i = dt.size() - 1; i >= 0;
       --i) {  // from short steps to long ones: the name stands at the right end
    series.x.push_back(dt[i]);
    series.y.push_back(std::abs(errors[i]));
  }
  return series;
}

void draw_convergence(Page& page, const Rect& rect, const Story& story) {
  const Convergence& c = story.convergence;
  const double time = story.flight.time.back();
  const double gravity = story.flight.thrown.gravity;
  Plot plot = {.title = fmt::format("distance from the parabola after {} s (m)", significant(time, 3))};
  const double left = c.dt.back() / 2;
  const double right = 1.2 * c.dt.front();
  plot.x = {.title = "Δt (s)", .scale = AxisScale::logarithmic, .min = left, .max = right};
  plot.y = {.title = "", .scale = AxisScale::logarithmic};
  plot.y.min = gravity * left * time / 2;
  plot.y.max = gravity * right * time / 2;
  Series formula = {.name = "g Δt t/2", .style = page.theme().exact, .markers = false};
  formula.x = {left, right};
  formula.y = {*plot.y.min, *plot.y.max};
  plot.series.push_back(formula);
  plot.series.push_back(measured("explicit", page.theme().jacobi, c.dt, c.explicit_euler));
  plot.series.push_back(measured("semi-implicit", page.theme().si, c.dt, c.semi_implicit));
  draw_plot(page, rect, plot);
}

TableView convergence_table(const Convergence& c) {
  TableView table = {.header = {"Δt (s)", "below (m)", "ratio"}};
  for (int i = 0; i < c.dt.size(); ++i) {
    const std::string ratio = i == 0 ? "" : fixed(c.semi_implicit[i - 1] / c.semi_implicit[i], 2);
    table.rows.push_back({significant(c.dt[i], 3), fixed(-c.semi_implicit[i], 5), ratio});
  }
  return table;
}

Equation error_equation(const Flight& flight) {
  return {.number = "g Δt²/2, t/Δt times",
          .symbols = "error = g Δt t / 2",
          .numbers = fmt::format("= {} × {} × {} / 2", significant(flight.thrown.gravity),
                                 significant(flight.thrown.dt), significant(flight.time.back())),
          .result = fmt::format("= {} m",
                                fixed(flight.thrown.gravity * flight.thrown.dt * flight.time.back() / 2, 3))};
}

Shot convergence_shot(const SharedStory& story) {
  Shot shot;
  shot.key = true;
  shot.state = "half the step, half the error";
  shot.alt =
      "The error at the end of the flight over the time step, on logarithmic axes: measured points on a line "
      "of slope 1, from the standard step to a sixteenth of it.";
  shot.draw = [story](Page& page) {
    const List<Rect> parts = columns(page.area(), {56, 44}, page.sizes().gap);
    draw_convergence(page, parts[0], *story);
    const TableView table = convergence_table(story->convergence);
    const List<Rect> below = rows(parts[1], {27, 43, 30}, page.sizes().gap);
    page.note(below[0], "order one",
              "Half the step, half the error: each step misses by g Δt²/2, and all t/Δt add up.");
    page.table(below[1], "", table);
    page.equation(below[2], error_equation(story->flight));
  };
  return shot;
}

}  // namespace

List<Shot> pictures(const Flight& flight, const Convergence& convergence, const std::string& question) {
  auto made = std::make_shared<Story>(Story{flight, convergence, question, 0});
  for (const Snapshot& snapshot : flight.cairn) {
    made->fastest = std::max(made->fastest, snapshot.bodies[{1}].velocity.head<2>().norm());
  }
  const SharedStory story = made;
  List<Shot> shots;
  shots.push_back(question_shot(story));
  shots.push_back(state_shot(story));
  for (int step = 1; step <= flight.thrown.steps; ++step) shots.push_back(step_shot(story, step));
  shots.push_back(convergence_shot(story));
  shots.push_back(answer_shot(story));
  return shots;
}

}  // namespace cairn::one_body
