// How much larger impulses become than what there is to stop: what most_leverage is chosen by.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenes/scene_list.hpp"
#include "scenes/solver_list.hpp"
#include "solvers/impulse_energy.hpp"
#include "world/world.hpp"

using namespace cairn;

namespace {

/// The largest impulse of a step, beside impulse_there_is() where it began. Rows that push by themselves are
/// no leverage: they only make the second larger.
double leverage_of_step(World<double>& world, Solver<double>& solver) {
  VelocityProblem<double> before = world.velocity_problem();
  world.step(solver);
  const VelocityProblem<double>& after = world.last_step().problem;
  if (after.row_count() != before.row_count()) return 0;  // of the last substep of several
  before.impulse = after.impulse;
  const double there_is = impulse_there_is(before);
  double largest = 0;
  for (int i = 0; i < after.rows.size(); ++i) {
    const Bounds<double>& bounds = after.rows[i].bounds;
    const bool is_passive = after.rows[i].softness == 0 && !std::isfinite(bounds.upper);
    if (is_passive) largest = std::max(largest, std::abs(after.impulse[i]));
  }
  return there_is > 0 ? largest / there_is : 0;
}

}  // namespace

TEST_CASE("no scene that comes with Cairn has a tenth of the leverage that a guarded step allows") {
  std::string table;
  double worst = 0;
  for (const SceneEntry& entry : scene_entries()) {
    Scene scene = entry.make();
    scene.set_settings(with_setting(scene.settings(), entry.setting));
    World<double> world(scene);
    const auto solver = make_solver<double>(entry.setting.solver, entry.setting.sweeps);
    double largest = 0;
    for (int step = 0; step < 60; ++step) largest = std::max(largest, leverage_of_step(world, *solver));
    table += fmt::format("  {:<16}{:8.3f}\n", entry.name, largest);
    worst = std::max(worst, largest);
  }
  MESSAGE("the largest impulse of 60 steps, beside all that there was to stop or to move\n", table);
  CHECK(worst < most_leverage / 10);
  CHECK(worst > 1);  // levers there are
}

TEST_CASE("the moment of a beam that is held at one end has half its length as leverage") {
  const double length = 20;  // [m]
  VelocityProblem<double> problem;
  problem.velocity = {{0, 0, 0}, {0, -1, 0}};
  problem.inverse_mass = {{0, 0, 0}, {1, 1, 12 / (length * length)}};
  problem.impulse = {1, length / 2};  // what stops it in y and in its angle, from a pin at its end
  problem.rows.push_back({.a = ground, .b = {1}, .jacobian_b = {0, 1, -length / 2}});
  problem.rows.push_back({.a = ground, .b = {1}, .jacobian_b = {0, 0, 1}});
  apply_impulses(problem);
  CHECK(problem.velocity[{1}].norm() < 1e-15);
  problem.velocity[{1}] = {0, -1, 0};
  CHECK(problem.impulse[1] / impulse_there_is(problem) == doctest::Approx(length / 2).epsilon(1e-15));
}
