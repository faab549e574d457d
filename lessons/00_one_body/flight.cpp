// Lesson 00. One box in free flight: as Cairn steps it, by explicit Euler, and exactly.
#include "lesson.hpp"

namespace cairn::one_body {

Vec2<double> parabola(const Throw& thrown, double t) {
  return {thrown.start.x() + thrown.velocity.x() * t,
          thrown.start.y() + thrown.velocity.y() * t - thrown.gravity * t * t / 2};
}

void record(Flight& flight, const World<double>& world, const Particle& semi_implicit,
            const Particle& explicit_euler) {
  const double t = flight.time.size() * flight.thrown.dt;
  const Vec2<double> position = world.bodies().pose[{1}].position;
  flight.time.push_back(t);
  flight.cairn.push_back(snapshot(world));
  flight.semi_implicit.push_back(position);
  flight.explicit_euler.push_back(explicit_euler.position);
  flight.exact.push_back(parabola(flight.thrown, t));
  flight.gap = std::max(flight.gap, (position - semi_implicit.position).norm());
}

double final_error(const Flight& flight, const List<Vec2<double>>& path) {
  return path.back().y() - flight.exact.back().y();
}

double rounding_of_height(const Flight& flight) {
  // Every step rounds a height and a velocity, each by half an epsilon of its largest value; what a velocity
  // has lost is missing in every later step. So n steps lose at most n epsilon(y) / 2 and n^2 dt epsilon(v)
  // / 4. Twice that.
  const Throw& thrown = flight.thrown;
  const double n = thrown.steps;
  double height = std::abs(thrown.start.y());
  for (const Vec2<double>& point : flight.exact) height = std::max(height, std::abs(point.y()));
  const double speed = std::abs(thrown.velocity.y()) + thrown.gravity * flight.time.back();
  return n * epsilon * height + n * n * thrown.dt * epsilon * speed / 2;
}

}  // namespace cairn::one_body
