// Lesson 09. A ball in the ground, a pendulum and a hanging weight: three rows, each with an error to get rid
// of.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::drift {

inline constexpr double gravity = 10;        // [m/s^2]
inline constexpr double rod_length = 1;      // [m]
inline constexpr double hang_error = 0.1;    // [m] by which the weight hangs too low
inline constexpr double ball_radius = 0.5;   // [m]
inline constexpr double swing_time = 10;     // [s]
inline constexpr double slop_tried = 0.005;  // [m]
inline constexpr double deepest_tried =
    0.4;  // [m] a ball deeper than that nearly has its middle below ground
inline constexpr int hang_steps = 12;

struct DriftSettings {
  double dt = 0.02;    // [s]
  double beta = 0.2;   // of (7)
  double depth = 0.1;  // [m] by which the ball begins inside the ground
};

/// A weight on a rod from the origin, let go at rest. Index: the step; 0 is the start.
struct RodRun {
  double beta = 0;
  List<Snapshot> steps = {};
  List<double> error = {};  // c [m]: how much too long the rod is
  double energy = 0;        // [J] at the end, above a weight at rest in the height of the pivot
  double fastest = 0;       // [m/s] across the rod, of all steps
  double gap = 0;           // [m] between c and what geometry makes of the step before; the largest
};

/// A ball of 1 kg that begins inside the ground.
struct BallRun {
  double beta = 0;
  double slop = 0;  // [m]
  List<Snapshot> steps = {};
  List<double> height = {};  // c [m] of its lowest point above the ground
  List<double> speed = {};   // [m/s] upwards
  List<double> zeta = {};    // [m/s] of the step
  List<double> lambda = {};  // [N] of the step
  double peak = 0;           // [m] the largest height
  double gap = 0;            // [m] between heights and those by hand; the largest
};

/// How deep a ball may begin without being let go in the second step.
struct DepthLimit {
  double beta = 0;
  double formula = 0;   // [m] g dt^2 / beta^2
  double measured = 0;  // [m] by bisection, with the engine
};

struct DriftRuns {
  DriftSettings settings = {};
  List<RodRun> swings = {};      // let go level with the pivot; beta 0, the reader's, 1
  List<RodRun> hangs = {};       // below the pivot, but too low; the reader's, 1, 1.8, 2.1
  List<BallRun> balls = {};      // 0.1, the reader's, 0.5, 1
  BallRun with_slop = {};        // the reader's
  List<DepthLimit> limits = {};  // of those not deeper than deepest_tried
};

/// A weight of 1 kg at `start` on a rod that should be rod_length long.
World<double> rod_world(double dt, double beta, const Vec2<double>& start);
/// A ball of 1 kg in the ground.
World<double> ball_world(const DriftSettings& settings, double slop);

/// Appends what the ball's world has come to; the start has no row yet.
void record(BallRun& run, const World<double>& world);

/// In ascending order, each once.
List<double> ascending(List<double> values);

/// For the reader's beta and some more.
List<DepthLimit> find_limits(const DriftSettings& settings);

/// The run with this beta, which must be there.
const RodRun& swing_of(const DriftRuns& all, double beta);
const BallRun& ball_of(const DriftRuns& all, double beta);

/// g dt^2 / beta^2 [m].
double limit_by_formula(double dt, double beta);
/// How high [m] a ball hops that beta = 1 has put onto the ground in one step.
double hop_by_formula(const DriftSettings& settings);

// What is printed, checked and drawn.

void print_scenes(Lesson& lesson, const DriftRuns& all);
void print_swings(Lesson& lesson, const DriftRuns& all);
void print_hangs(Lesson& lesson, const DriftRuns& all);
void print_balls(Lesson& lesson, const DriftRuns& all);
void print_limits(Lesson& lesson, const DriftRuns& all);
void check_rods(Lesson& lesson, const DriftRuns& all);
void check_balls(Lesson& lesson, const DriftRuns& all);
void check_limits(Lesson& lesson, const DriftRuns& all);
CsvTable balls_table(const DriftRuns& all);

/// Four balls, the depth that a ground can hold, and three pendulums.
List<Shot> drift_shots(const DriftRuns& all);

/// Their parts, one for each scene, in the order of drift_shots().
List<Shot> ball_shots(const DriftRuns& all);
List<Shot> swing_shots(const DriftRuns& all);

/// The step in which the ball with beta = 1 is highest.
int highest_step(const DriftRuns& all);

/// What is drawn of the balls.
struct BallLook {
  int step = 0;           // with outlines of all the steps before of those that leave the ground
  bool speeds = false;    // no outlines: what each row of the next step asks for, and what its ball has
  bool asks = false;      // how deep the ball is, and that we ask how high it comes
  bool measured = false;  // how high it is
};
/// The balls side by side, in a panel.
void draw_balls(Page& page, const Rect& rect, const DriftRuns& all, const BallLook& look);

/// "β = 0.2".
std::string beta_name(double beta);
/// Each beta has one colour and dash in all pictures.
SeriesStyle beta_style(const Theme& theme, double beta);

}  // namespace cairn::drift
