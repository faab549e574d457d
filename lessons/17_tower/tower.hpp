// Ten boxes, one upon the other, under three engines: the scene, the runs and their loads.
#pragma once

#include <string>
#include <vector>

#include "cairn.hpp"

namespace cairn::tower {

struct TowerSettings {
  int boxes = 10;
  double dt = 0.02;     // [s]
  double gravity = 10;  // [m/s^2]
  int sweeps = 10;      // of each engine, in each step
  int steps = 50;
  bool warm_start = true;
};

/// What one engine did. Frame k is the state after k steps; frame 0 is the start.
struct EngineRun {
  std::string name = {};
  std::vector<Snapshot> frames = {};  // steps + 1
  std::vector<std::vector<double>> loads =
      {};  // [frame][interface] [N]; interface 0 is the ground's; 0 in frame 0
};

/// Boxes of 1 kg that touch exactly. They cannot turn: the two contact points of an interface then ask for
/// the same, and an interface counts as one row, in every engine.
Scene tower_scene(const TowerSettings& settings);

EngineRun run_pgs(const TowerSettings& settings);
EngineRun run_si(const TowerSettings& settings);
/// @throws Skipped in a build without Box2D.
EngineRun run_box2d(const TowerSettings& settings);

/// The first step after which Box2D no longer simulates the lowest box, or -1 within `limit` steps.
int box2d_falls_asleep(const TowerSettings& settings, int limit);

/// The same tower written out by hand: masses on a line, Gauss-Seidel from the ground up, no engine at all.
/// loads[k][i] [N] after k steps.
std::vector<std::vector<double>> loads_by_hand(const TowerSettings& settings);

/// The largest difference of any load over the first `frames` frames [N].
double largest_gap(const std::vector<std::vector<double>>& first,
                   const std::vector<std::vector<double>>& second, int frames);

}  // namespace cairn::tower
