// Two boxes, one upon the other: how many sweeps their masses cost.
#pragma once

#include "cairn.hpp"
#include "math/list.hpp"

namespace cairn::edges {

inline constexpr double gravity = 10;      // [m/s^2]
inline constexpr double time_step = 0.02;  // [s]
inline constexpr double goal = 0.01;       // share of the error that is left when a load counts as right

/// The masses of the lower and the upper box [kg]; the lighter one has 1 kg.
List<double> masses_of(double ratio);
/// What both weigh together [N]: the load on the ground.
double weight_of(double ratio);
/// One box on the ground and one on it: one row for each of the two contacts.
VelocityProblem<double> two_boxes(double ratio);
/// The same as a scene, to be drawn and to be stepped.
Scene two_boxes_scene(double ratio);

/// What a solve from nothing did, sweep by sweep.
struct RatioRun {
  double ratio = 1;                  // mass above / mass below
  List<List<double>> load = {};      // [sweep][row] [N]; all zero before the first sweep
  List<double> error = {};           // of the load on the ground: 1 at first, 0 when right
  List<List<double>> speed_jv = {};  // [sweep][row] [m/s]: j v when the row was visited
  int counted = 0;                   // sweeps until the error is below the goal
  double largest_gap = 0;            // of any sweep, from the formula
};

/// The largest distance of its loads from the formula, in any sweep, as a share of what is right.
double gap_to_formula(const RatioRun& run);

/// The error after k sweeps is (R / (1 + R))^k, for both loads.
double rate_by_formula(double ratio);
/// The first whole k with (R / (1 + R))^k <= share.
int sweeps_by_formula(double ratio, double share = goal);

/// @throws std::out_of_range for one that was not run.
const RatioRun& run_of(const List<RatioRun>& runs, double ratio);

}  // namespace cairn::edges
