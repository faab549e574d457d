// Lesson 22. A bridge under the default setting, and under the same with one part of it switched off.
#pragma once

#include <cairn/scenes/default_setting.hpp>
#include <cairn/scenes/simulation.hpp>
#include <cairn/scenes/solver_list.hpp>
#include "lessons/kit/kit.hpp"

namespace cairn::usual {

inline constexpr double seconds = 1;  // of each run of a small scene

struct DefaultSettings {
  int planks = 12;      // of the bridge
  double density = 20;  // [kg/m^2] of its loads
  int tower = 110;      // boxes of the tower that is beyond the border
};

/// A scene, and what it is called.
struct Kind {
  std::string name = {};
  Scene scene = Scene();
  BodyId watched = {};     // that should stay where it is; the ground where there is none
  Aabb<double> view = {};  // [m] that pictures show
};

Kind beam(int pieces);
Kind tower(int boxes);
Kind pile(int stones);
/// Planks as long as the gap between two banks, and three loads, the middle one of which is watched.
Kind bridge(int planks, double density);

/// One part of the default that is switched off.
struct Part {
  std::string name = {};
  std::function<void(Setting&)> change = {};
};

/// In this order: nothing, the substeps, the second solve with the arcs and the mass of joints, all systems
/// but the first, all rows at once.
List<Part> parts();
enum : int { nothing_off, one_substep, one_solve, one_system, swept };

/// One scene under one setting.
struct Outcome {
  std::string name = {};    // of the part that is off
  double overlap = 0;       // [m] the deepest of all steps
  double gap = 0;           // [m or rad] the widest of a joint, likewise
  double sunk = 0;          // [m] by which the watched body has been lowest
  double work = 0;          // of a step on average: row updates of SI that take as long
  double milliseconds = 0;  // of a step on average, on this machine
  List<double> overlap_by_step = {};
  List<double> sunk_by_step = {};
  Snapshot last = {};    // after the last step
  Snapshot lowest = {};  // where the watched body is lowest; after the last step where none is watched
};

/// A scene with all that was tried on it.
struct Trials {
  Kind kind = {};
  DefaultSetting usual = {};
  List<Outcome> outcomes = {};
};

/// Sweeps in place of all rows at once, on the bridge.
struct SweepTrial {
  int sweeps = 0;   // of each solve
  double sunk = 0;  // [m]
  double work = 0;  // as Outcome::work
};

struct DefaultRuns {
  DefaultSettings settings = {};
  double from_simulation = 0;  // [m] between the bridge under the default and the same in a Simulation
  Trials bridge = {};          // each part switched off in turn
  Trials beam = {};            // the default, and 20 sweeps
  List<Trials> large = {};     // a tower and a pile beyond the border: sweeps, and all rows at once
  List<SweepTrial> sweeps = {};
};
enum : int { the_tower, the_large_pile };  // of DefaultRuns::large
enum : int { by_sweeps, at_once };         // of their outcomes

/// Steps the scene for so long [s].
Outcome try_setting(const Kind& kind, const Setting& setting, double duration);

/// [m] By how much the gaps of its joints make each half of a bridge longer.
double longer_half(const Snapshot& bridge);
/// [m] How far the middle of a level chain hangs down, each half of which gets longer by so much.
double hangs_by(double half, double longer);

// What is printed, checked and drawn.

void report(Lesson& lesson, const DefaultRuns& runs);
CsvTable outcomes_table(const DefaultRuns& runs);
List<Shot> default_shots(const DefaultRuns& runs);

}  // namespace cairn::usual
