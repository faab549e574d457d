// Lesson 06. A lambda = b of a rod on two supports, swept row by row with and without bounds.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::sweeps {

inline constexpr double gravity = 10;     // [m/s^2]
inline constexpr double rod_mass = 4;     // [kg]
inline constexpr double rod_length = 3;   // [m]
inline constexpr double rod_inertia = 3;  // [kg m^2] of a thin rod: m l^2 / 12

struct SweepSettings {
  double dt = 0.02;  // [s]
  int sweeps = 10;
  double support = 1;  // [m] from the left end of the rod to its right support; the left one is at the end
};

/// One solve, recorded. All lambda in N.
struct Swept {
  List<RowUpdate<double>> updates = {};  // of every row
  List<PerRow<double>> after = {};       // all lambda after each of these
  List<PerRow<double>> by_sweep = {};    // and after each sweep; 0: nothing yet
  PerBody<Vec3<double>> velocity = {};   // of all bodies, at the end
  double gap = 0;                        // [N] to the same sweeps by hand; the largest
};

/// A row for each support of a rod.
struct RodRun {
  SystemMatrices<double> system = {};
  Swept bounded = {};                 // sweeps of projected Gauss-Seidel
  Swept unbounded = {};               // the same with rows that could pull as well
  Swept settled = {};                 // bounded, swept until rounding
  FixedList<double, 2> statics = {};  // [N] what A lambda = b says
  FixedList<double, 2> formula = {};  // [N] with supports that can only push
  FixedList<double, 2> leaving = {};  // [m/s^2] w = A lambda - b of what it settles at
  FixedList<double, 2> arm = {};      // [m] from the middle of the rod to each support, to the right
  double rate = 0;                    // of Gauss-Seidel: A_12^2 / (A_11 A_22)
  Snapshot snapshot = {};
  List<Snapshot> motion = {};  // 0.5 s of it, every 0.1 s
  bool tips() const { return statics[0] < 0; }
};

struct SweepRun {
  SweepSettings settings = {};
  RodRun rod = {};
};

/// Gravity has acted for one step: the rod falls at g dt.
VelocityProblem<double> rod_problem(const SweepSettings& settings);

/// So many sweeps of the library's projected Gauss-Seidel, and of the same by hand.
Swept swept(VelocityProblem<double> problem, int sweeps);
/// What was recorded of a solve, in N.
Swept recorded(const SweepRecorder<double>& recorder, double dt);

SweepRun run_sweeps(const SweepSettings& settings);

/// For each kind of row its interval, and what is left of a few values.
struct Interval {
  std::string name = {};
  std::string reason = {};
  std::string lower = {};  // its ends in symbols
  std::string upper = {};
  Bounds<double> bounds = {};
};
List<Interval> kinds_of_rows();

// What is printed, checked and drawn.

void print_scene(Lesson& lesson, const SweepSettings& settings);
void print_rod(Lesson& lesson, const SweepRun& run);
void print_intervals(Lesson& lesson);
void check_rod(Lesson& lesson, const SweepRun& run);
CsvTable updates_table(const SweepRun& run);

/// The rod in the plane of its two lambda, and the intervals.
List<Shot> sweep_shots(const SweepRun& run);

/// The rod between the question and the answer.
List<Shot> rod_shots(const SweepRun& run);
/// The rod on its supports with the question, and with the answer.
Shot question_shot(const SweepRun& run);
Shot answer_shot(const SweepRun& run);

/// A and b as one matrix, with the row that is being visited framed; -1: none.
void draw_system(Page& page, const Rect& rect, const SystemMatrices<double>& system, int active);
/// (28) with the numbers of one update, and what became of it.
Equation equation_28(const Page& page, const SystemMatrices<double>& system, const Swept& swept, int update);

// The plane of the two lambda of the rod.

/// What the plane shows beside the answers, in N.
struct PlaneView {
  List<FixedList<double, 2>> way = {};    // with the clamp, from (0, 0)
  List<FixedList<double, 2>> other = {};  // without
  FixedList<double, 2> asked = {};        // what the last row would have had without it
};

void draw_plane(Page& page, const Rect& rect, const SweepRun& run, const PlaneView& view);

}  // namespace cairn::sweeps
