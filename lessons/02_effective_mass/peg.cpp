// One contact, one row, one sweep.
#include "peg.hpp"

#include <cmath>

namespace cairn::felt_mass {

namespace {

constexpr double peg_radius = 0.1;  // [m]

/// The box with its underside at y = 0, upon the top of a peg at x. A peg without mass cannot be moved.
Scene peg_scene(const PegSettings& settings, double x, double peg_mass, double friction) {
  Scene scene({.gravity = {0, 0}, .dt = settings.dt});
  BodySpec peg{.type = BodyType::static_body,
               .shapes = {circle(peg_radius)},
               .position = {x, -peg_radius},
               .friction = friction};
  if (peg_mass > 0) {
    peg.type = BodyType::dynamic;
    peg.mass = peg_mass;
  }
  scene.add(peg);
  scene.add({.shapes = {box(1, 1)},
             .position = {0, 0.5},
             .velocity = {0, -settings.speed},
             .mass = settings.mass,
             .friction = friction});
  return scene;
}

Push push_at(const PegSettings& settings, double x, double peg_mass) {
  World<double> world(peg_scene(settings, x, peg_mass, 0));
  const VelocityProblem<double> problem = world.velocity_problem();
  Push push{.x = x, .row = problem.rows.at(0), .before = snapshot(world)};
  // [push]
  push.inverse_mass = problem.inverse_mass;
  push.inverse = inverse_effective_mass(problem, push.row);
  push.by_matrices = system_matrices(problem).A(0, 0);
  push.rate_before = row_velocity(problem, push.row);

  SequentialImpulse<double> solver({.iterations = 1});
  world.step(solver);
  const VelocityProblem<double>& solved = world.last_step().problem;
  push.impulse = solved.impulse.at(0);
  push.rate_after = row_velocity(solved, push.row);
  // [/push]
  push.after = push.before;
  for (std::size_t i = 0; i < push.after.bodies.size(); ++i)
    push.after.bodies[i].velocity = solved.velocity[i];
  return push;
}

}  // namespace

double inertia_of(double mass) { return mass / 6; }

double felt(double mass, const Vec2<double>& arm, const Vec2<double>& direction) {
  const double lever = cross(arm, direction);
  return 1 / (1 / mass + lever * lever / inertia_of(mass));
}

Pushes push_everywhere(const PegSettings& settings) {
  Pushes all{.settings = settings};
  for (const double x : {0.0, 0.5 * settings.x, settings.x}) all.at.push_back(push_at(settings, x, 0));
  all.mirrored = push_at(settings, -settings.x, 0);
  for (const double mass : {0.0, 60.0, 6.0, 1.0, 0.1})
    all.others.push_back({.mass = mass, .effective = 1 / push_at(settings, 0, mass).inverse});
  const VelocityProblem<double> rough = World<double>(peg_scene(settings, 0, 0, 0.5)).velocity_problem();
  all.sideways = effective_mass(rough, rough.rows.at(1));
  return all;
}

}  // namespace cairn::felt_mass
