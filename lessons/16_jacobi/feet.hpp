// A box on feet, which share one body: what happens when all of them correct the same error at once.
#pragma once

#include <string>

#include "cairn.hpp"
#include "math/list.hpp"

namespace cairn::everybody {

inline constexpr double box_mass = 6;      // [kg]; of 1 m by 1 m, so that its inertia is 1 kg m^2
inline constexpr double gravity = 10;      // [m/s^2]
inline constexpr double time_step = 0.02;  // [s]
inline constexpr double outermost = 0.25;  // [m] from the middle to the last foot on either side

/// The three ways to let all rows act at once, and the one that lets them act in turn.
enum class Method { plain, damped, split, sequential };
inline constexpr Method all_methods[] = {Method::plain, Method::damped, Method::split, Method::sequential};

/// Solves with the library's and returns what the recorder saw. Omega is for Method::damped.
SweepRecorder<double> solved(Method method, double omega, int sweeps, VelocityProblem<double>& problem);

struct FeetSettings {
  int feet = 3;
  double omega = 0.3;
  int sweeps = 12;
};

/// One solve: after each sweep, sweep 0 being the start.
struct FeetHistory {
  Method method = Method::plain;
  List<List<double>> lambda = {};  // [N] of each foot
  List<double> speed = {};         // [m/s] of the box, upwards
};

struct FeetRun {
  FeetSettings settings = {};
  VelocityProblem<double> problem = {};  // after one step of falling: rows from left to right
  List<double> share = {};               // c_i = 1 / (m A_ii): what foot i gives alone, over the weight
  double answer = 0;                     // sum of c_i: what all of them give at once, over the weight
  List<FeetHistory> histories = {};      // in the order of all_methods
  Snapshot snapshot = {};                // the box on its feet
};

/// All but the histories.
FeetRun box_on_feet(const FeetSettings& settings);

const FeetHistory& history_of(const FeetRun& run, Method method);
double together(const List<double>& lambda);

/// omega * answer for the methods that act at once: the share of the error that one sweep takes away, which
/// is too much above 1, and never comes right from 2 on.
double taken_at_once(const FeetRun& run, Method method);

/// The speed of the box after so many sweeps, in closed form, for the methods that act at once. With
/// q = taken_at_once, the first sweep leaves (1 - q) of the falling speed. Below q = 2 so does every further
/// one; above it the second would have to pull, lets go instead, and the third is the first again.
double speed_by_formula(const FeetRun& run, Method method, int sweep);

}  // namespace cairn::everybody
