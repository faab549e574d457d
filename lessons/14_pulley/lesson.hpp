// Lesson 14. Three masses on one rope, and what seven solvers make of their fall.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::pulley {

inline constexpr double gravity = 10;                     // [m/s^2]
inline constexpr FixedList<double, 3> parts = {1, 2, 1};  // r_i
inline constexpr double wheel_radius = 0.7;               // [m]
inline constexpr double wheel_height = 6;                 // [m] of the fixed wheels' middles

struct PulleySettings {
  double dt = 0.02;                         // [s]
  FixedList<double, 3> masses = {1, 2, 3};  // [kg]
  int steps = 50;
  int lift_step = 20;  // after it the third mass is thrown upwards: at 0.4 s, as near as steps come
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
/// How many solvers find that in the first step.
int right_solvers(const PulleyRuns& all);

// What is printed, checked and drawn.

PulleySettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const PulleySettings& settings);
/// The masses that weigh more than the rope pulls, with both.
std::string what_goes_down(const PulleySettings& settings);
void print_runs(Lesson& lesson, const PulleyRuns& all);
void check_runs(Lesson& lesson, const PulleyRuns& all);

/// Sweeps over the rows of a pyramid, each row an object with a virtual call.
struct CallTimes {
  int rows = 0;
  double one = 0;   // [ns] a row update, all objects of one class
  double four = 0;  // of four classes in random order
};

/// Virtual calls in a sweep over a rope and a tower.
struct CountedCalls {
  int constraints = 0;
  int in_one_loop = 0;   // over all constraints
  int in_two_loops = 0;  // the second over the contacts, without virtual calls
  double change = 0;     // [N s] of the impulses, against sweeps with no virtual call, or with fewer classes
  List<CallTimes> times = {};  // in the order of the scene, and by colours
};

/// The first step of the rope and a tower that stands beside it.
VelocityProblem<double> rope_and_tower(const PulleySettings& settings);
inline constexpr int tower_boxes = 20;

CountedCalls count_calls(const PulleySettings& settings);
/// Adds the times, which differ from machine to machine.
void time_calls(CountedCalls& counted);
void print_calls(Lesson& lesson, const CountedCalls& counted);
void check_calls(Lesson& lesson, const CountedCalls& counted);

/// Sweeps over the same rope and tower by objects, a class for each kind of constraint.
struct ObjectSweeps {
  double si_gap = 0;   // [N s] to the impulses of a solver that knows rows alone
  double pgs_gap = 0;  // [N s] likewise
  double largest = 0;  // [N s] of the impulses
  int pgs_others = 0;  // numbers of rows that objects keep, and are not their own
};

ObjectSweeps sweep_objects(const PulleySettings& settings);
void print_objects(Lesson& lesson, const ObjectSweeps& swept);
void check_objects(Lesson& lesson, const ObjectSweeps& swept);

CsvTable steps_table(const PulleyRuns& all);

/// The row and its numbers, then every step of the fall.
List<Shot> pulley_shots(const PulleyRuns& all);

}  // namespace cairn::pulley
