// Pyramids, stacks and chains.
#include "scenes.hpp"

#include <algorithm>

#include <cairn/samples/samples.hpp>
#include <cairn/validation/case_scenes.hpp>

namespace cairn::bench {

namespace {

using namespace cairn::cases;

/// What the world would hand to its solver after a few steps.
VelocityProblem<double> problem_of(const Scene& scene) {
  World<double> world(scene);
  SequentialImpulse<double> solver;
  for (int step = 0; step < 3; ++step) world.step(solver);
  return world.velocity_problem();
}

}  // namespace

VelocityProblem<double> pyramid_problem(int base) {
  Scene scene;
  add_pyramid(scene, base);
  return problem_of(scene);
}

VelocityProblem<double> pyramid_with_chains_problem(int base) {
  Scene scene;
  add_pyramid(scene, base);
  const int links = 10;  // of one chain: 20 rows
  const int chains = base * base / 50;
  for (int i = 0; i < chains; ++i) add_chain(scene, links, {0.6 * base + 5 + 0.3 * i, base + 10.0});
  return problem_of(scene);
}

VelocityProblem<double> stack_problem(int boxes) { return problem_of(samples::stack(boxes)); }

VelocityProblem<double> chain_problem(int links) {
  Scene scene;
  add_chain(scene, links, {0, 0});
  return problem_of(scene);
}

VelocityProblem<double> cold(VelocityProblem<double> problem) {
  std::fill(problem.impulse.begin(), problem.impulse.end(), 0.0);
  return problem;
}

std::size_t problem_memory(const VelocityProblem<double>& problem) {
  return problem.rows.bytes() + problem.blocks.bytes() + problem.inverse_mass.bytes() +
         problem.velocity.bytes() + problem.impulse.bytes();
}

}  // namespace cairn::bench
