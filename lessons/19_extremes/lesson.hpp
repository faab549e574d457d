// Lesson 19. What is not to be stepped at all, what must not matter, and what has no answer.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::edges {

/// A thing that no engine could simulate, and what this one says to it.
struct Refusal {
  std::string asked = {};    // "a mass of 0"
  std::string message = {};  // empty: it was taken
};

/// A mass of zero, a step of zero, a place that is no number, a rod without length, friction below zero.
List<Refusal> try_bad_input();

/// What a joint that divides zero by zero leaves behind.
struct Guarded {
  int joined = 0;       // the first body of that joint
  int body = -1;        // the one that the report names; -1: none
  double moved = 0;     // [m] how far anything has gone in that step
  bool finite = false;  // whether all numbers of the world are
};
Guarded try_not_a_number();

/// How far the heights of a tower differ [m] with all masses multiplied by 2^20, and by 2^-20.
struct Scaled {
  double heavy = 0;
  double light = 0;
};
Scaled try_scaled_masses(int sweeps);

/// How far a pendulum with its rod stated twice is from one with its rod stated once, at most [m].
double try_twice(int sweeps, int steps);

/// Of the two pins in one solve of thousands of sweeps: why it ended.
Stop try_long_quarrel();

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

// Four small worlds, each driven to where it breaks or does not, and a stamp for each.

struct WallSettings {
  double ratio = 100;  // of the heavy box
  int sweeps = 10;     // of SI, in every step of every world
  int boxes = 50;      // in the tower
  int steps = 60;
};

/// How a world has come through.
enum class Stamp {
  ok,       // off by 1 % at most, and at most 1 % of energy from nowhere
  soft,     // off by no more than its own size, and as little energy
  growing,  // the same, but a joint pulls harder and harder: nothing of it is to be seen
  broken,   // none of these
};
std::string stamp_text(Stamp stamp);

struct EdgeCase {
  std::string name = {};
  std::string quantity = {};         // what `off` is a share of
  List<Snapshot> frames = {};        // one for each step, the start first
  List<double> off_by_step = {};     // 0 is right, 1 as far as the thing is large
  List<double> energy_by_step = {};  // more than at the start, as a share of what the scene has to spend
  Aabb<double> view = {};            // [m] what is shown of it
  double top = 0;                    // [m] where its upper side belongs; 0: it is no stack
};

/// The largest of all steps so far.
double worst(const List<double>& by_step, int step);
/// What the first joint gives in a step [N]; 0 if there is none.
double pull_of(const EdgeCase& edge, int step);
/// By the steps so far.
Stamp stamp_of(const EdgeCase& edge, int step);

/// A scene, and what is measured of it.
struct SmallWorld {
  EdgeCase edge = {};
  Scene scene = Scene();
  double budget = 0;  // [J] the energy that it has to spend; infinite where errors in positions bring some
  std::function<double(const Snapshot&)> off = {};
};

/// In this order: heavy on light, light on heavy, the tower, two pins that contradict each other.
List<SmallWorld> small_worlds(const WallSettings& settings);

inline constexpr int two_pins = 3;
inline constexpr double pins_apart = 0.4;  // [m]
inline constexpr double pins_beta = 0.2;

/// One body, pinned in the middle to two places. It stands where the second pin wants it.
Scene two_pins_scene();
/// What each of the two pins pulls with after a step [N], by formula: in every sweep one gives m beta d / dt
/// more, which the other takes back.
double quarrel_by_formula(const WallSettings& settings, int step);

// What is printed, checked and drawn.

struct ExtremesRun {
  WallSettings settings = {};
  List<RatioRun> ratios = {};
  List<EdgeCase> wall = {};
  List<Refusal> refusals = {};
};

/// Prints ratios, worlds, refusals and the answer, and checks every claim.
void report(Lesson& lesson, const ExtremesRun& run);

CsvTable numbers_table(const ExtremesRun& run);

/// "100 kg on 1 kg": the name of a ratio of masses.
std::string name_of(double ratio);

/// The ground and two boxes with their masses on them, the heavy one darker.
void draw_boxes(Page& page, const Camera& camera, const Snapshot& now, double ratio);
/// Four worlds, step by step.
List<Shot> wall_shots(const ExtremesRun& run);
/// The question, the two stacks, the above, and the answer.
List<Shot> extremes_shots(const ExtremesRun& run);

}  // namespace cairn::edges
