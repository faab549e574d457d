// Floor 8. A scene and all that it takes to step it.
#pragma once

#include <memory>
#include <string>

#include <cairn/scenes/default_setting.hpp>
#include <cairn/world/world.hpp>

namespace cairn {

/// A world with the solver that steps it:
///   Simulation simulation(scene);
///   while (simulation.world().clock().time < 10) simulation.step();
/// Whoever wants to choose makes a World and a Solver.
class Simulation {
 public:
  /// By default_setting(). @throws std::invalid_argument as World.
  explicit Simulation(const Scene& scene);

  /// @throws as World::step().
  StepReport step() { return world_.step(*solver_); }
  /// To look at, and to change between steps.
  World<double>& world() { return world_; }
  /// To look at.
  const World<double>& world() const { return world_; }
  /// What was chosen, and why.
  const DefaultSetting& chosen() const { return chosen_; }

 private:
  DefaultSetting chosen_;
  World<double> world_;
  std::unique_ptr<Solver<double>> solver_;
};

}  // namespace cairn
