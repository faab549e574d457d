// Bounces, with and without a contact that is foreseen.
#include <cairn/math/list.hpp>
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

struct BallSpec {
  double restitution = 1;
  double height = 1;      // [m] of its lowest point
  double frequency = 60;  // [1/s] steps
  double margin = 0.02;   // [m] speculative
};

const double ball_radius = 0.25;  // [m]

World<double> dropped_ball(const BallSpec& spec) {
  Scene scene({.dt = 1 / spec.frequency, .speculative_margin = spec.margin, .restitution_threshold = 0});
  scene.add_ground();
  scene.add({.shapes = {circle(ball_radius)},
             .position = {0, spec.height + ball_radius},
             .mass = 1,
             .material = {.restitution = spec.restitution}});
  return World(scene);
}

double height_of_ball(const World<double>& world) {
  return world.bodies().pose[{1}].position.y() - ball_radius;
}
double speed_of_ball(const World<double>& world) { return world.bodies().velocity[{1}].y(); }

/// The highest points after each of the first `count` bounces [m].
List<double> apexes(const BallSpec& spec, int count) {
  World world = dropped_ball(spec);
  SequentialImpulse<double> solver;
  List<double> result;
  double before = 0;
  while (result.size() < count && world.clock().time < 60) {
    world.step(solver);
    if (speed_of_ball(world) < 0 && before > 0) result.push_back(height_of_ball(world));
    before = speed_of_ball(world);
  }
  return result;
}

}  // namespace

// A contact that is foreseen must not brake the ball before it bounces.
TEST_CASE("a ball bounces as high with a wide speculative margin as without one") {
  for (const double e : {0.8, 1.0}) {
    for (const double frequency : {60.0, 240.0}) {
      const double tolerance = std::sqrt(2 * test_gravity) / frequency * (1 + e);
      const double without = apexes({.restitution = e, .frequency = frequency, .margin = 0}, 1).at(0);
      for (const double margin : {0.02, 0.1, 0.5}) {
        const double with = apexes({.restitution = e, .frequency = frequency, .margin = margin}, 1).at(0);
        CHECK(std::abs(with - without) <= tolerance);
      }
    }
  }
}
