// Floor 9. The stability atlas: over two axes at once, what holds, what degrades and what explodes.
#pragma once

#include <functional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/scenes/setting.hpp>
#include <cairn/study/journal.hpp>
#include <cairn/study/trial.hpp>

namespace cairn {

/// How a run ended, from the best to the worst. What a map calls them is in AtlasMap::classes.
enum class AtlasClass { holds, strained, failed, exploded, refused, not_run };
inline constexpr int atlas_classes = 5;  // that a map has a name for: all but not_run

/// What one run of a map came to.
struct AtlasCell {
  AtlasClass ending = AtlasClass::not_run;
  double measured = 0;     // AtlasMap::quantity
  double energy_gain = 0;  // of its scale; a run is given up once it has gained atlas_explosion
};

/// A gain of energy that nothing in the scene can explain, as a part of its scale.
inline constexpr double atlas_explosion = 0.1;

struct AtlasAxis {
  std::string title = {};  // with its unit
  List<double> values = {};
  List<std::string> labels = {};  // as many, for pictures; "" for none
};

/// One solver's part of a map.
struct AtlasPanel {
  std::string title = {};
  Setting setting = {};  // without what the axes say
  bool in_title = false;
  /// The answer does not depend on the y axis: one run for each x, which belongs to all y.
  bool ignores_y = false;
};

struct AtlasRule {
  std::string name = {};  // "leans"
  std::string rule = {};  // "moved less than 25 cm a box"
};

/// What to say of a panel in one line.
enum class AtlasReading {
  from_y,   // the least y from which on the headline's x holds
  up_to_y,  // the largest y up to which the headline's x holds
  up_to_x,  // the largest x up to which each y holds
};

struct AtlasMap {
  std::string name = {};      // "mass-ratio"
  std::string what = {};      // the scene, in a sentence
  std::string quantity = {};  // what is measured, with its unit
  AtlasAxis x = {};
  AtlasAxis y = {};
  List<AtlasPanel> panels = {};
  FixedList<AtlasRule, atlas_classes> classes = {};  // by AtlasClass; no name: does not occur
  AtlasReading reading = AtlasReading::from_y;
  int headline = 0;                // place on the x axis
  std::string headline_text = {};  // "A mass ratio of 100 stands"
  std::string y_unit = {};         // behind a number: "sweeps"
  std::function<AtlasCell(const AtlasPanel& panel, double x, double y)> run = {};
};

enum class AtlasPart { all, quick };

/// All maps; quick: every second value of their axes.
List<AtlasMap> atlas_maps(AtlasPart part);

/// A map that was run.
struct AtlasSheet {
  AtlasMap map = {};
  List<AtlasCell> cells = {};  // by panel, then x, then y

  const AtlasCell& cell(int panel, int x, int y) const;
};

/// "holds", "strained", "failed", "exploded", "refused" or "not run".
std::string atlas_class_text(AtlasClass ending);

/// One task for each cell.
Study atlas_study(AtlasPart part);
/// From Journal::csv() of that study. Cells that it does not have were not run.
/// @throws std::invalid_argument for a table of another kind.
List<AtlasSheet> atlas_sheets(AtlasPart part, const std::string& csv);

/// "from 64 sweeps", "float to 10^4 m": see AtlasReading.
std::string panel_finding(const AtlasSheet& sheet, int panel);
/// A sentence for the whole map, of the panels that want to be in it.
std::string sheet_finding(const AtlasSheet& sheet);

// How the maps are made and run: what carries loads, and what numbers can tell apart.
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
