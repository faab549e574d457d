// Lesson 12. Three scenes, each solved row by row and block by block: a rod on a pin, chains, and a bob that
// hardly resists turning.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::blocks {

struct BlocksSettings {
  double dt = 0.02;          // [s]
  double angle = 45;         // [degrees] of the rod above the horizontal
  double inertia = 1e-6;     // [kg m^2] of the bob
  int sweeps = 5;            // a step, for the bob
  double pin_seconds = 10;   // [s] that the bob is followed
  double start_angle = 0.5;  // [rad] from which the bob is let go
};

inline constexpr double gravity = 10;     // [m/s^2]
inline constexpr double rod_length = 2;   // [m], of 1 kg
inline constexpr double rod_weight = 10;  // [N] which its pin carries when the sweeps begin
inline constexpr double beam_length = 1;  // [m], of 1 kg
inline constexpr double beam_height = 0.2;

using Pair = FixedList<double, 2>;

/// One of the two rows of the pin at work.
struct RodUpdate {
  int sweep = 0;
  int row = 0;
  double jv = 0;               // [m/s] before
  double corrective = 0;       // [N]
  Pair before = {0, 0};        // lambda [N]
  Pair after = {0, 0};         // lambda [N]
  Vec2<double> slip = {0, 0};  // [m/s] velocity of the pinned end afterwards: what the pin forbids
};

/// The pin of a rod, solved.
struct RodRun {
  Snapshot start = {};
  SystemMatrices<double> system = {};
  Pair formula = {0, 0};         // lambda from Newton's law of the turning rod [N]
  double rate = 0;               // A_12^2 / (A_11 A_22)
  List<RodUpdate> updates = {};  // six sweeps row by row
  List<Pair> by_rows = {};       // lambda after each sweep [N]; 0: the start
  List<Pair> by_block = {};
};

/// One solver on one chain.
struct ChainSolve {
  List<double> error = {};  // max |lambda - exact| / max |exact| after each sweep, until the goal
  int sweeps = 0;           // to the goal
  int by_energy = -1;       // until sqrt(e^T A e), e = lambda - exact, is at the goal; -1: not before
  long long work = 0;       // multiply-adds to the goal
};

/// The beams, and others to compare them with.
struct ChainRun {
  std::string name = {};
  int dense_sweeps = -1;  // by Gauss-Seidel on A lambda = b with a dense A; -1: not for ten beams
  int dense_block_sweeps = -1;
  Snapshot start = {};
  VelocityProblem<double> problem = {};
  Matrix<double> A = {};
  ChainSolve rows = {};
  ChainSolve blocks = {};
};

/// How many of the sweeps by rows are left with blocks [%].
inline double share_left(const ChainRun& chain) { return 100.0 * chain.blocks.sweeps / chain.rows.sweeps; }

/// The bob: one solver.
struct BobRun {
  List<Vec2<double>> path = {};  // [m] of the bob, after each step; 0: the start
  List<double> energy = {};      // [J], 0 at rest at the height of the pin
  double largest_energy = 0;     // [J]
  double largest_stretch = 0;    // [m] by which it left the circle around the pin
};

struct BlocksRuns {
  BlocksSettings settings = {};
  RodRun rod = {};
  List<ChainRun> chains = {};
  Matrix<double> bob_A = {};  // of its pin, where it is let go
  double bob_rate = 0;        // A_12^2 / (A_11 A_22)
  BobRun bob_rows = {};
  BobRun bob_block = {};
  Snapshot last = {};  // of the bob with the block
};

inline constexpr int most_sweeps = 4000;  // before a solver gives up
inline constexpr double goal = 0.01;      // error at which a chain counts as solved
inline constexpr int welded_one = 0;      // in BlocksRuns::chains
inline constexpr int welded_two = 1;
inline constexpr int welded_three = 2;
inline constexpr int welded_ten = 5;  // needs more sweeps than the others

BlocksRuns run_blocks(const BlocksSettings& settings);

// The parts that run_blocks() puts together; those that the lesson is about stand in lesson.cpp.

/// Gauss-Seidel on A lambda = b: one row at a time (size 1), or the `size` rows of a joint together. Sweeps
/// to the goal.
int sweeps_by_hand(const SystemMatrices<double>& system, const Vector<double>& exact, int size);
RodRun run_rod(const BlocksSettings& settings);
World<double> bob_world(const BlocksSettings& settings);
BobRun run_bob(const BlocksSettings& settings, Solver<double>& solver, Snapshot& last);

/// lambda after each sweep [N] of two rows.
List<Pair> pairs_of(const SweepRecorder<double>& recorder, double dt);
/// Every update of the two rows.
void record_rows(const SweepRecorder<double>& recorder, const VelocityProblem<double>& problem, RodRun& run);
/// What Newton's law and the theory of Gauss-Seidel say of the rod.
void add_formulas(const BlocksSettings& settings, RodRun& run);

/// The largest energy [J] and stretch [m] that a step of dt allows the bob, and by how much the energy sways
/// [J] where nothing is lost.
double energy_sway(const BlocksSettings& settings);
double energy_bound(const BlocksSettings& settings);
double stretch_bound(const BlocksSettings& settings);

// What is printed, checked and drawn.

BlocksSettings settings_of(const Lesson& lesson);

void print_scene(Lesson& lesson, const BlocksSettings& settings);
void print_runs(Lesson& lesson, const BlocksRuns& all);
void check_runs(Lesson& lesson, const BlocksRuns& all);

/// Products that j·v takes, row by row and where the rows share the velocity of their point.
struct SharedWork {
  int weld_rows = 0, weld_block = 0;
  int contact_rows = 0, contact_shared = 0;  // a normal and its friction, in the plane
  int space_rows = 0, space_shared = 0;      // a normal and two friction rows, in space
  double gap = 0;                            // [m/s] between the two ways
};

/// What a block saves in ten sweeps over three welds.
struct Savings {
  int row_updates = 0;  // of the velocities of two bodies
  int block_updates = 0;
  int inverses_once = 0;  // of 3 x 3 matrices, once a step
  int inverses_again = 0;
  double change = 0;       // [N s] of the impulses, inverted once or in each sweep
  double library_gap = 0;  // [N s] of the impulses, against the library's blocks
  double time_ratio = 0;   // of a sweep over ten welds as blocks, to one row by row; on this machine
  SharedWork shared = {};
};

SharedWork count_shared();
void print_shared(Lesson& lesson, const SharedWork& work);
void check_shared(Lesson& lesson, const SharedWork& work);

Savings count_savings(const BlocksRuns& all);
void print_savings(Lesson& lesson, const BlocksRuns& all, const Savings& savings);
void check_savings(Lesson& lesson, const BlocksRuns& all, const Savings& savings);
CsvTable sweeps_table(const BlocksRuns& all);

/// The question, every row update of the rod, the chain, every step of the bob.
List<Shot> blocks_shots(const BlocksRuns& all);

/// The chain of three welded beams: its errors, and its A.
List<Shot> chain_shots(const BlocksRuns& all);
/// The frames of the bob.
List<Shot> bob_shots(const BlocksRuns& all);

/// A chain before the first sweep.
void draw_start(Page& page, const Rect& rect, const ChainRun& chain);
/// The sweeps of one, two, three and ten beams with blocks, as a part of those by rows; the question has one
/// beam, and ten without their answer.
void draw_sweep_bars(Page& page, const Rect& rect, const BlocksRuns& all, bool asked);

/// Rows grey and dashed, blocks solid in the colour of sequential impulses.
SeriesStyle style_of_rows(const Page& page);
SeriesStyle style_of_blocks(const Page& page);

}  // namespace cairn::blocks
