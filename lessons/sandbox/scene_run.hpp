// One run of a scene, with what a table, a film and a time series need of it.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "lessons/kit/console.hpp"
#include "lessons/sandbox/occurrences.hpp"
#include <cairn/math/list.hpp>
#include <cairn/measure/csv.hpp>
#include <cairn/measure/tracks.hpp>
#include <cairn/measure/violation.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/study/judgement.hpp>

namespace cairn::sandbox {

/// What is to be kept of a run beside its result.
struct RunWish {
  double seconds = 2;                // [s]
  double frames_per_second = 0;      // of the snapshots that are kept, as near as steps allow; 0: none
  bool series = false;               // a row of numbers for every step
  List<std::string> tracks = {};     // quantities over time: see TrackRecorder
  std::function<bool()> stops = {};  // asked after every step
};

struct SceneRun {
  Setting setting = {};
  TrialResult result = {};
  RunJudgement judgement = {};  // of what the scene expects, in the seconds that that is for
  List<Snapshot> frames = {};   // none that is not finite; of a run that ends badly, its end too
  CsvTable series = {};         // time_s, kinetic_J, ...
  std::shared_ptr<TrackRecorder> tracks = {};  // null: none were wanted
  Occurrences occurrences = {};                // in sensors, of joints and of events
  Overlap in_ground = {};  // the deepest of a body whose joint keeps it from touching the ground
  bool stopped = false;    // by RunWish::stops
};

/// @throws std::invalid_argument for a setting or a time out of range, and for tracks of what is not there.
SceneRun run_scene(const SceneEntry& scene, const Setting& setting, const RunWish& wish,
                   const ConsoleSettings& console);

/// A time series for files: header and rows.
std::string series_csv(const CsvTable& series);

}  // namespace cairn::sandbox
