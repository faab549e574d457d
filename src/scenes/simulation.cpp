// Floor 8. A scene under its default.
#include <cairn/scenes/simulation.hpp>

#include <cairn/scenes/solver_list.hpp>

namespace cairn {

namespace {

Scene with_settings(Scene scene, const Setting& setting) {
  scene.set_settings(with_setting(scene.settings(), setting));
  return scene;
}

}  // namespace

Simulation::Simulation(const Scene& scene)
    : chosen_(default_setting(scene)),
      world_(with_settings(scene, chosen_.setting)),
      solver_(make_solver<double>(chosen_.setting.solver, chosen_.setting.sweeps)) {}

}  // namespace cairn
