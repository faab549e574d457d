// Lesson 08. A tower that begins every step from zero, or from last step's impulses.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::warm {

inline constexpr double gravity = 10;         // [m/s^2]
inline constexpr double too_deep = 0.4;       // [m] of overlap; at half a box contacts would push sideways
inline constexpr int many_sweeps = 50;        // of the question
inline constexpr int question_steps = 300;    // for which its two towers are followed
inline constexpr double wanted_error = 0.01;  // of the load on the lowest contact

struct StartSettings {
  int boxes = 10;  // of 1 kg and 1 m
  int sweeps = 10;
  int steps = 120;
  double dt = 0.02;  // [s]

  double weight() const { return boxes * gravity; }  // [N]
};

/// What the first sweep of a step finds.
enum class Start {
  cold,       // no impulses
  warm,       // each row its own of the step before
  by_number,  // each row that of the row which had its place: a mistake
};

/// Last step's impulses [N s] under the names of their rows, in the order of the rows.
using Memory = List<std::pair<RowKey, double>>;

/// Frame k is the state after k steps; frame 0 is the start.
struct StartRun {
  std::string name = {};
  List<Snapshot> frames = {};     // steps + 1
  List<List<double>> loads = {};  // [frame][interface] [N]; interface 0 is the ground's
  int comparable = 0;             // the last frame before any overlap is too_deep
};

/// The tower, with an elastic ball that bounces beside it. Its contact, when there is one, is the first row.
struct GuestRun {
  List<List<double>> by_key = {};     // [frame][interface] [N]
  List<List<double>> by_number = {};  // impulses kept in a list, found by their place
  List<char> ball_touches = {};       // in each frame
  List<Snapshot> frames = {};         // of the run by number
};

/// One step from zero.
struct ColdSweeps {
  int boxes = 0;
  int needed = 0;  // sweeps until the error of the lowest load is wanted_error
};

/// The warm tower again, with the world's own memory.
struct LibraryRun {
  List<List<double>> loads = {};  // [frame][interface] [N]
  double load_at_half_dt = 0;     // [N] lowest first guess once dt is halved at the end
};

struct WarmStart {
  StartSettings settings = {};
  StartRun cold = {};
  StartRun warm = {};
  StartRun many_cold = {};  // with many_sweeps, for question_steps
  StartRun one_warm = {};   // with one sweep, for as many steps
  GuestRun guest = {};
  List<ColdSweeps> sweeps = {};  // of 3, 5, 10 and 20 boxes
  LibraryRun library = {};
};

StartRun follow_tower(const StartSettings& settings, Solver<double>& solver, const std::string& name);
/// How far the top of the tower has risen by then [mm].
double risen(const StartRun& run, int frame);
/// The lowest place of the top in all frames [mm], against that at the start.
double lowest(const StartRun& run);
GuestRun follow_guest(const StartSettings& settings, Solver<double>& by_key, Solver<double>& by_number);
LibraryRun run_library(const StartSettings& settings);
/// One step from zero, until the lowest contact lacks wanted_error, and some sweeps more.
ColdSweeps sweep_cold(int boxes, double dt);

/// What one warm sweep a step costs: while its top is deeper than that of many cold ones.
struct Price {
  int deeper = 0;   // steps
  int last = 0;     // of these
  int at = 0;       // of these, where the top is deepest
  double warm = 0;  // [mm] how far it has risen by then
  double cold = 0;
};
Price price_of(const WarmStart& all);
void tell_price(Lesson& lesson, const WarmStart& all);

/// Masses on a line in plain loops: gravity, Gauss-Seidel from the ground up, semi-implicit Euler. No engine.
/// [frame][interface] [N]
List<List<double>> loads_by_hand(const StartSettings& settings);

/// The cold tower by powers of the matrix of Gauss-Seidel, G = -(D + L)^-1 U.
struct ColdTheory {
  List<List<double>> loads = {};   // [frame][interface] [N]
  List<double> top_velocity = {};  // [m/s] of the uppermost box, for each frame
};
ColdTheory cold_by_matrix(const StartSettings& settings);

/// What `sweeps` sweeps over n boxes leave of an error in the long run: rho^sweeps, rho = cos^2(pi / 2n).
double share_left(int boxes, double sweeps);
/// A cold start's sweeps to `wanted_error`: what is left of the slowest mode, which is 8/pi^2 of the error.
double needed_by_formula(int boxes);
/// The largest |load - weight| of the lowest contact in the last quarter of the steps [N].
double unrest(const List<List<double>>& loads, double weight);

// What is printed, checked and drawn.

/// The question of the card with the numbers of these runs.
std::string question_of(const WarmStart& all);

void tell_scene(Lesson& lesson, const StartSettings& settings);
void tell_loads(Lesson& lesson, const WarmStart& all);
void tell_sweeps(Lesson& lesson, const WarmStart& all);
void tell_order(Lesson& lesson, const WarmStart& all);
void check_claims(Lesson& lesson, const WarmStart& all);
CsvTable table_of(const WarmStart& all);

/// Two towers side by side, and a ball that shifts all rows.
List<Shot> start_shots(const WarmStart& all);

/// What becomes of impulses in the wrong place.
Shot order_shot(const WarmStart& all);

/// Cold, warm, and impulses that come to the wrong row.
FixedList<SeriesStyle, 3> start_styles(const Theme& theme);

}  // namespace cairn::warm
