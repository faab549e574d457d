// Floor 11. What the map of settings says: the cheapest setting for an error, and one setting for many
// scenes.
#pragma once

#include <functional>
#include <string>

#include "math/list.hpp"
#include "measure/csv.hpp"

namespace cairn {

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
  double work = 0;   // [1/s] counted_work()
  double error = 0;  // [m], or part of what a formula says; infinite where there is no number

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
