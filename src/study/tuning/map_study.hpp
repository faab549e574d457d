// Floor 9. The map of settings: which one is cheapest for which error, over scenes and families of scenes;
// and one setting for many scenes.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/measure/csv.hpp>
#include <cairn/scenes/setting.hpp>
#include <cairn/study/journal.hpp>
#include <cairn/study/trajectory_study.hpp>

namespace cairn {

/// A scene of the map. Members of a family differ in one number.
struct MapScene {
  std::string family = {};  // "" for a scene that comes with Cairn
  double value = 0;         // of the family's number
  TrajectoryScene scene = {};
};

/// What the members of a family differ in.
struct MapFamily {
  std::string name = {};   // "mass ratio"
  std::string title = {};  // what they are: "five boxes of 1 m, the top one heavier"
  std::string axis = {};   // the number, with its unit
};

/// Mass ratios of a stack and of a chain, heights of a stack and of a pyramid, lengths of a chain.
const List<MapFamily>& map_families();
/// The members of all families, then every scene of trajectory_names().
/// @throws std::invalid_argument for a scene file that cannot be read.
List<MapScene> map_scenes();

/// In the order in which pictures and tables name them.
inline const List<std::string> map_solvers = {"si", "accelerated", "block", "newton", "jacobi-split"};

/// 1472: si, accelerated, newton, block, jacobi-split; 30 to 240 Hz; 1 and 4 substeps; 1, 3, 10, 30, 100
/// sweeps (newton 1, 3, 10 systems); relaxed, soft, split impulse, Baumgarte; double and float. Lanes
/// are not among them: they change the time of a row update and not the number of them.
List<Setting> map_settings();

/// Errors above this are not told apart: a run is given up there. Metres of overlap and of joints' gaps, or
/// parts of what a formula says.
inline constexpr double largest_map_error = 0.1;
/// Of the scene's energy scale: a run that gains more, though nothing drives it, is no good.
inline constexpr double largest_map_gain = 0.01;
/// [1/s] of counted_work(), beyond which a setting is not followed: some 50 ms for a second of the scene.
inline constexpr double most_map_work = 3e6;

/// Row updates of sequential impulses that take as long as these `updates` of the solver and all else that
/// steps do for `rows` rows: as much as ten sweeps over them. A sweep is weighed by `price`, or by
/// SolverEntry::work_of_a_sweep, as in expected_work().
double counted_work(const std::string& solver, double updates, double rows,
                    std::optional<double> price = std::nullopt);

/// The columns of the table, without the task.
const List<std::string>& map_header();
/// One task for each scene and setting, whose row says how the run ended, what was counted for each second of
/// the scene, and its error. A run takes at most two seconds (that of a formula: to its end). Where the scene
/// should stand it starts a micrometre off. It is given up where it falls, gains energy, comes to an error
/// beyond the largest, or needs more than most_map_work.
Study map_study(const List<MapScene>& scenes, const List<Setting>& settings);

/// A run of the map: see map_study().
struct MapRow {
  std::string scene = {};
  std::string family = {};  // "" for a scene that comes with Cairn
  double value = 0;         // of the family's number
  std::string solver = {};
  int frequency = 60;  // [Hz]
  int substeps = 1;
  int sweeps = 1;
  std::string policy = {};
  std::string scalar = {};
  std::string status = {};
  double rows = 0;     // [1/s] of all substeps
  double updates = 0;  // [1/s] of these rows
  double work = 0;     // [1/s] counted_work()
  double error = 0;    // [m], or part of what a formula says; infinite where there is no number

  bool meets(double goal) const { return status == "ok" && error <= goal; }
  /// "si x10, 60 Hz x4, soft, double".
  std::string setting() const;
};

/// The runs of each scene, with the settings in the same order.
struct MapTable {
  List<List<MapRow>> scenes = {};

  int settings() const { return scenes.empty() ? 0 : scenes.front().size(); }
};

/// The table that map_study() writes. @throws std::invalid_argument for one of another kind, with its name.
MapTable read_map(const CsvTable& table, const std::string& name);

/// The same runs, where a sweep of the solver has another price.
MapTable priced(MapTable table, const std::string& solver, double price);

/// The one with the least work that meets the goal, the first of several; nullptr if none does.
const MapRow* cheapest(const List<MapRow>& runs, double goal,
                       const std::function<bool(const MapRow&)>& among = {});

/// How a setting does in many scenes.
struct MapChoice {
  int setting = -1;     // its place among those of a scene; -1: there are none
  int met = 0;          // scenes that it brings to the goal
  double multiple = 1;  // of the least work of any setting, geometric mean over those
};
/// The setting of the solver that brings most of these scenes to the goal; of several the one with the least
/// multiple.
MapChoice best_for_all(const MapTable& table, const List<int>& scenes, double goal,
                       const std::string& solver);

}  // namespace cairn
