// In which order colours are gone through, by what it does to a pile.
#include <doctest/doctest.h>

#include "solvers/iterative/sequential_impulse.hpp"
#include "solvers/wide/wide_sequential_impulse.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

/// Boxes of 1 m, a layer of so many on the ground.
Scene pyramid(int layers) {
  Scene scene;
  scene.add_ground({.friction = 0.6});
  for (int layer = 0; layer < layers; ++layer) {
    for (int i = 0; i < layers - layer; ++i)
      scene.add({.shapes = {box(1, 1)}, .position = {i + 0.5 * layer, 0.5 + layer}, .friction = 0.6});
  }
  return scene;
}

/// [m] How far the top is from its place after 4 s.
double top_moves(Solver<double>& solver) {
  World<double> world(pyramid(30));
  const BodyId top = {world.bodies().pose.size() - 1};
  const Vec2<double> place = world.bodies().pose[top].position;
  for (int step = 0; step < 240; ++step) world.step(solver);
  return (world.bodies().pose[top].position - place).norm();
}

}  // namespace

TEST_CASE("few sweeps in lanes hold a pile as well as those that visit row after row") {
  SequentialImpulse<double> one_by_one({.iterations = 10});
  WideSequentialImpulse<double> in_lanes({.iterations = 10});
  const double expected = top_moves(one_by_one);
  CHECK(expected < 0.05);
  CHECK(top_moves(in_lanes) < 1.5 * expected);  // 1.2; 60 with the fewest colours
}
