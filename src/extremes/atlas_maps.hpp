// Floor 12. How the maps of the atlas run a cell, for its own source files only.
#pragma once

#include <limits>

#include "extremes/atlas.hpp"
#include "study/trial.hpp"
#include "math/list.hpp"

namespace cairn {

// One file each: what carries loads, and what numbers can tell apart.
AtlasMap mass_ratio_map();
AtlasMap stack_map();
AtlasMap chain_map();
AtlasMap spring_map();
AtlasMap origin_map();

/// The setting of a panel: 60 steps a second, Baumgarte, warm start, double, unless the map says otherwise.
Setting atlas_setting(const std::string& solver, int sweeps = 10);

/// A panel for each solver that sweeps. PGS is none of its own: its numbers are those of SI.
List<AtlasPanel> solver_panels(int sweeps);

/// What separates the classes of a run that stays finite.
struct AtlasLimits {
  double seconds = 2;
  double holds = 0;     // the measure is at most this
  double strained = 0;  // and otherwise at most this
};

/// Steps the scene until its time is over or it has exploded, and judges `measure`.
AtlasCell atlas_cell(const Scene& scene, const Setting& setting, const AtlasLimits& limits,
                     const std::function<double(const TrialResult&)>& measure);

/// The class of a number alone. What is no number has exploded.
AtlasClass class_of(double measured, const AtlasLimits& limits);

}  // namespace cairn
