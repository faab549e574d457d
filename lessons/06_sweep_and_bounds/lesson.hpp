// Lesson 06. Two systems A lambda = b, swept row by row with and without bounds: a stack, and a rod on two
// supports.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::sweeps {

inline constexpr double gravity = 10;     // [m/s^2]
inline constexpr double rod_mass = 4;     // [kg]
inline constexpr double rod_length = 3;   // [m]
inline constexpr double rod_inertia = 3;  // [kg m^2] of a thin rod: m l^2 / 12

struct SweepSettings {
  int boxes = 3;
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

/// One row for each contact of a stack of unit boxes of 1 kg, from the ground up.
struct StackRun {
  SystemMatrices<double> system = {};
  Swept up = {};              // from the ground up
  Swept down = {};            // from the top down
  Swept unbounded = {};       // up, with rows that could pull as well
  PerRow<double> exact = {};  // [N] the weight above each contact
  List<double> error = {};    // largest error of any lambda after each sweep, over the largest lambda
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
  StackRun stack = {};
  RodRun rod = {};
};

/// The two systems. Gravity has acted for one step: everything falls at g dt.
VelocityProblem<double> stack_problem(const SweepSettings& settings);
VelocityProblem<double> rod_problem(const SweepSettings& settings);

/// So many sweeps of the library's projected Gauss-Seidel, and of the same by hand.
Swept swept(VelocityProblem<double> problem, int sweeps, RowOrder order = RowOrder::as_written);
/// What was recorded of a solve, in N.
Swept recorded(const SweepRecorder<double>& recorder, double dt);

SweepRun run_sweeps(const SweepSettings& settings);

/// Lambda [N] of the stack after the given sweep from the ground up, counted in whole numbers: every update
/// takes the half of a sum, so that after few sweeps each is a whole number of 2^-30 b_1.
PerRow<double> counted_lambda(const SweepRun& run, int sweep);

/// What a sweep leaves of the error of a stack of n boxes: rho = cos^2(pi / 2n), derived in lesson 03.
double error_factor(int boxes);
/// The same, measured after so many sweeps that the other errors have died out.
double measured_error_factor(const SweepSettings& settings);

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

void print_scenes(Lesson& lesson, const SweepSettings& settings);
void print_stack(Lesson& lesson, const SweepRun& run);
void print_rod(Lesson& lesson, const SweepRun& run);
void print_intervals(Lesson& lesson);
void check_stack(Lesson& lesson, const SweepRun& run);
void check_rod(Lesson& lesson, const SweepRun& run);
CsvTable updates_table(const SweepRun& run);

/// The rod in the plane of its two lambda, how the error of the stack shrinks, and the intervals.
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
  bool levels = false;                    // ellipses of equal ½ λ·A λ − b·λ
};

void draw_plane(Page& page, const Rect& rect, const SweepRun& run, const PlaneView& view);

}  // namespace cairn::sweeps
