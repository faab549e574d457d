// Lesson 15. Cone or pyramid: clamp the vector, not its parts.
//
// Seen from above friction has two axes, and a row for each. Coulomb limits the length of the vector of both;
// a solver that visits one row at a time limits each part. Below, a puck slides under both limits in a loop
// of six lines; then the library's own rows do the same, in two solvers and in all directions.
#include "lesson.hpp"

namespace cairn::top_view {

Vec2<double> stopping_lambda(const SlideSettings& settings, const Vec2<double>& velocity) {
  return -puck_mass / settings.dt * velocity;  // (22) for both rows: j M^-1 j^T = 1/m
}

// [clamps]
Vec2<double> parts_clamped(const SlideSettings& settings, const Vec2<double>& lambda) {
  const double limit = settings.limit();
  return {std::clamp(lambda.x(), -limit, limit), std::clamp(lambda.y(), -limit, limit)};
}

Vec2<double> vector_clamped(const SlideSettings& settings, const Vec2<double>& lambda) {
  const double length = lambda.norm();
  if (length <= settings.limit()) return lambda;
  return settings.limit() / length * lambda;
}
// [/clamps]

List<Vec2<double>> slide_by_hand(const SlideSettings& settings, Limit clamped) {
  const double dt = settings.dt;
  Vec2<double> place = {0, 0};
  Vec2<double> velocity = settings.velocity;
  List<Vec2<double>> places = {place};
  // [slide]
  for (int step = 0; step < step_count(settings); ++step) {
    const Vec2<double> wanted = stopping_lambda(settings, velocity);  // stops the puck within the step
    const Vec2<double> lambda = clamped(settings, wanted);            // its parts, or its length
    velocity += lambda * dt / puck_mass;
    place += velocity * dt;
    places.push_back(place);
  }
  // [/slide]
  return places;
}

Scene puck_on_table(const SlideSettings& settings, FrictionShape shape) {
  Scene scene({.gravity = {0, 0}, .dt = settings.dt});  // gravity points into the table
  const BodyId puck = scene.add({.shapes = {circle(settings.puck_radius())},
                                 .velocity = settings.velocity,
                                 .mass = puck_mass,
                                 .fixed_rotation = true});
  scene.join<FrictionJoint>({.b = puck, .max_force = settings.limit(), .shape = shape});
  return scene;
}

Slide slide_once(const SlideSettings& settings, FrictionShape shape, Method method) {
  const SolverSettings one_sweep = {.iterations = 1};  // the two rows do not disturb each other
  SequentialImpulse<double> si(one_sweep);
  ProjectedGaussSeidel<double> pgs(one_sweep);
  World<double> world(puck_on_table(settings, shape));
  Slide slide{.shape = shape, .steps = {look_from_above(world)}};
  const int steps = step_count(settings);
  for (int k = 0; k < steps; ++k) {
    if (method == Method::sequential_impulses) world.step(si);
    if (method == Method::projected_gauss_seidel) world.step(pgs);
    slide.steps.push_back(look_from_above(world));
  }
  return slide;
}

namespace {

void run(Lesson& lesson) {
  const SlideSettings settings = settings_of(lesson);
  const Slides all = run_slides(settings);
  print_scene(lesson, settings);
  lesson.predict();
  print_slides(lesson, all);
  const Vec2<double> right = all.square.steps.back().place;
  // A textbook's way of computing it leaves out half a step, by which semi-implicit Euler lags.
  const double lag = 0.5 * settings.dt * settings.speed();
  lesson.answer({right.x(), right.y()}, 0.01 + lag,
                "Each axis stops by itself, as on a rail. In its corners the square allows √2 μ λ_n: too "
                "strong, and against v only along the diagonals.");
  check_slides(lesson, all);
  lesson.film(slide_shots(all));
  lesson.data(steps_table(all));
  lesson.fingerprint(all.square.steps.back().snapshot);
}

}  // namespace
}  // namespace cairn::top_view

int main(int argc, char** argv) { return cairn::run_lesson(cairn::card(), cairn::top_view::run, argc, argv); }
