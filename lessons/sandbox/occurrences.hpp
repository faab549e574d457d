// What came about in a run: who was in which sensor and when, what broke, and what events counted.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>

#include <cairn/math/list.hpp>
#include <cairn/scenes/scene_list.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn::sandbox {

/// A body in a sensor. Both times are those of the ends of the steps that saw it.
struct SensorVisit {
  BodyId sensor = {};
  BodyId body = {};
  double entered = 0;               // [s]
  std::optional<double> left = {};  // [s] none: it is still there at the end
};

class Occurrences {
 public:
  /// The next snapshot of a run.
  void see(const Snapshot& now);

  /// In the order in which they were entered.
  const List<SensorVisit>& visits() const { return visits_; }
  const List<SnapshotBreak>& breaks() const { return breaks_; }
  const List<SnapshotCounter>& counters() const { return counters_; }

 private:
  List<SensorVisit> visits_;
  List<SnapshotBreak> breaks_;
  List<SnapshotCounter> counters_;
};

/// A name and what is said of it, for a table: {"broke", "rod.1 at 1.2 s, holding 350 N"}.
using OccurrenceLine = std::pair<std::string, std::string>;

/// One line for all counters, and one for each break and each visit; of more than a few, how many more there
/// are.
List<OccurrenceLine> occurrence_lines(const SceneEntry& scene, const Occurrences& occurrences);

/// counters, broken, sensors.
nlohmann::ordered_json occurrences_json(const SceneEntry& scene, const Occurrences& occurrences);

}  // namespace cairn::sandbox
