// In which order colours are gone through, by what it does to a pile.
#include <cairn/samples/samples.hpp>
#include "testing.hpp"

using namespace cairn;

namespace {

/// [m] How far the top is from its place after 4 s.
double top_moves(Solver<double>& solver) {
  World<double> world(samples::pyramid({.base = 30}));
  const BodyId top = {world.bodies().pose.size() - 1};
  const Vec2<double> place = world.bodies().pose[top].position;
  take_steps(world, solver, 240);
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
