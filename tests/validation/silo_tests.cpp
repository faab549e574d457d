// A silo: walls that rub carry most of what stands between them (H. A. Janssen, 1895).
#include <doctest/doctest.h>

#include <cmath>

#include "../geometry/random_shapes.hpp"
#include "geometry/shape.hpp"
#include "solvers/sequential_impulse.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

const double silo_gravity = 10;  // [m/s^2]
const double silo_width = 5;     // [m] between the walls
const double silo_friction = 0.5;

struct SiloLoad {
  double height = 0;  // [m] of the filling, were it spread evenly
  double weight = 0;  // [N] of all discs
  double floor = 0;   // [N] that the floor carries
};

/// Discs of 0.8 to 1 m settle between two walls; then the floor sinks slowly, so that they rub on the walls
/// everywhere.
SiloLoad settle(int rows, double wall_friction, std::uint64_t seed) {
  Scene scene({.gravity = {0, -silo_gravity}, .dt = 1.0 / 120});
  const double tall = 1.1 * rows + 5;
  const BodyId floor = scene.add({.type = BodyType::kinematic,
                                  .shapes = {box(silo_width - 0.02, 1)},
                                  .position = {0, -0.5},
                                  .friction = 0});
  for (const double side : {-1.0, 1.0}) {
    scene.add({.type = BodyType::static_body,
               .shapes = {box(2, tall)},
               .position = {side * (silo_width / 2 + 1), tall / 2 - 2},
               .friction = wall_friction * wall_friction / silo_friction});  // mixed: the square root of both
  }
  test::Random random(seed);
  SiloLoad load;
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i < 4; ++i) {
      const double radius = random.uniform(0.4, 0.5);
      const double x = -silo_width / 2 + 0.6 + 1.25 * i + random.uniform(-0.05, 0.05);
      scene.add({.shapes = {circle(radius)}, .position = {x, 0.6 + 1.05 * row}, .friction = silo_friction});
      load.weight += std::acos(-1.0) * radius * radius * silo_gravity;
    }
  }
  load.height = load.weight / silo_gravity / silo_width;
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = 40});
  for (int step = 0; step < 360; ++step) world.step(solver);
  world.set_velocity(floor, {0, -0.1, 0});
  for (int step = 0; step < 240; ++step) {
    world.step(solver);
    if (step < 120) continue;  // the mean of a second
    for (const SnapshotContact& contact : snapshot(world).contacts) {
      if (contact.a == floor || contact.b == floor) load.floor += contact.normal_impulse / world.dt() / 120;
    }
  }
  return load;
}

/// Janssen: the floor carries w W / (2 mu K) (1 - e^(-2 mu K H / W)) of the weight w per length.
double janssen_floor(const SiloLoad& load, double k) {
  const double depth = 2 * silo_friction * k / silo_width;
  return load.weight * (1 - std::exp(-depth * load.height)) / (depth * load.height);
}

double fitted_k(const SiloLoad& load) {
  double low = 1e-6, high = 20;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (janssen_floor(load, middle) > load.floor ? low : high) = middle;
  }
  return low;
}

SiloLoad mean_load(int rows) {
  const int fillings = 4;
  SiloLoad mean;
  for (int seed = 1; seed <= fillings; ++seed) {
    const SiloLoad load = settle(rows, silo_friction, static_cast<std::uint64_t>(seed));
    mean.height += load.height / fillings;
    mean.weight += load.weight / fillings;
    mean.floor += load.floor / fillings;
  }
  return mean;
}

}  // namespace

TEST_CASE("between smooth walls the floor carries all that stands on it") {
  const SiloLoad smooth = settle(12, 0, 1);
  // The mean of a second: what is missing is the change of momentum, of speeds about the floor's 0.1 m/s.
  CHECK(std::abs(smooth.floor - smooth.weight) <= 0.1 / silo_gravity * smooth.weight);
}

TEST_CASE("between rough walls the floor's load saturates as Janssen says") {
  const SiloLoad low = mean_load(12);
  const SiloLoad high = mean_load(24);
  // K is the ratio of stress on the wall to stress along it: for grains between 0.3 and 1.2. Fillings differ,
  // and a quarter is what theory leaves open.
  const double k = fitted_k(high);
  CHECK(k >= 0.3);
  CHECK(k <= 1.2);
  CHECK(std::abs(low.floor - janssen_floor(low, k)) <= 0.25 * janssen_floor(low, k));
  // Twice the filling is far from twice the load.
  CHECK(high.weight > 1.9 * low.weight);
  CHECK(high.floor < 1.75 * low.floor);
}
