// Floor 9. The scenes of the frozen problems, and how long they run.
#include <cairn/study/frozen/frozen_set.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include <cairn/math/check.hpp>
#include <cairn/solvers/iterative/sequential_impulse.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/case_scenes.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

struct FrozenRun {
  int steps = 0;
  int sweeps = 10;  // in each of them
};

/// The next problem of a scene after a run of sequential impulses, of steps as the paper has them: Baumgarte,
/// and nothing looks after a solve.
FrozenProblem frozen_after(Scene scene, const FrozenRun& run, const std::string& what) {
  SceneSettings settings = scene.settings();
  settings.stabilization.policy = StabilizationPolicy::baumgarte;
  scene.set_settings(settings);
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = run.sweeps});
  for (int step = 0; step < run.steps; ++step) world.step(solver);
  if (run.steps == 0) return freeze(world, "", what + ". The first step.");
  return freeze(
      world, "",
      fmt::format("{}. After {} steps of {} sweeps of sequential impulses.", what, run.steps, run.sweeps));
}

FrozenProblem freeze_ratio100() {
  return frozen_after(box_column({1, 100}), {.steps = 60, .sweeps = 100}, "A box of 100 kg on a box of 1 kg");
}

FrozenProblem freeze_stack10() {
  return frozen_after(box_column(List<double>(10, 1.0)), {.steps = 60, .sweeps = 40},
                      "Ten equal boxes, one on the other");
}

FrozenProblem freeze_stack10_offset() {
  return frozen_after(box_column(List<double>(10, 1.0), 0.1), {.steps = 60, .sweeps = 40},
                      "Ten equal boxes, one on the other, each 0.2 m beside the last");
}

FrozenProblem freeze_stack5_100() {
  return frozen_after(box_column({1, 1, 1, 1, 100}), {.steps = 60, .sweeps = 200},
                      "A box of 100 kg on four boxes of 1 kg");
}

FrozenProblem freeze_weld10() {
  return frozen_after(welded_beam(10), {}, "Ten boxes in a row, welded to each other and to a wall");
}

FrozenProblem freeze_chain20x100() {
  Scene scene;
  const double radius = 0.25;  // [m]
  const ChainEnd end = add_chain(scene, 19, {0, 0});
  const double link_mass = scene.bodies().back().mass;
  const BodyId bob = scene.add(
      {.shapes = {circle(radius)}, .position = end.place - Vec2<double>(0, radius), .mass = 100 * link_mass});
  scene.join<RevoluteJoint>({.a = end.last, .b = bob, .anchor = end.place});
  return frozen_after(scene, {.steps = 30, .sweeps = 100},
                      "A swinging chain of nineteen rods with a bob of a hundred times their mass");
}

FrozenProblem freeze_pyramid10() {
  Scene scene;
  add_pyramid(scene, 10);
  return frozen_after(scene, {.steps = 60, .sweeps = 20}, "A pyramid of 55 boxes, ten in the lowest row");
}

FrozenProblem freeze_arch21() {
  return frozen_after(masonry_arch({}), {.steps = 30, .sweeps = 200},
                      "An arch of 21 stones, as thin as one that stands can almost be");
}

FrozenProblem freeze_silo60() {
  const Silo silo = silo_before_settling({});
  return frozen_after(silo.scene, {.steps = 360, .sweeps = 40}, "Sixty discs that have settled in a silo");
}

/// At mu = A_nn / A_nt = 4/3: from there on sweeps go round the answer in a circle of two.
FrozenProblem freeze_painleve() {
  return {.description =
              "A rod that drags its lower end over the floor with the friction 4/3, from which on "
              "sweeps of Gauss-Seidel do not converge. Written by hand.",
          .tags = {"cold", "2 rows", "moving"},
          .problem = painleve_rod<double>(-1, 4.0 / 3)};
}

/// Where a pin of the bridge is: on a parabola, for a straight bridge could bear nothing.
Vec2<double> bridge_pin(int i, int planks) {
  const double part = static_cast<double>(i) / planks;
  return {i, -4 * part * (1 - part)};
}

FrozenProblem freeze_bridge() {
  const int planks = 12;
  Scene scene;
  BodyId last = ground;
  for (int i = 0; i < planks; ++i) {
    const Vec2<double> from = bridge_pin(i, planks), along = bridge_pin(i + 1, planks) - from;
    const BodyId plank = scene.add({.shapes = {box(along.norm(), 0.2)},
                                    .position = from + along / 2,
                                    .angle = arc_tangent(along.y(), along.x()),
                                    .density = 5});
    scene.join<RevoluteJoint>({.a = last, .b = plank, .anchor = from});
    last = plank;
  }
  scene.join<RevoluteJoint>({.a = last, .b = ground, .anchor = bridge_pin(planks, planks)});
  const std::function<double(double, double)> uniform = uniform_numbers(2);
  for (int i = 1; i <= 5; ++i) {
    const double width = uniform(0.4, 0.9), height = uniform(0.4, 0.9), density = uniform(0.5, 4);
    const Vec2<double> place = bridge_pin(2 * i, planks) + Vec2<double>(0, 0.2 + height / 2);
    scene.add({.shapes = {box(width, height)}, .position = place, .density = density});
  }
  return frozen_after(scene, {.steps = 240, .sweeps = 100},
                      "A bridge of twelve planks on pins that bears five boxes of random size and density");
}

struct FrozenEntry {
  std::string name = {};
  FrozenProblem (*make)() = nullptr;
};

const List<FrozenEntry>& frozen_entries() {
  static const List<FrozenEntry> entries = {{"ratio100", freeze_ratio100},
                                            {"stack10", freeze_stack10},
                                            {"stack10_offset", freeze_stack10_offset},
                                            {"stack5_100", freeze_stack5_100},
                                            {"weld10", freeze_weld10},
                                            {"chain20x100", freeze_chain20x100},
                                            {"pyramid10", freeze_pyramid10},
                                            {"arch21", freeze_arch21},
                                            {"silo60", freeze_silo60},
                                            {"painleve_rod", freeze_painleve},
                                            {"bridge", freeze_bridge}};
  return entries;
}

std::string motion_tag(const World<double>& world) {
  if (world.clock().steps == 0) return "start";
  double fastest = 0;  // [m/s or rad/s]
  for (const Vec3<double>& v : world.bodies().velocity) fastest = std::max(fastest, v.cwiseAbs().maxCoeff());
  return fastest <= 0.05 ? "settled" : "moving";
}

std::filesystem::path frozen_path(const std::filesystem::path& folder, const std::string& name) {
  return folder / (name + ".json");
}

}  // namespace

FrozenProblem freeze(const World<double>& world, const std::string& name, const std::string& description) {
  FrozenProblem frozen{.name = name, .description = description, .problem = world.velocity_problem()};
  const PerRow<double>& impulse = frozen.problem.impulse;
  const bool is_cold = std::all_of(impulse.begin(), impulse.end(), [](double p) { return p == 0; });
  frozen.tags = {is_cold ? "cold" : "warm", fmt::format("{} rows", impulse.size()), motion_tag(world)};
  return frozen;
}

const List<std::string>& frozen_names() {
  static const List<std::string> names = [] {
    List<std::string> all;
    for (const FrozenEntry& entry : frozen_entries()) all.push_back(entry.name);
    return all;
  }();
  return names;
}

FrozenProblem make_frozen(const std::string& name) {
  for (const FrozenEntry& entry : frozen_entries()) {
    if (entry.name != name) continue;
    FrozenProblem frozen = entry.make();
    frozen.name = name;
    return frozen;
  }
  require(false, "make_frozen", "name", fmt::format("one of {}", fmt::join(frozen_names(), ", ")), name);
  return {};
}

void write_frozen_set(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot make " + folder.string() + ": " + error.message());
  for (const std::string& name : frozen_names()) {
    write_frozen_file(frozen_path(folder, name), make_frozen(name));
  }
}

List<FrozenProblem> read_frozen_set(const std::filesystem::path& folder) {
  List<FrozenProblem> all;
  for (const std::string& name : frozen_names()) all.push_back(read_frozen_file(frozen_path(folder, name)));
  return all;
}

}  // namespace cairn
