// What the default setting is chosen by: exact solves beside sweeps in lanes, against the number of bodies.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/scenes/default_setting.hpp>
#include <cairn/scenes/scene_file.hpp>
#include <cairn/study/trial.hpp>
#include "table.hpp"
#include "tables.hpp"

namespace cairn::bench {

namespace {

constexpr int most_for_newton = 200;  // bodies: more take seconds, and show nothing new

/// A scene file of so many bodies.
struct SizedScene {
  std::string name = {};
  std::function<std::string(int)> text = {};
};

std::string heap(int bodies) {
  const double half = 0.9 * std::sqrt(bodies);  // [m] between walls and middle
  std::string text = "[ground]\nhalf_width = 90\n";
  for (const double side : {-1.0, 1.0})
    text += fmt::format("[[body]]\ntype = \"static\"\nbox = [1, 300]\nposition = [{}, 150]\n",
                        side * (half + 0.5));
  const int columns = static_cast<int>(2 * half / 1.15);
  const auto pile = [&](const char* shape, int count, double height) {
    return fmt::format(
        "[[pile]]\nname = \"{0}\"\n{0} = {1}\nn = {2}\ncolumns = {3}\nfirst = [{4}, {5}]\n"
        "step = [1.15, 2.3]\njitter = 0.04\n",
        shape, shape == std::string("box") ? "[0.8, 0.8]" : "0.4", count, columns, 0.6 - half, height);
  };
  return text + pile("circle", bodies / 2, 0.6) + pile("box", bodies - bodies / 2, 1.75);
}

std::string chute(int bodies) {
  return fmt::format(
      "[[body]]\ntype = \"static\"\nbox = [{}, 1]\nposition = [0, 0]\nangle = -0.5\n"
      "[[row]]\nn = {}\nrows = 4\nfirst = [{}, {}]\nstep = [1, -0.5463]\nrow_step = [0.02, 1.05]\n"
      "box = [0.9, 0.9]\nangle = -0.5\nevery = 3\nother = {{ circle = 0.45 }}\nfriction = 0.3\n",
      60 + bodies, bodies / 4, -0.125 * bodies, 0.0725 * bodies + 2.2);
}

std::string struck_wall(int bodies) {
  const int wide = static_cast<int>(std::lround(std::sqrt(bodies / 1.5))), high = bodies / wide;
  return fmt::format(
      "[ground]\nhalf_width = 200\n[[row]]\nn = {0}\nrows = {1}\nfirst = [{2}, 0.5]\nstep = [2.02, 0]\n"
      "stagger = [0.5, 0]\nbox = [2, 1]\n"
      "[[body]]\ncircle = 1\ndensity = 6\nposition = [{3}, {4}]\nvelocity = [25, 0]\n",
      wide, high, -1.01 * wide, -1.01 * wide - 8, std::max(1.5, 0.6 * high));
}

std::string pyramid(int bodies) {
  const int rows = static_cast<int>(std::lround((std::sqrt(8.0 * bodies + 1) - 1) / 2));
  return fmt::format("[ground]\nhalf_width = 90\n[[pyramid]]\nn = {}\nbox = [1, 1]\n", rows);
}

std::string level_chain(int bodies) {
  return fmt::format("[[chain]]\nn = {0}\nfrom = [0, 0]\nto = [{0}, 0]\nb = \"ground\"\nthickness = 0.25\n",
                     bodies);
}

std::string loaded_bridge(int bodies) {
  const int planks = 4 * bodies / 5;
  return fmt::format(
      "[[chain]]\nn = {0}\nfrom = [{1}, 0]\nto = [{2}, 0]\nb = \"ground\"\nbox = [0.98, 0.25]\ndensity = 4\n"
      "[[row]]\nn = {3}\nposition = [0, 0.525]\nstep = [2.5, 0]\nbox = [0.8, 0.8]\n",
      planks, -planks / 2.0, planks / 2.0, bodies - planks);
}

/// Two digits; of less than a hundredth nothing but that.
std::string short_number(double number) { return number < 0.01 ? "0" : fmt::format("{:.2g}", number); }

/// "3.7 / 5.7 / 3.4": median and slowest step [ms], and the larger of overlap and drift [mm].
std::string outcome_cell(const SceneEntry& scene, const std::string& solver, int sweeps, int substeps) {
  Setting setting = default_setting(scene.make()).setting;
  setting.solver = solver;
  setting.sweeps.iterations = sweeps;
  setting.substeps = substeps;
  List<double> times;  // [ms]
  double before = 0;
  TrialOptions options{.seconds = 4, .penetration_every = 3};
  options.gives_up = [&](const TrialResult& so_far) {
    times.push_back(1e3 * (so_far.step_seconds - before));
    before = so_far.step_seconds;
    return false;
  };
  const TrialResult result = run_trial(scene.make(), setting, options);
  if (result.status != TrialStatus::ok) return status_text(result.status);
  std::sort(times.begin(), times.end());
  return fmt::format("{} / {} / {:>3}", short_number(times[times.size() / 2]), short_number(times.back()),
                     short_number(1e3 * std::max(result.worst_penetration, result.worst_drift)));
}

}  // namespace

void print_default_table() {
  print_heading("12. The default: exact solves beside sweeps in lanes, against the number of bodies");
  fmt::print(
      "Four seconds at 60 Hz, in four substeps but for the last column: the median step / the slowest, in ms "
      "of "
      "processor\ntime / the larger of overlap and drift, in mm, 0 below 0.01. Freedoms: three a body, less "
      "the rows "
      "of joints.\n\n");
  TextTable table({{"scene", ""},
                   {"bodies", ""},
                   {"freedoms", ""},
                   {"newton x20", "ms / ms / mm"},
                   {"wide x10", "ms / ms / mm"},
                   {"wide x20", "ms / ms / mm"},
                   {"wide x40", "ms / ms / mm"},
                   {"x40, one substep", "ms / ms / mm"}});
  const List<SizedScene> scenes = {{"heap, poured", heap},        {"boxes on a chute", chute},
                                   {"wall, struck", struck_wall}, {"pyramid at rest", pyramid},
                                   {"level chain", level_chain},  {"loaded bridge", loaded_bridge}};
  for (const SizedScene& scene : scenes) {
    for (const int bodies : {52, 160, 640}) {
      const SceneEntry entry = read_scene_text(scene.text(bodies), scene.name);
      const std::string reason = default_setting(entry.make()).reason;
      table.add({scene.name, std::to_string(bodies), reason.substr(0, reason.find(' ')),
                 bodies > most_for_newton ? "" : outcome_cell(entry, "newton", 20, 4),
                 outcome_cell(entry, "wide", 10, 4), outcome_cell(entry, "wide", 20, 4),
                 outcome_cell(entry, "wide", 40, 4), outcome_cell(entry, "wide", 40, 1)});
    }
  }
  fmt::print("{}\n", table.text());
}

}  // namespace cairn::bench
