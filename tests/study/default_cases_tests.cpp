// The default setting, held against scenes whose right ends are known: each says in its [expect] what a user
// would call right, and none says how it is to be stepped.
#include <doctest/doctest.h>

#include <filesystem>
#include <set>
#include <string>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/solvers/exact/newton_solver.hpp>
#include <cairn/scenes/scene_file.hpp>
#include <cairn/scenes/simulation.hpp>
#include <cairn/study/judgement.hpp>
#include <cairn/validation/case_scenes.hpp>

using namespace cairn;

namespace {

std::set<std::string> case_files() {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(CAIRN_SOURCE_DIR "/tests/study/cases"))
    files.insert(entry.path().string());
  return files;
}

/// So many boxes of 1 m, each 0.05 m in the one below.
Scene sunken_boxes(int count) {
  Scene scene;
  scene.add_ground();
  for (int i = 0; i < count; ++i) scene.add({.shapes = {box(1, 1)}, .position = {0, 0.45 + 0.95 * i}});
  return scene;
}

/// A pyramid and a ball that falls on its middle: its own mirror image.
Scene mirrored_scene() {
  Scene scene;
  cases::add_pyramid(scene, 4);
  scene.add({.shapes = {circle(0.3)}, .position = {0, 7}});
  return scene;
}

}  // namespace

TEST_CASE("under the default, scenes with a known end come to it") {
  const std::set<std::string> files = case_files();
  CHECK(files.size() > 30);
  for (const std::string& file : files) {
    const SceneEntry scene = read_scene_file(file);
    CAPTURE(scene.name);
    TrialOptions options = trial_options(scene);
    options.seconds = scene.seconds;
    const TrialResult result = run_trial(scene.make(), scene.setting, options);
    for (const std::string& missed : judge(result, wish_of(scene)).missed()) FAIL_CHECK(missed);
    for (const Failure& failure : result.failures) FAIL_CHECK(failure_text(failure));
  }
}

TEST_CASE("what begins in each other parts slowly: the push that takes overlap out stays in no velocity") {
  for (const int count : {1, 5}) {
    Simulation simulation(sunken_boxes(count));
    double fastest = 0;
    for (int step = 0; step < 120; ++step) {
      simulation.step();
      for (const Vec3<double>& v : simulation.world().bodies().velocity)
        fastest = std::max(fastest, v.template head<2>().norm());
    }
    CHECK(fastest < 0.2);
  }
}

TEST_CASE("a scene that is its own mirror image stays so for ten seconds") {
  Simulation simulation(mirrored_scene());
  while (simulation.world().clock().time < 10) simulation.step();
  double sum = 0;  // [m] of all x: 0 in a mirror image
  for (const Pose<double>& pose : simulation.world().bodies().pose) sum += pose.position.x();
  CHECK(std::abs(sum) < 1e-3);
  for (const Pose<double>& pose : simulation.world().bodies().pose) {
    double nearest = 1e3;
    for (const Pose<double>& other : simulation.world().bodies().pose) {
      const Vec2<double> mirrored(-other.position.x(), other.position.y());
      nearest = std::min(nearest, (pose.position - mirrored).norm());
    }
    CHECK(nearest < 1e-3);
  }
}

TEST_CASE("the default is chosen by freedoms: exact where there are few, in lanes where there are many") {
  const DefaultSetting few = default_setting(sunken_boxes(100)), many = default_setting(sunken_boxes(101));
  CHECK(few.setting.solver == "newton");
  CHECK(few.reason == "300 freedoms: all rows are solved at once up to 300");
  CHECK(many.setting.solver == "wide");
  CHECK(few.setting.substeps == 4);
  // A rod takes a freedom away, and a scene that asks for more substeps gets them.
  Scene scene = sunken_boxes(101);
  for (int i = 1; i <= 3; ++i)
    scene.join<DistanceJoint>({.a = {i}, .b = {i + 1}, .anchor_a = {0, i - 1.0}, .anchor_b = {0, i + 0.0}});
  SceneSettings settings = scene.settings();
  settings.substeps = 8;
  scene.set_settings(settings);
  CHECK(default_setting(scene).setting.solver == "newton");
  CHECK(default_setting(scene).setting.substeps == 8);
}

TEST_CASE("a simulation takes the steps of a world and a solver under the default") {
  const Scene scene = sunken_boxes(3);
  Simulation simulation(scene);
  const Setting& setting = simulation.chosen().setting;
  Scene same = scene;
  same.set_settings(with_setting(scene.settings(), setting));
  World<double> world(same);
  NewtonSolver<double> solver(setting.sweeps);
  for (int step = 0; step < 30; ++step) {
    simulation.step();
    world.step(solver);
  }
  CHECK(simulation.world().bodies().velocity == world.bodies().velocity);
}
