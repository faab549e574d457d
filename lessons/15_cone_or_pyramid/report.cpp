// Lesson 15. What is printed, and what is checked.
#include "lesson.hpp"

namespace cairn::top_view {

namespace {

constexpr double epsilon = 2.3e-16;

void print_first_step(Lesson& lesson, const Slides& all) {
  const SlideSettings& settings = all.settings;
  const Vec2<double> wanted = stopping_lambda(settings, settings.velocity);
  const Vec2<double> parts = parts_clamped(settings, wanted);
  const Vec2<double> vector = vector_clamped(settings, wanted);
  lesson.print("The first step: two rows, j = (1, 0, 0) and (0, 1, 0), both with j M⁻¹ jᵀ = 1/m");
  for (int i = 0; i < 2; ++i) {
    const ConstraintRow<double>& row = all.first.rows[i];
    lesson.print(fmt::format("  (22)  λ_{} = (0 − {:g}) / ({:g} × {:g}) = {:>8} N   clamped to ±{:g}: {} N",
                             i == 0 ? "x" : "y", row_velocity(all.first, row),
                             inverse_effective_mass(all.first, row), settings.dt, fixed(wanted[i] + 0.0, 2),
                             settings.limit(), fixed(parts[i] + 0.0, 2)));
  }
  lesson.print(fmt::format("  parts clamped    λ = {} N, {:.2f} N long: {:.1f} % of μ λ_n",
                           pair_text(parts, 2), parts.norm(), 100 * parts.norm() / settings.limit()));
  lesson.print(fmt::format("  vector clamped   λ = {} × {:g} / {:g} = {} N, against v", pair_text(wanted, 0),
                           settings.limit(), wanted.norm(), pair_text(vector, 2)));
  lesson.print();
}

void print_ends(Lesson& lesson, const Slides& all) {
  lesson.print("limit                  stops at (m)      from its start   direction of the stop");
  for (const Slide* slide : {&all.circle, &all.aligned, &all.square}) {
    const Vec2<double> place = slide->steps.back().place;
    const char* name = "circle";
    if (slide->shape == FrictionShape::aligned_square) name = "square, axis along v";
    if (slide->shape == FrictionShape::square) name = "square, axes x and y";
    lesson.print(fmt::format("  {:<20} {:>14} {:>15.3f} m {:>20.2f}°", name, pair_text(place, 3),
                             place.norm(), std::atan2(place.y(), place.x()) * 180 / pi));
  }
  const Vec2<double> v = all.settings.velocity;
  const Vec2<double> rails = v.cwiseProduct(v.cwiseAbs()) / (2 * all.settings.slowing());
  lesson.print(fmt::format("without steps: circle v²/2μg = {:.2f} m; square {} m, {:.2f} m from its start",
                           all.settings.distance(), pair_text(rails, 2), rails.norm()));
  lesson.print();
  lesson.print("direction   circle (m)   square (m)   ratio   √(cos⁴ + sin⁴)   direction of the stop");
  for (const Direction& direction : all.directions) {
    if (direction.degrees > 90) break;
    const double c = std::cos(direction.degrees * pi / 180);
    const double s = std::sin(direction.degrees * pi / 180);
    lesson.print(fmt::format("  {:>5.0f}°   {:>11.4f} {:>12.4f} {:>8.4f} {:>13.4f} {:>20.2f}°",
                             direction.degrees, direction.circle.norm(), direction.square.norm(),
                             direction.square.norm() / direction.circle.norm(),
                             std::sqrt(c * c * c * c + s * s * s * s),
                             std::atan2(direction.square.y(), direction.square.x()) * 180 / pi));
  }
  lesson.print();
}

void check_limits(Lesson& lesson, const Slides& all) {
  const SlideSettings& settings = all.settings;
  const Vec2<double> wanted = stopping_lambda(settings, settings.velocity);
  lesson.check_equal("square: length of λ in the first step, by its two clamps (N)",
                     all.square.steps[1].lambda.norm(), parts_clamped(settings, wanted).norm(),
                     8 * epsilon * settings.limit());
  double gap = 0;
  double beyond = 0;
  for (int k = 1; k < all.circle.steps.size(); ++k) {
    const Vec2<double> by_hand =
        vector_clamped(settings, stopping_lambda(settings, all.circle.steps[k - 1].velocity));
    gap = std::max(gap, (all.circle.steps[k].lambda - by_hand).norm());
    beyond = std::max(beyond, all.circle.steps[k].lambda.norm() - settings.limit());
  }
  // A velocity is rounded by epsilon of the speed, and λ has it times m / Δt.
  const double rounding = 16 * epsilon * puck_mass * settings.speed() / settings.dt;
  lesson.check_small("circle: λ is the vector clamped by hand, in every step (N)", gap, rounding);
  lesson.check_small("circle: λ beyond μ λ_n, in any step (N)", beyond, 8 * epsilon * settings.limit());
}

/// Each step rounds the velocity, and the place keeps all of it: n times epsilon of the distance, some few
/// times.
double rounding_of_places(const Slides& all) {
  return 32 * epsilon * all.circle.steps.size() * all.settings.distance();
}

/// The loop of lesson.cpp against the library's rows.
void check_by_hand(Lesson& lesson, const Slides& all) {
  double gap = 0;
  for (int k = 0; k < all.circle.steps.size(); ++k) {
    gap = std::max({gap, (all.circle.steps[k].place - all.circle_by_hand[k]).norm(),
                    (all.square.steps[k].place - all.square_by_hand[k]).norm()});
  }
  lesson.check_small("circle, square: the loop of lesson.cpp, against the library (m)", gap,
                     rounding_of_places(all));
}

void check_directions(Lesson& lesson, const Slides& all) {
  const SlideSettings& settings = all.settings;
  double bend = 0, length = 0, by_axes = 0, aligned = 0;
  for (const Direction& direction : all.directions) {
    const Vec2<double>& v = direction.velocity;
    bend = std::max(bend, std::abs(cross<double>(v / v.norm(), direction.circle)));
    length = std::max(length, std::abs(direction.circle.norm() - stopping_distance(settings, v.norm())));
    by_axes = std::max(by_axes, (direction.square - stop_on_rails(settings, v)).norm());
    aligned = std::max(aligned, (direction.aligned - direction.circle).norm());
  }
  const double rounding = rounding_of_places(all);
  lesson.check_small("circle: straight, in 24 directions (m off the line)", bend, rounding);
  lesson.check_small("circle: v²/2μg less half a step, in 24 directions (m)", length, rounding);
  lesson.check_small("square: each axis stops by itself, in 24 directions (m)", by_axes, rounding);
  lesson.check_small("square with an axis along v = circle, 24 directions (m)", aligned, rounding);
  lesson.check_small("SI and PGS: the same slide, with each limit (m)", all.solver_gap, rounding);
}

/// The closed forms, which know no steps. A step lags by v dt / 2, and what is left is between 0 and e²/4 of
/// v²/2μg on each axis, where e = μ g dt / v: so the ratio is within 0.36 e², and the angle within
/// √2/4 e² / ratio.
void check_closed_forms(Lesson& lesson, const Slides& all) {
  const SlideSettings& settings = all.settings;
  const double e = settings.slowing() * settings.dt / settings.speed();
  for (const double degrees : {45.0, 30.0}) {
    const double c = std::cos(degrees * pi / 180);
    const double s = std::sin(degrees * pi / 180);
    const double ratio = std::sqrt(c * c * c * c + s * s * s * s);
    const Direction& direction = all.directions[static_cast<int>(degrees / 15)];
    const Vec2<double> square = direction.square + 0.5 * settings.dt * direction.velocity;
    const Vec2<double> circle = direction.circle + 0.5 * settings.dt * direction.velocity;
    lesson.check_equal(fmt::format("square at {:g}°: √(cos⁴ + sin⁴) as far, lag added", degrees),
                       square.norm() / circle.norm(), ratio, 0.36 * e * e + 1e-12);
    if (degrees == 45) continue;  // straight, along the diagonal
    lesson.check_equal(fmt::format("square at {:g}°: ends at atan(tan²), lag added (°)", degrees),
                       std::atan2(square.y(), square.x()) * 180 / pi, std::atan2(s * s, c * c) * 180 / pi,
                       (std::sqrt(2) / 4 * e * e / ratio + 1e-12) * 180 / pi);
  }
}

}  // namespace

std::string pair_text(const Vec2<double>& pair, int decimals) {
  // Adding 0 leaves no minus before a zero.
  return fmt::format("({}, {})", fixed(pair.x() + 0.0, decimals), fixed(pair.y() + 0.0, decimals));
}

void print_scene(Lesson& lesson, const SlideSettings& settings) {
  lesson.print(fmt::format(
      "Scene: a puck of {:g} kg on a table, seen from above; λ_n = {:g} N, μ = {:g}, so μ λ_n = {:g} N",
      puck_mass, puck_load, settings.mu, settings.limit()));
  lesson.print(fmt::format("       v = ({:g}, {:g}) m/s, {:g} m/s at {:.2f}°; Δt = {:g} s, one sweep a step",
                           settings.velocity.x(), settings.velocity.y(), settings.speed(), settings.degrees(),
                           settings.dt));
}

void print_slides(Lesson& lesson, const Slides& all) {
  lesson.print();
  print_first_step(lesson, all);
  print_ends(lesson, all);
}

void check_slides(Lesson& lesson, const Slides& all) {
  check_limits(lesson, all);
  check_by_hand(lesson, all);
  check_directions(lesson, all);
  check_closed_forms(lesson, all);
}

CsvTable steps_table(const Slides& all) {
  CsvTable table{.header = {"limit", "step", "x_metre", "y_metre", "vx_metre_per_second",
                            "vy_metre_per_second", "lambda_x_newton", "lambda_y_newton"}};
  for (const Slide* slide : {&all.circle, &all.square, &all.aligned}) {
    std::string name = "circle";
    if (slide->shape == FrictionShape::square) name = "square";
    if (slide->shape == FrictionShape::aligned_square) name = "aligned_square";
    for (int k = 0; k < slide->steps.size(); ++k) {
      const SlideStep& step = slide->steps[k];
      table.rows.push_back({name, k, step.place.x(), step.place.y(), step.velocity.x(), step.velocity.y(),
                            step.lambda.x(), step.lambda.y()});
    }
  }
  return table;
}

SlideSettings settings_of(const Lesson& lesson) {
  return {
      .dt = lesson.real("dt"), .mu = lesson.real("mu"), .velocity = {lesson.real("vx"), lesson.real("vy")}};
}

}  // namespace cairn::top_view
