// Floor 9. Level 2 of the trade: whole runs, with formulas where there are any, and Box2D beside.
#pragma once

#include <string>

#include <cairn/study/answered_scenes.hpp>
#include <cairn/study/journal.hpp>
#include <cairn/study/setting_grid.hpp>
#include <cairn/study/judgement.hpp>
#include <cairn/study/trial.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// A scene that runs under every setting of a grid.
struct TrajectoryScene {
  std::string name = {};
  std::function<Scene()> make = {};
  double seconds = 2;
  double stand_distance = 0;  // [m] 0: nothing is said about standing
  /// What is asked of a run. Where it says where bodies should end, stand_distance is the nearest that one
  /// must come.
  Wish wish = {};
  /// What a formula says of the run, where it does: see AnsweredScene.
  std::string error_name = {};
  std::string error_formula = {};
  std::function<std::unique_ptr<MotionError>()> watch = {};
  std::uint64_t fingerprint = 0;  // of its file, where it has one: another text is another study
  bool beside_exact = true;       // its second is run exactly, too, and held against that
  int starts = 1;                 // at most; above 1: jittered by 1e-6 m, with seeds 1, 2 ...
};

/// Scenes of answered_scenes(), of scene_entries() and of scene files. The last two start up to 16 times
/// where they should stand.
/// @throws std::invalid_argument for a name that neither has, with the nearest that one has.
TrajectoryScene trajectory_scene(const std::string& name);
/// The names of all of them.
List<std::string> trajectory_names();
/// How it runs: overlap is measured thirty times a second, however short the steps, as that costs as much as
/// finding contacts.
TrialOptions trial_options(const TrajectoryScene& scene, const Setting& setting);

/// Solvers, frequencies, substeps and sweeps that runs are compared over, unless others are asked for.
SettingGrid trajectory_grid();

/// Row updates for each second simulated beyond which a setting is not followed, counted with ten sweeps more
/// for every substep: what that costs beside its sweeps. At some 15 ns each it is about half of real time.
inline constexpr double most_trajectory_work = 3e7;

/// One task for each point of the grid in each scene: runs from its starts. Of errors and of the shares of
/// what is asked the worst and the median, of costs the median, and the shares of starts that stood and that
/// failed, as the judgement of a run says it (study/judgement.hpp). Failures stay in the table, with their
/// status. A run ends where it falls ("fell"), and a setting is done with at the first tenth of a run that
/// comes to more than most_trajectory_work ("timeout"): its other numbers are of what was run. Where three
/// starts all failed, or came to the same places within a hundredth of stand_distance, a millionth of a metre
/// does not decide, and no further one is run. The column `starts` says how many there were.
Study trajectory_study(const List<TrajectoryScene>& scenes, const SettingGrid& grid);

}  // namespace cairn
