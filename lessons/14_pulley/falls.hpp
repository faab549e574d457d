// Three masses on one rope, and what seven solvers make of their fall.
#pragma once

#include <string>

#include "cairn.hpp"
#include "math/list.hpp"

namespace cairn::pulley {

inline constexpr double gravity = 10;                     // [m/s^2]
inline constexpr FixedList<double, 3> parts = {1, 2, 1};  // r_i
inline constexpr double wheel_radius = 0.7;               // [m]
inline constexpr double wheel_height = 6;                 // [m] of the fixed wheels' middles

struct PulleySettings {
  double dt = 0.02;                         // [s]
  FixedList<double, 3> masses = {1, 2, 3};  // [kg]
  int steps = 50;
  int lift_step = 20;  // after it the third mass is thrown upwards
  double lift = 3;     // [m/s]
};

/// What one step left behind.
struct PulleyStep {
  Snapshot snapshot = {};
  FixedList<double, 3> speed = {};  // [m/s] upwards
  double tension = 0;               // lambda [N]
  double room = 0;                  // C [m]: 0 where the rope is taut
};

/// One solver's account of the whole fall.
struct PulleyRun {
  std::string solver = {};
  List<PulleyStep> steps = {};  // steps[0] is the start
  std::size_t memory = 0;       // bytes beside the problem
};

struct PulleyRuns {
  PulleySettings settings = {};
  VelocityProblem<double> first = {};  // the problem of the first step
  List<PulleyRun> runs = {};           // SI first, then six others
};

Scene pulley_scene(const PulleySettings& settings);

PulleyRuns run_pulleys(const PulleySettings& settings);

/// The world as it is now.
PulleyStep look(const World<double>& world);
/// Forgets what comes after a mass has met a wheel or has left the picture, in all runs alike.
void end_at_wheels(PulleyRuns& all);

/// lambda [N] while the rope is taut: sum r_i g / sum r_i^2 / m_i.
double tension_by_hand(const PulleySettings& settings);

}  // namespace cairn::pulley
