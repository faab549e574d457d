// Lesson 21. A chain of light beads under a heavy weight: the scene, what theory says of it, and what runs
// measure.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::taut {

inline constexpr double gravity = 10;      // [m/s^2]
inline constexpr double rod_length = 0.5;  // [m]
inline constexpr double lost = 0.1;        // [m] a chain with a bead so far from the line is none any more
inline constexpr int film_steps = 60;

struct ChainSettings {
  int beads = 10;
  double bead = 0.1;  // [kg]
  double load = 50;   // [kg] at the lower end
  double dt = 0.02;   // [s]
  int parts = 4;      // into which the third of the four cures cuts a step
};

/// How a chain is stepped, and where it begins.
struct ChainRules {
  StabilizationPolicy policy = StabilizationPolicy::baumgarte;
  double bent = 1e-3;        // [m] that beads begin beside the line, in turn to the right and to the left
  List<double> masses = {};  // [kg] with which beads take part; empty: their own
  int substeps = 1;
};

/// Beads on rods, one below the other, from a nail at the origin; the load hangs below the last. Beads weigh
/// what they weigh, with whatever mass they take part.
Scene chain_scene(const ChainSettings& settings, const ChainRules& rules);

/// [N] of each rod, from the nail down, where the chain hangs straight.
List<double> forces_of(const ChainSettings& settings);
/// The squares of the angular frequencies [1/s^2] with which the chain swings sideways, ascending. `masses`
/// of the beads.
List<double> squared_frequencies(const ChainSettings& settings, const List<double>& masses);
/// ω Δt of the fastest, which must not be above 2.
double fastest_angle(const ChainSettings& settings);
/// [kg] under which the fastest swing has ω Δt = 2.
double critical_load(ChainSettings settings);
/// [kg] the same by ω² = 4 f / (l m), with the weight of the load alone for f.
double load_by_rule(const ChainSettings& settings);
/// What a step multiplies the fastest swing with: 1 up to ω Δt = 2.
double growth_by_formula(double angle);
/// [kg] with which each bead may take part so that ω Δt <= 2, whatever hangs below: never less than its own.
List<double> masses_needed(const ChainSettings& settings);

/// What became of one chain.
struct ChainRun {
  std::string name = {};
  List<Snapshot> frames = {};  // the start, and after each step
  List<double> off = {};       // [m] of the bead that is farthest from the line, likewise
  int torn = -1;               // the first step after which a bead was `lost`; -1: none

  double off_most() const { return *std::max_element(off.begin(), off.end()); }
};

ChainRun run_chain(const std::string& name, const ChainSettings& settings, const ChainRules& rules,
                   Solver<double>& solver, int steps);

/// One time step, and the heaviest load that the chain holds under it.
struct Critical {
  double dt = 0;         // [s]
  double rule = 0;       // [kg]
  double predicted = 0;  // [kg]
  double measured = 0;   // [kg]
};

/// By how much a step multiplies the fastest swing, under a load.
struct Growth {
  double load = 0;   // [kg]
  double angle = 0;  // ω Δt
  double predicted = 0;
  double measured = 0;
};

struct ChainRuns {
  ChainSettings settings = {};
  List<Critical> criticals = {};  // dt, dt / 2, dt / parts
  List<Growth> growths = {};
  List<ChainRun> sweeps = {};  // 10, 100, 10 000, and the exact solver
  List<ChainRun> cures = {};   // exactly solved: in the order below
};

enum : int { ten_sweeps, hundred_sweeps, many_sweeps, exactly };  // of ChainRuns::sweeps
enum : int { heavier, enough_mass, short_steps, by_default };     // of ChainRuns::cures

/// "a quarter", or "1/9".
std::string part_name(const ChainSettings& settings);

// What is printed, checked and drawn.

void report(Lesson& lesson, const ChainRuns& runs);
CsvTable numbers_table(const ChainRuns& runs);
List<Shot> chain_shots(const ChainRuns& runs);

}  // namespace cairn::taut
