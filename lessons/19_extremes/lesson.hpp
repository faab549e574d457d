// Lesson 19. A heavy box on a light one, and the other way round.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::edges {

// Two boxes, one upon the other: how many sweeps their masses cost.

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

// The same stacks, step by step with a warm start.

inline constexpr double stack_height = 2;  // [m]

struct StackSettings {
  double ratio = 100;  // of the heavy box
  int sweeps = 10;     // of SI, in every step
  int steps = 60;
};

struct StackCourse {
  double ratio = 1;               // mass above / mass below
  List<Snapshot> frames = {};     // one for each step, the start first
  List<double> off_by_step = {};  // of the top, from where it was, as a share of the height
  List<double> energy_by_step =
      {};  // more than at the start, as a share of that of both masses at the height
};

/// The largest of all steps so far.
double worst(const List<double>& by_step, int step);
/// Whether the top has been off by at most 1 % of the height so far, and the energy up by at most 1 %.
bool is_ok(const StackCourse& course, int step);
std::string verdict(bool is_good);

// What is printed, checked and drawn.

struct ExtremesRun {
  StackSettings settings = {};
  List<RatioRun> ratios = {};
  List<StackCourse> courses = {};  // the heavy box above, and below
};

/// Prints ratios, stacks and the answer, and checks every claim.
void report(Lesson& lesson, const ExtremesRun& run);

CsvTable numbers_table(const ExtremesRun& run);

/// "100 kg on 1 kg": the name of a ratio of masses.
std::string name_of(double ratio);

/// The ground and two boxes with their masses on them, the heavy one darker.
void draw_boxes(Page& page, const Camera& camera, const Snapshot& now, double ratio);
/// Both stacks, step by step.
List<Shot> step_shots(const ExtremesRun& run);
/// The question, the two stacks sweep by sweep and step by step, and the answer.
List<Shot> extremes_shots(const ExtremesRun& run);

}  // namespace cairn::edges
