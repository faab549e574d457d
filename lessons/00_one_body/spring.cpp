// Lesson 00. The box on a spring: the two lines in either order, and what that makes of its swing.
#include <cmath>
#include <numbers>

#include "lesson.hpp"

namespace cairn::one_body {

namespace {

constexpr double frequency = 2;                             // [1/s]
constexpr double omega = 2 * std::numbers::pi * frequency;  // [rad/s]

/// A box on a spring, moved by hand: x [m] and v [m/s].
struct Swinging {
  double x = 1;
  double v = 0;
};

void note(Swing& swing, const Swinging& box) {
  swing.x.push_back(box.x);
  swing.v.push_back(box.v);
}

Series series_of(const Swing& swing, const std::string& name, const SeriesStyle& style, double dt) {
  Series series{.name = name, .style = style};
  for (int k = 0; k < swing.x.size(); ++k) series.add(k * dt, swing.x[k]);
  return series;
}

/// v/4π against x, over the first steps [m].
List<Vec2<double>> loop_of(const Swing& swing, int steps) {
  List<Vec2<double>> points;
  for (int k = 0; k <= std::min(steps, swing.x.size() - 1); ++k)
    points.push_back({swing.x[k], swing.v[k] / omega});
  return points;
}

SeriesStyle exact_style(const Page& page) { return {.color = page.theme().exact.color}; }

/// Two axes with one scale, so that a circle is one, as far as `most`; `tick` is marked on each side.
Camera draw_axes(Page& page, const Rect& rect, const std::string& title, double most, double tick) {
  const Camera camera = fit(page.panel(rect, title), {{-most, -most}, {most, most}});
  const Stroke thin{.width = page.sizes().axis, .color = page.theme().secondary_text};
  const TextStyle right = page.tick(), left = aligned(right, Align::right);
  for (const Vec2<double>& axis : {Vec2<double>(1, 0), Vec2<double>(0, 1)}) {
    page.canvas().line(camera.project(-most * axis), camera.project(most * axis), thin);
    for (const double at : {-tick, tick}) {
      const Point mark = camera.project(at * axis), across(5 * axis.y(), 5 * axis.x());
      page.canvas().line(mark - across, mark + across, thin);
      const bool is_right = axis.x() * at > 0;
      const Point aside(is_right ? 8 : -8, axis.y() * at > 0 ? -8 : 18);
      page.canvas().text(mark + aside, fixed(at, 0), is_right ? right : left);
    }
  }
  page.canvas().text(camera.project({most, 0}) + Point(8, 6), "x (m)", page.label());
  page.canvas().text(camera.project({0, most}) + Point(10, 14), "v / 4π (m)", page.label());
  return camera;
}

/// The spring from the wall to the box.
void draw_coil(Page& page, const Camera& camera, double from, double to) {
  List<Point> points = {camera.project({from, 0}), camera.project({from + 0.15, 0})};
  const int turns = 12;
  const double pitch = (to - from - 0.3) / turns;
  for (int i = 0; i < turns; ++i)
    points.push_back(camera.project({from + 0.15 + pitch * (i + 0.5), i % 2 == 0 ? 0.16 : -0.16}));
  points.push_back(camera.project({to - 0.15, 0}));
  points.push_back(camera.project({to, 0}));
  page.canvas().polyline(points, {.width = page.sizes().curve, .color = page.theme().text});
}

/// How large the swing is after two seconds is asked; a scale would tell.
void draw_asked(Page& page, const Rect& rect) {
  const Rect inside = page.panel(rect, "after 2 s: how large is the swing?");
  const double y = inside.y + 0.6 * inside.height, middle = inside.x + 0.5 * inside.width;
  const Stroke thin{.width = page.sizes().axis, .color = page.theme().text};
  const TextStyle guess{.size = 26, .color = page.theme().velocity, .bold = true, .align = Align::center};
  for (const double side : {-1, 1}) {
    const Point end(middle + side * 0.47 * inside.width, y);
    draw_length(page, {middle, y}, end, thin);
    page.canvas().text({middle + side * 0.24 * inside.width, y - 10}, "? m", guess);
  }
}

/// The three kinds of line, with their names.
void draw_names(Page& page, Point at) {
  for (const auto& [name, style] :
       {std::pair{"position first", explicit_style(page)},
        std::pair{"velocity first", semi_implicit_style(page)}, std::pair{"exact", exact_style(page)}}) {
    page.canvas().line(at, at + Point(44, 0),
                       {.width = page.sizes().curve, .color = style.color, .dash = style.dash});
    draw_marker(page.canvas(), at + Point(22, 0), style.marker, page.sizes().marker, style.color);
    page.canvas().text(at + Point(54, 6), name, page.label());
    at += Point(0, 30);
  }
}

}  // namespace

Springs swing(double dt) {
  Springs springs{.dt = dt};
  const int steps = static_cast<int>(std::lround(swing_seconds / dt));
  Swinging old_first, new_first;
  note(springs.explicit_euler, old_first);
  note(springs.semi_implicit, new_first);
  for (int step = 0; step < steps; ++step) {
    // [spring]
    const double pull = -omega * omega * old_first.x;  // [m/s^2]
    old_first.x += old_first.v * dt;                   // first the position, with the old velocity
    old_first.v += pull * dt;

    new_first.v += -omega * omega * new_first.x * dt;  // first the velocity
    new_first.x += new_first.v * dt;
    // [/spring]
    note(springs.explicit_euler, old_first);
    note(springs.semi_implicit, new_first);
  }
  return springs;
}

double swing_at(const Swing& swing, int step) { return std::hypot(swing.x[step], swing.v[step] / omega); }

double swing_at_end(const Swing& swing) { return swing_at(swing, swing.x.size() - 1); }

void tell_springs(Lesson& lesson, const Springs& springs) {
  lesson.print("on a spring: twice a second, from x = 1 m at rest");
  lesson.print("    t (s)   position first (m)   its swing (m)   velocity first (m)   exact (m)");
  const int steps = springs.semi_implicit.x.size() - 1;
  for (int quarter = 0; quarter <= 4; ++quarter) {
    const int k = quarter * steps / 4;
    lesson.print(
        fmt::format("{:>9} {:>20} {:>15} {:>20} {:>11}", fixed(k * springs.dt, 2),
                    fixed(springs.explicit_euler.x[k], 3), fixed(swing_at(springs.explicit_euler, k), 3),
                    fixed(springs.semi_implicit.x[k], 3), fixed(std::cos(omega * k * springs.dt), 3)));
  }
}

void check_springs(Lesson& lesson, const Springs& springs) {
  const double h = omega * springs.dt;
  const int steps = springs.semi_implicit.x.size() - 1;
  const double grown = std::pow(1 + h * h, steps / 2.0);
  // Each step rounds four sums and products.
  lesson.check_equal("position first: each step multiplies the swing by √(1 + (4π Δt)²); at the end (m)",
                     swing_at_end(springs.explicit_euler), grown, 4 * steps * epsilon * grown);
  double worst = 0, largest = 1;
  for (int k = 0; k <= steps; ++k) {
    const double x = springs.semi_implicit.x[k], u = springs.semi_implicit.v[k] / omega;
    worst = std::max(worst, std::abs(x * x + u * u - h * x * u - 1));
    largest = std::max(largest, x * x + u * u);
  }
  lesson.check_small("velocity first: x² + u² − 4π Δt x u stays 1, with u = v/4π (m²)", worst,
                     16 * steps * epsilon * largest);
}

void draw_spring_question(Page& page, const Rect& rect) {
  const List<Rect> parts = in_rows(page, rect, {0.74, 0.26});
  draw_asked(page, parts[1]);
  const Camera camera = fit(parts[0], {{-3.4, -0.8}, {2.2, 1.4}});
  Scene scene({.gravity = {0, 0}});
  scene.add({.shapes = {box(1, 1)}, .position = {1, 0}, .mass = 1});
  draw_coil(page, camera, -3, 0.5);
  const Stroke wall{.width = 2 * page.sizes().outline, .color = page.theme().text};
  page.canvas().line(camera.project({-3, -0.7}), camera.project({-3, 0.7}), wall);
  page.canvas().line(camera.project({-3, -0.52}), camera.project({2.1, -0.52}),
                     {.width = page.sizes().axis, .color = page.theme().secondary_text});
  draw_world(page, camera, snapshot(World<double>(std::move(scene))), {.names = {"", "1 kg"}});
  const Stroke thin{.width = page.sizes().axis, .color = page.theme().text};
  const TextStyle text = aligned(page.value(), Align::center);
  const Point up(0, -0.9 * camera.scale);
  const Point left = camera.project({-1, 0}), middle = camera.project({0, 0}), right = camera.project({1, 0});
  for (const auto& [from, to] : {std::pair{left, middle}, std::pair{middle, right}}) {
    draw_length(page, from + up, to + up, thin);
    page.canvas().text(0.5 * (from + to) + up - Point(0, 8), "1 m", text);
  }
}

void draw_swings(Page& page, const Rect& rect, const Springs& springs) {
  const double most = 1.1 * swing_at_end(springs.explicit_euler);
  Plot plot{.title = "where the box is on its spring (m)"};
  plot.x = {.title = "t (s)", .min = 0, .max = swing_seconds};
  plot.y = {.min = -most, .max = most};
  const SeriesStyle thin{.color = page.theme().secondary_text, .dash = {6, 5}};
  Series above{.name = significant(swing_at_end(springs.explicit_euler), 3) + " m", .style = thin};
  Series below{.style = thin};
  const double factor = std::hypot(1, omega * springs.dt);
  for (int k = 0; k < springs.explicit_euler.x.size(); ++k) {
    above.add(k * springs.dt, std::pow(factor, k));
    below.add(k * springs.dt, -above.y.back());
  }
  plot.series = {series_of(springs.explicit_euler, "position first", explicit_style(page), springs.dt),
                 series_of(springs.semi_implicit, "velocity first", semi_implicit_style(page), springs.dt),
                 above, below};
  draw_plot(page, rect, plot);
}

void draw_loops(Page& page, const Springs& springs) {
  const List<Rect> parts = in_columns(page, {0.56, {0.44, {0.66, 0.34}}});
  const int turn = static_cast<int>(std::lround(1 / frequency / springs.dt));
  const int steps = springs.semi_implicit.x.size() - 1;
  List<Vec2<double>> circle;
  for (int i = 0; i <= 96; ++i)
    circle.push_back({std::cos(i * std::numbers::pi / 48), std::sin(i * std::numbers::pi / 48)});
  const auto draw = [&](const Camera& camera, int last) {
    draw_trail(page, camera, circle, exact_style(page));
    draw_trail(page, camera, loop_of(springs.semi_implicit, last), semi_implicit_style(page));
    draw_trail(page, camera, loop_of(springs.explicit_euler, last), explicit_style(page));
  };
  const double first = 1.1 * swing_at(springs.explicit_euler, std::min(turn, steps));
  const Camera camera = draw_axes(page, parts[0], "the first swing", first, 1);
  draw(camera, turn);
  draw_names(page, camera.project({0.42 * first, -0.68 * first}));
  const double all = swing_at_end(springs.explicit_euler);
  draw(draw_axes(page, parts[1], "all of two seconds", 1.15 * all, render::round_ticks(0, all, 2).back()),
       steps);
  const double h = omega * springs.dt;
  page.equation(parts[2], {.number = "position first, one step",
                           .symbols = "√(1 + (4π Δt)²)",
                           .numbers = fmt::format("= √(1 + {}²)", fixed(h, 4)),
                           .result = fmt::format("= {}", fixed(std::sqrt(1 + h * h), 4)),
                           .algorithm = fmt::format("in {} steps: {} times", steps,
                                                    fixed(swing_at_end(springs.explicit_euler), 1))});
}

}  // namespace cairn::one_body
