// Pyramids, stacks and chains.
#include "scenes.hpp"

#include <algorithm>
#include <cmath>

namespace cairn::bench {

namespace {

const double link_length = 0.5;  // [m]

void add_pyramid(Scene& scene, int base) {
  scene.add_ground({.half_width = 0.6 * base + 10});
  for (int level = 0; level < base; ++level) {
    for (int i = 0; i < base - level; ++i) {
      const double x = 1.1 * (i + 0.5 * (level - base + 1));  // the middle of the lowest row at 0
      scene.add({.shapes = {box(1, 1)}, .position = {x, 0.5 + level}});
    }
  }
}

/// Hangs from the ground at (x, top), each rod below the one before, and swings from an angle at which none
/// of its numbers vanishes.
void add_chain(Scene& scene, int links, double x, double top) {
  const double angle = 0.5;  // [rad] from the vertical
  const Vec2<double> down(std::sin(angle), -std::cos(angle));
  BodyId above = ground;
  for (int i = 0; i < links; ++i) {
    const Vec2<double> anchor = Vec2<double>(x, top) + i * link_length * down;
    const BodyId link = scene.add(
        {.shapes = {box(0.1, link_length)}, .position = anchor + link_length / 2 * down, .angle = angle});
    scene.join<RevoluteJoint>({.a = above, .b = link, .anchor = anchor});
    above = link;
  }
}

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
  for (int i = 0; i < chains; ++i) add_chain(scene, links, 0.6 * base + 5 + 0.3 * i, base + 10.0);
  return problem_of(scene);
}

VelocityProblem<double> stack_problem(int boxes) {
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < boxes; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0, 0.5 + i}});
  return problem_of(scene);
}

VelocityProblem<double> chain_problem(int links) {
  Scene scene;
  add_chain(scene, links, 0, 0);
  return problem_of(scene);
}

VelocityProblem<double> cold(VelocityProblem<double> problem) {
  std::fill(problem.impulse.begin(), problem.impulse.end(), 0.0);
  return problem;
}

std::size_t problem_memory(const VelocityProblem<double>& problem) {
  return bytes_of(problem.rows) + bytes_of(problem.blocks) + bytes_of(problem.inverse_mass) +
         bytes_of(problem.velocity) + bytes_of(problem.impulse);
}

}  // namespace cairn::bench
