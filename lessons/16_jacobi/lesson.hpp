// Lesson 16. A box on feet, which share one body: what happens when all of them correct the same error at
// once.
#pragma once

#include "lessons/kit/kit.hpp"

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

// The contacts of a pyramid in colours: those of one colour share no box, and may be solved at the same time.

/// Two boxes that touch, or a box and the ground: one manifold.
struct ColouredContact {
  BodyId a = {};
  BodyId b = {};
  int colour = 0;  // from 0
};

struct Colouring {
  List<ColouredContact> contacts = {};  // in the order of the rows
  List<int> count = {};                 // contacts of each colour
  int most_on_a_box = 0;                // no fewer colours will ever do
};

/// Greedy: each contact takes the first colour that is free at both of its boxes.
Colouring colour_contacts(const VelocityProblem<double>& problem);

/// How many pairs of contacts of one colour share a box that can move: 0, if the colours are right.
int clashes(const VelocityProblem<double>& problem, const Colouring& colouring);

/// "6 + 4 + 4 + 2".
std::string counts_text(const Colouring& colouring);

// A pyramid: how often a sweep may be repeated, and how many are needed.

struct PileSettings {
  int base = 4;        // boxes in the lowest row
  double omega = 0.3;  // of Method::damped
  int sweeps = 1500;   // of the one step
};

/// One step of the pyramid at rest, in one method.
struct PileHistory {
  Method method = Method::plain;
  double eigenvalue = 0;       // omega times the largest of D^-1 A; 0 for Method::sequential
  List<double> residual = {};  // R_E after each sweep; the last may not be finite
  int sweeps_needed = -1;      // after which R_E stays below 1 %; -1: never
};

/// Damped Jacobi with another share, and how many sweeps it needs.
struct TunedJacobi {
  double omega = 0;
  int sweeps_needed = -1;
};

inline constexpr int larger_base = 10;

struct PileRun {
  PileSettings settings = {};
  VelocityProblem<double> problem = {};  // of the first step, without a ball
  Snapshot snapshot = {};                // with its contacts
  double largest_eigenvalue = 0;         // of D^-1 A, D the diagonal of A
  int colours = 0;                       // of the rows, as the solver gives them
  Colouring contacts = {};               // of this pyramid
  Colouring larger = {};                 // of one with larger_base boxes at the bottom
  PerBody<int> rows_on_box = {};         // the numbers n of Splitting::mass
  List<PileHistory> histories = {};      // in the order of all_methods
  PileHistory coloured = {};             // sequential, colour by colour
  TunedJacobi tuned = {};                // with the share that needs the fewest sweeps
  TunedJacobi with_momentum = {};        // with 1 / largest_eigenvalue, which is safe, and momentum
  List<double> momentum_residual = {};   // R_E after each of its sweeps
  double order_at_once = 0;  // what dealing the rows anew changes after 20 sweeps, over the largest impulse
  double order_in_turn = 0;  // the same for Method::sequential
};

/// A pyramid of unit boxes of 1 kg with gaps between them.
Scene pile_scene(int base);

PileRun run_pile(const PileSettings& settings);

/// Damped Jacobi, each sweep begun from where the last two sweeps point: R_E after each, until it is far
/// below the goal, or after `most`.
List<double> residuals_with_momentum(const VelocityProblem<double>& start, double omega, int most);

/// One after the other, in a sweep, if each row has a processor of its own.
int turns_per_sweep(const PileRun& run, const PileHistory& history);

/// Ten sweeps over a pyramid, colour by colour.
struct ThreadedSweeps {
  int rows = 0;
  int colours = 0;    // after each of which threads wait for each other
  double one = 0;     // [ns] of a row update on one thread
  double two = 0;     // [ns] on two
  double lanes = 0;   // [ns] in the lanes of one, which take 16 blocks at a time
  double change = 0;  // [N s] of the impulses between one thread and two
};

/// A small pyramid and a large one.
List<ThreadedSweeps> run_threads();
void print_threads(Lesson& lesson, const List<ThreadedSweeps>& all);
void check_threads(Lesson& lesson, const List<ThreadedSweeps>& all);

// What is printed, checked and drawn.

/// Prints both scenes and the answer, and checks every claim.
void report(Lesson& lesson, const FeetRun& feet, const PileRun& pile);

CsvTable sweeps_table(const FeetRun& feet, const PileRun& pile);

/// The feet, sweep by sweep, and the pyramid.
List<Shot> everybody_shots(const FeetRun& feet, const PileRun& pile);

/// Those of the pyramid.
List<Shot> pile_shots(const PileRun& pile);

/// "Jacobi", "Jacobi, ω = 0.3", "Jacobi, split", "SI".
std::string method_name(Method method, double omega);

/// Its line in every chart of the lesson.
SeriesStyle style_of(const Theme& theme, Method method);

}  // namespace cairn::everybody
