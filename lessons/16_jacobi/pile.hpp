// A pyramid: how often a sweep may be repeated, how many are needed, and what is left of its symmetry.
#pragma once

#include "colours.hpp"
#include "feet.hpp"
#include "math/list.hpp"

namespace cairn::everybody {

struct PileSettings {
  int base = 4;        // boxes in the lowest row
  double omega = 0.3;  // of Method::damped
  int sweeps = 1500;   // in the study of one step
  int steps = 60;      // of 0.02 s, with the ball
};

/// One step of the pyramid at rest, in one method.
struct PileHistory {
  Method method = Method::plain;
  double eigenvalue = 0;       // omega times the largest of D^-1 A; 0 for Method::sequential
  List<double> residual = {};  // R_E after each sweep; the last may not be finite
  int sweeps_needed = -1;      // after which R_E stays below 1 %; -1: never
};

inline constexpr int many_sweeps = 300;
inline constexpr int few_sweeps = 10;
inline constexpr int larger_base = 10;

/// What a solver leaves of the mirror symmetry, step by step; step 0 is the start.
struct MirrorRun {
  Method method = Method::split;
  int sweeps = 10;  // a step
  List<Snapshot> frames = {};
  List<double> asymmetry = {};  // [m] how far any body is from its twin's mirror image
};

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
  double order_at_once = 0;  // what dealing the rows anew changes after 20 sweeps, over the largest impulse
  double order_in_turn = 0;  // the same for Method::sequential
  /// Under the ball: Method::split with many sweeps, Method::sequential with few, and with many.
  List<MirrorRun> mirrors = {};
};

/// A pyramid of unit boxes of 1 kg with gaps between them; with `ball_speed` [m/s] above 0 also a ball of
/// 5 kg, half a metre above its top, that falls at it.
Scene pile_scene(int base, double ball_speed);

PileRun run_pile(const PileSettings& settings);

/// For how long every row has to wait in one sweep, if each has a processor of its own.
int waits_per_sweep(const PileRun& run, const PileHistory& history);

}  // namespace cairn::everybody
