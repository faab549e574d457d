// Floor 8. A contestant: a solver and all that decides how it does.
#pragma once

#include <optional>
#include <string>

#include <cairn/scenes/named.hpp>
#include <cairn/solvers/solver.hpp>
#include <cairn/world/scene.hpp>

namespace cairn {

/// A solver, how often it may sweep, and how the world steps. Box2D 2.4.1 is one more contestant, "box2d":
/// sweeps.iterations are its velocity iterations, a step is `substeps` steps of dt / substeps, it always
/// computes in single precision, and warm_start is as for the others. The rest means nothing to it.
struct Setting {
  /// That a scene file or a flag may ask for.
  static constexpr int most_sweeps = 1'000'000;

  std::string solver = "si";  // of solver_entries(), "opencl-jacobi" or "box2d"
  SolverSettings sweeps = {};
  Precision scalar = Precision::double_precision;
  double dt = 1.0 / 60;  // [s]
  int substeps = 1;
  ContactSearch contact_search = ContactSearch::every_substep;
  Stabilization stabilization = {};
  bool warm_start = true;
  int position_iterations = 3;  // of Box2D alone
};

/// "si x10, 60 Hz x4, soft, double": what differs from the defaults is said, and nothing else.
std::string setting_text(const Setting& setting);

/// "baumgarte", "soft 40 Hz": the policy, and what differs from its defaults.
std::string stabilization_text(const Stabilization& stabilization);

/// @throws std::invalid_argument for an unknown solver, with the nearest known one, for numbers that it
/// cannot work with, and by solver_refusal().
void check(const Setting& setting);

/// The scene's own settings, with all that the setting decides taken from it.
SceneSettings with_setting(SceneSettings settings, const Setting& setting);

/// Why this build and this machine lack the solver, "box2d" or "opencl-jacobi", as the rule of a message;
/// empty where they have it.
std::string solver_refusal(const Setting& setting);

/// Whether "box2d" can be asked for.
bool has_box2d();
/// All that Setting::solver may be here: the solvers, "opencl-jacobi", and "box2d" where it can be asked for.
List<std::string> contestant_names();

}  // namespace cairn
