// Coulomb friction that sweeps never find, in a world.
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

// A20
TEST_CASE("a step of a world says that the rod's contact went in circles") {
  for (const double mu : {1.2, 1.45}) {
    const double angle = std::atan(2.0), thickness = 1e-6;
    Scene scene({.dt = 0.001});
    scene.add_ground({.material = {.friction = mu}});
    const double height = (std::sin(angle) + thickness * std::cos(angle)) / 2;
    scene.add({.shapes = {box(1, thickness)},
               .position = {0, height},
               .angle = -angle,
               .velocity = {-1, 0},
               .mass = 1,
               .material = {.friction = mu}});
    for (const SolverMaker<double>& make : all_solvers<double>()) {
      World world(scene);
      const auto solver = make({.iterations = 5000, .patience = 3});
      const StepReport report = world.step(*solver);
      CHECK(report.solve.stop != Stop::sweeps);
      if (mu < 4.0 / 3) {  // it has come to rest, but for a circle of roundings
        CHECK(report.solve.largest_change <= 64 * double_epsilon);
      } else {
        CHECK(report.solve.stop == Stop::cycle);
        // g dt / A_nn, of the normal impulse alone.
        CHECK(report.solve.largest_change >= 0.01 / 1.6);
      }
    }
  }
}
