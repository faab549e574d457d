// Lesson 00. One box in free flight: as Cairn steps it, by explicit Euler, and exactly.
#include "flight.hpp"

#include <algorithm>
#include <limits>

#include "cairn.hpp"

namespace cairn::one_body {

namespace {

// Nothing but the box: no ground to hit, so that all we see is the integrator.
World<double> thrown_box(const Throw& thrown) {
  Scene scene({.gravity = {0, -thrown.gravity}, .dt = thrown.dt});
  scene.add({.shapes = {box(1, 1)},
             .position = thrown.start,
             .velocity = thrown.velocity.head<2>(),
             .angular_velocity = thrown.velocity.z(),
             .mass = 1});
  return World(std::move(scene));
}

//> explicit_euler
// The other order: the position takes the old velocity, and only then does the velocity change.
std::vector<Vec2<double>> explicit_euler(const Throw& thrown) {
  const Vec2<double> gravity(0, -thrown.gravity);
  Vec2<double> position = thrown.start;
  Vec2<double> velocity = thrown.velocity.head<2>();
  std::vector<Vec2<double>> path = {position};
  for (int step = 0; step < thrown.steps; ++step) {
    position += thrown.dt * velocity;
    velocity += thrown.dt * gravity;
    path.push_back(position);
  }
  return path;
}
//< explicit_euler

}  // namespace

Vec2<double> parabola(const Throw& thrown, double t) {
  return {thrown.start.x() + thrown.velocity.x() * t,
          thrown.start.y() + thrown.velocity.y() * t - thrown.gravity * t * t / 2};
}

Flight fly(const Throw& thrown) {
  Flight flight;
  flight.thrown = thrown;
  World<double> world = thrown_box(thrown);
  flight.inverse_mass = world.bodies().inverse_mass[1];
  SequentialImpulse<double> solver;  // has no rows to solve here
  for (int step = 0; step <= thrown.steps; ++step) {
    if (step > 0) world.step(solver);
    const double t = step * thrown.dt;
    flight.time.push_back(t);
    flight.cairn.push_back(snapshot(world));
    flight.semi_implicit.push_back(world.bodies().pose[1].position);
    flight.exact.push_back(parabola(thrown, t));
  }
  flight.explicit_euler = explicit_euler(thrown);
  return flight;
}

double final_error(const Flight& flight, const std::vector<Vec2<double>>& path) {
  return path.back().y() - flight.exact.back().y();
}

double rounding_of_height(const Flight& flight) {
  // Every step rounds a height and a velocity, each by half an ulp of its largest value; what a velocity has
  // lost is missing in every later step. So n steps lose at most n ulp(y) / 2 and n^2 dt ulp(v) / 4. Twice
  // that.
  const Throw& thrown = flight.thrown;
  const double n = thrown.steps;
  double height = std::abs(thrown.start.y());
  for (const Vec2<double>& point : flight.exact) height = std::max(height, std::abs(point.y()));
  const double speed = std::abs(thrown.velocity.y()) + thrown.gravity * flight.time.back();
  const double ulp = std::numeric_limits<double>::epsilon();
  return n * ulp * height + n * n * thrown.dt * ulp * speed / 2;
}

}  // namespace cairn::one_body
