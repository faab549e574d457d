// cairn_fingerprints: prints the fingerprint of every scene after some steps, in float and double. Built for
// this machine and for browsers, it must print the same.
#include <cstdio>
#include <exception>

#include <cairn/measure/fingerprint.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/scenes/solver_list.hpp>
#include <cairn/world/world.hpp>

namespace {

using namespace cairn;

const int steps = 60;

/// Of all states after each step.
template <typename Real>
std::uint64_t fingerprint_of_run(const SceneEntry& entry, const std::string& solver_name) {
  Scene scene = entry.make();
  scene.set_settings(with_setting(scene.settings(), entry.setting));
  World<Real> world(std::move(scene));
  const std::unique_ptr<Solver<Real>> solver = make_solver<Real>(solver_name, entry.setting.sweeps);
  Fingerprint all;
  for (int step = 0; step < steps; ++step) {
    world.step(*solver);
    all.add(hexadecimal(fingerprint_of(snapshot(world))));
  }
  return all.value();
}

void print_runs(const std::string& solver) {
  for (const SceneEntry& entry : scene_entries()) {
    const std::string& name = solver.empty() ? entry.setting.solver : solver;
    std::printf("%s %s float %s\n", entry.name.c_str(), name.c_str(),
                hexadecimal(fingerprint_of_run<float>(entry, name)).c_str());
    std::printf("%s %s double %s\n", entry.name.c_str(), name.c_str(),
                hexadecimal(fingerprint_of_run<double>(entry, name)).c_str());
  }
}

}  // namespace

/// Arguments: solvers to use in place of the scenes' own.
int main(int count, char** words) {
  try {
    if (count == 1) print_runs("");
    for (int i = 1; i < count; ++i) print_runs(words[i]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "cairn_fingerprints: %s\n", error.what());
    return 1;
  }
}
