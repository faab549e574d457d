// Overlap that Baumgarte stabilization turns into speed: bodies that overlap at rest jump.
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

struct PopSpec {
  double overlap = 0.1;    // [m] d, at rest
  double baumgarte = 0.2;  // beta
  double slop = 0;         // [m]
  double frequency = 240;  // [1/s] steps
};

/// A disc of radius 0.5 m, or a box as high as that, in the ground by d.
World<double> sunk_body(const PopSpec& spec, const Shape<double>& shape) {
  Scene scene({.dt = 1 / spec.frequency,
               .stabilization = {.policy = StabilizationPolicy::baumgarte,
                                 .baumgarte = spec.baumgarte,
                                 .slop = spec.slop,
                                 .max_speed = std::numeric_limits<double>::infinity()}});
  scene.add_ground();
  scene.add({.shapes = {shape}, .position = {0, 0.5 - spec.overlap}, .mass = 3});
  return World(scene);
}

double height_above_rest(const World<double>& world) { return pose_of(world, {1}).position.y() - 0.5; }

}  // namespace

// B24
TEST_CASE("a body that overlaps the ground by d leaves it with beta d / dt, whatever it weighs") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double beta : {0.1, 0.2, 0.8}) {
      for (const double slop : {0.0, 0.005}) {
        for (const Shape<double>& shape : {Shape<double>(circle(0.5)), Shape<double>(box(1, 1))}) {
          World world = sunk_body({.baumgarte = beta, .slop = slop}, shape);
          const auto solver = make({.iterations = 60});
          world.step(*solver);
          const double speed = beta * (0.1 - slop) * 240;
          CHECK(velocity_of(world, {1}).y() == doctest::Approx(speed).epsilon(1e-9));
          // What is left of the overlap asks for less than it has: it flies, and gravity brakes it.
          world.step(*solver);
          CHECK(velocity_of(world, {1}).y() == doctest::Approx(speed - test_gravity / 240).epsilon(1e-9));
        }
      }
    }
  }
}

// B24
TEST_CASE("without stabilization, or within the slop, a body stays where it overlaps") {
  for (const PopSpec& spec : {PopSpec{.baumgarte = 0}, PopSpec{.overlap = 0.005, .slop = 0.005}}) {
    World world = sunk_body(spec, box(1, 1));
    SequentialImpulse<double> solver({.iterations = 60});
    for (int step = 0; step < 240; ++step) {
      world.step(solver);
      // 240 steps round heights below 1 m, and the two points of a box are solved to rounding by 60 sweeps.
      CHECK(std::abs(height_above_rest(world) + spec.overlap) <= 1e-12);
    }
  }
}

// B24
TEST_CASE("an overlap below g dt^2 / beta^2 creeps out by beta a step, and does not fly off") {
  const double beta = 0.2, frequency = 60;
  const double limit = test_gravity / (frequency * frequency * beta * beta);  // 0.069 m
  // The next step asks for beta (1 - beta) d / dt; the body has beta d / dt - g dt.
  for (const double share : {0.5, 0.99, 1.01, 1.5}) {
    const double d = share * limit;
    World world = sunk_body({.overlap = d, .frequency = frequency}, circle(0.5));
    SequentialImpulse<double> solver;
    run(world, solver, 2 / frequency);
    const double creeping = -d * (1 - beta) * (1 - beta);
    const double flying = -d * (1 - beta) + beta * d - test_gravity / (frequency * frequency);
    CHECK(height_above_rest(world) == doctest::Approx(share < 1 ? creeping : flying).epsilon(1e-9));
  }
}
