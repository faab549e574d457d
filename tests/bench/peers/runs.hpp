// Runs of a contestant through a scene: to see its errors, and to take its time.
#pragma once

#include <optional>
#include <string>

#include "../measure.hpp"
#include "errors.hpp"
#include "peer_list.hpp"
#include "peer_scenes.hpp"

namespace cairn::bench {

/// How long every run is.
struct RunLength {
  int steps = 500;      // the first tenth of them warms up: nothing of it is measured
  int repetitions = 5;  // that are timed
  /// [s] A run that takes longer is broken off. Where all runs of a contestant would take longer, there are
  /// fewer, and where two would, it is timed while its errors are looked at.
  double most = 60;
};

/// What a run has shown.
struct Finding {
  std::optional<std::string> refused = {};  // why the engine cannot run the scene
  bool too_slow = false;                    // the run was broken off
  double seconds = 0;                       // [s] of a step after the warm-up
  double bytes = 0;                         // that the engine keeps at the end
  double worst_overlap = 0, worst_gap = 0;  // [m] of every tenth step
  Errors end = {};                          // after the last step
};

/// A scene, and how long it is run.
struct Task {
  /// Of `length`, or of fewer steps where the entry says so.
  Task(const PeerScene& entry, const RunLength& length);

  PeerScene entry;
  Scene scene;  // that it makes
  RunLength length;
};

/// Steps the scene once and looks at every tenth step; ends as soon as errors exceed the target, if there is
/// one.
Finding find_errors(const Task& task, const Contestant& contestant, const std::optional<Target>& target = {});
/// Whether nothing is worse than the target allows.
bool reaches(const Finding& finding, const Target& target);

/// [ns] of a step for each contestant and repetition: every repetition runs all contestants, one after the
/// other, and begins with another. `findings` are theirs; no time is taken of those who cannot run, explode
/// or are too slow.
List<List<double>> times(const Task& task, const List<Contestant>& contestants,
                         const List<Finding>& findings);

}  // namespace cairn::bench
