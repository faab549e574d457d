// Lesson 17. Ten boxes, one upon the other: the scene, its loads, and Box2D.
#pragma once

#include "lessons/kit/kit.hpp"

namespace cairn::tower {

struct TowerSettings {
  int boxes = 10;
  double dt = 0.02;     // [s]
  double gravity = 10;  // [m/s^2]
  int sweeps = 10;      // of each engine, in each step
  int steps = 50;
  bool warm_start = true;
};

inline constexpr int asked_step = 5;  // whose loads are asked about

using Loads = List<List<double>>;  // [step][interface] [N]; interface 0 is the ground's

/// What one engine did. Frame k is the state after k steps; frame 0 is the start.
struct EngineRun {
  std::string name = {};
  List<Snapshot> frames = {};  // steps + 1
  Loads loads = {};            // all 0 in frame 0
};

struct TowerRuns {
  TowerSettings settings = {};
  List<EngineRun> warm = {};  // PGS, SI, Box2D
  List<EngineRun> cold = {};  // the same without warm starting
  Loads warm_by_hand = {};    // and without any engine
  Loads cold_by_hand = {};
  List<EngineRun> from_top = {};  // SI and Box2D, warm, from the top down
  EngineRun one_more = {};        // SI, warm, with one sweep more in each step
};

/// Boxes of 1 kg that touch exactly. They cannot turn: the two contact points of an interface then ask for
/// the same, and an interface counts as one row, in every engine.
Scene tower_scene(const TowerSettings& settings);

/// Adds the state of a world and its loads.
void record(EngineRun& run, const Snapshot& snapshot, const TowerSettings& settings);

/// From the ground up, or from the top down.
/// @throws Skipped in a build without Box2D.
EngineRun run_box2d(const TowerSettings& settings, bool from_top = false);

/// The first step after which Box2D no longer simulates the lowest box, or -1 within `limit` steps.
int box2d_falls_asleep(const TowerSettings& settings, int limit);

/// The largest difference of any load over the first `frames` frames [N].
double largest_gap(const Loads& first, const Loads& second, int frames);
/// The first steps, until any two neighbours overlap by half a box in any of the runs. After that boxes meet
/// that are no neighbours, and it is a tower no longer.
int steps_as_tower(const List<EngineRun>& runs);
/// Of SI's loads and Box2D's, warm or cold, as long as it is a tower [N].
double gap_to_box2d(const TowerRuns& runs);
/// Of SI's loads from the ground up and Box2D's from the top down [N].
double gap_of_orders(const TowerRuns& runs);

// What is printed, checked and drawn.

/// Prints the loads and the answer, and checks every claim.
void report(Lesson& lesson, const TowerRuns& runs);

CsvTable loads_table(const TowerRuns& runs);

/// The box in the middle, counted from 0.
int middle_box(const TowerRuns& runs);

/// The question, the warm tower step by step, the cold one, and the answer.
List<Shot> tower_shots(const TowerRuns& runs);

// Boxes that turn.

/// What a stack that falls over has turned, and how far apart three solvers leave it.
struct TurningRun {
  std::string name = {};
  double turned = 0;  // [rad] the most of any box
  double apart = 0;   // [m, rad] the largest difference of a place or an angle
};
List<TurningRun> run_turning();
void print_turning(Lesson& lesson, const List<TurningRun>& runs);
void check_turning(Lesson& lesson, const List<TurningRun>& runs);

}  // namespace cairn::tower
