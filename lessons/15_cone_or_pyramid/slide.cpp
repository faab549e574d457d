// The slides: three limits, two solvers, and all directions.
#include "lesson.hpp"

namespace cairn::top_view {

namespace {

double largest_gap(const Slide& one, const Slide& other) {
  double gap = 0;
  for (int k = 0; k < one.steps.size(); ++k)
    gap = std::max(gap, (one.steps[k].place - other.steps[k].place).norm());
  return gap;
}

Direction in_direction(SlideSettings settings, double degrees) {
  const double angle = degrees * pi / 180;
  settings.velocity = settings.speed() * Vec2<double>(std::cos(angle), std::sin(angle));
  const auto rest = [&](FrictionShape shape) -> Vec2<double> {
    return slide_once(settings, shape, Method::sequential_impulses).steps.back().place;
  };
  return {.degrees = degrees,
          .velocity = settings.velocity,
          .circle = rest(FrictionShape::circle),
          .square = rest(FrictionShape::square),
          .aligned = rest(FrictionShape::aligned_square)};
}

}  // namespace

SlideStep look_from_above(const World<double>& world) {
  SlideStep step{.place = world.bodies().pose[{1}].position,
                 .velocity = world.bodies().velocity[{1}].head<2>(),
                 .snapshot = snapshot(world)};
  const VelocityProblem<double>& problem = world.last_step().problem;
  for (int i = 0; i < problem.row_count(); ++i) {
    step.lambda += problem.rows[i].jacobian_b.head<2>() * (problem.impulse[i] / problem.dt);
  }
  step.snapshot.joints.clear();  // friction is drawn as an arrow
  return step;
}

int step_count(const SlideSettings& settings) {
  return static_cast<int>(std::ceil(settings.speed() / (settings.slowing() * settings.dt))) + 2;
}

Slides run_slides(const SlideSettings& settings) {
  const Method si = Method::sequential_impulses;
  const Method pgs = Method::projected_gauss_seidel;
  Slides all{.settings = settings,
             .first = World<double>(puck_on_table(settings, FrictionShape::square)).velocity_problem(),
             .circle = slide_once(settings, FrictionShape::circle, si),
             .square = slide_once(settings, FrictionShape::square, pgs),
             .aligned = slide_once(settings, FrictionShape::aligned_square, pgs),
             .circle_by_hand = slide_by_hand(settings, vector_clamped),
             .square_by_hand = slide_by_hand(settings, parts_clamped)};
  all.solver_gap =
      std::max({largest_gap(all.circle, slide_once(settings, FrictionShape::circle, pgs)),
                largest_gap(all.square, slide_once(settings, FrictionShape::square, si)),
                largest_gap(all.aligned, slide_once(settings, FrictionShape::aligned_square, si))});
  for (int degrees = 0; degrees < 360; degrees += 15)
    all.directions.push_back(in_direction(settings, degrees));
  return all;
}

double stopping_distance(const SlideSettings& settings, double speed) {
  const double loss = settings.slowing() * settings.dt;
  const double steps = std::floor(speed / loss);  // in which it moves on
  return settings.dt * (steps * speed - loss * steps * (steps + 1) / 2);
}

Vec2<double> stop_on_rails(const SlideSettings& settings, const Vec2<double>& velocity) {
  return {std::copysign(stopping_distance(settings, std::abs(velocity.x())), velocity.x()),
          std::copysign(stopping_distance(settings, std::abs(velocity.y())), velocity.y())};
}

}  // namespace cairn::top_view
