// Beside floor 6. Level 2 of the trade: whole runs, with formulas where there are any, and Box2D beside.
#pragma once

#include <string>
#include <vector>

#include "study/answered_scenes.hpp"
#include "study/journal.hpp"
#include "study/trial.hpp"

namespace cairn {

/// A scene that runs under every setting of a grid.
struct TrajectoryScene {
  std::string name = {};
  std::function<Scene()> make = {};
  double seconds = 2;
  double stand_distance = 0;  // [m] 0: nothing is said about standing
  /// What a formula says of the run, where it does: see AnsweredScene.
  std::string error_name = {};
  std::string error_formula = {};
  std::function<std::unique_ptr<MotionError>()> watch = {};
  std::uint64_t fingerprint = 0;  // of its file, where it has one: another text is another study
  int starts = 1;                 // above 1: jittered by 1e-6 m, with seeds 1, 2 ...
};

/// Scenes of answered_scenes(), of scene_entries() and of scene files. The last two start 16 times where they
/// should stand.
/// @throws std::invalid_argument for a name that neither has, with the nearest that one has.
TrajectoryScene trajectory_scene(const std::string& name);
/// The names of all of them.
std::vector<std::string> trajectory_names();

struct TrajectoryGrid {
  std::vector<std::string> solvers = {"si", "block", "accelerated", "box2d"};
  std::vector<int> frequencies = {30, 60, 120, 240, 480, 960};  // [Hz]
  std::vector<int> substeps = {1, 4, 16};
  std::vector<int> sweeps = {1, 2, 4, 8, 16, 32, 64};
  Stabilization stabilization = {};
};

/// One task for each point of the grid in each scene: runs from all starts. Median error and cost, worst
/// penetration and drift, the share of starts that stood. Failures stay in the table, with their status.
Study trajectory_study(const std::vector<TrajectoryScene>& scenes, const TrajectoryGrid& grid);

}  // namespace cairn
