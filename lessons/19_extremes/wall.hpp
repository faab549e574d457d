// Eight small worlds, each driven to where it breaks or does not, and a stamp for each.
#pragma once

#include <functional>
#include <string>

#include "cairn.hpp"
#include "math/list.hpp"

namespace cairn::edges {

struct WallSettings {
  double ratio = 100;  // of the heavy box
  int sweeps = 10;     // of SI, in every step of every world
  int boxes = 50;      // in the tower
  double speed = 45;   // [m/s] of a ball; another is ten times as fast
  double beta = 2.1;   // of the pin that is pulled back too far
  double turn = 0.5;   // [rad] by which the sling turns in one step
  int steps = 60;
};

/// How a world has come through.
enum class Stamp {
  ok,       // off by 1 % at most, and at most 1 % of energy from nowhere
  soft,     // off by no more than its own size, and as little energy
  growing,  // the same, but a joint pulls harder and harder: nothing of it is to be seen
  broken,   // none of these
};
std::string stamp_text(Stamp stamp);

struct EdgeCase {
  std::string name = {};
  std::string quantity = {};         // what `off` is a share of
  List<Snapshot> frames = {};        // one for each step, the start first
  List<double> off_by_step = {};     // 0 is right, 1 as far as the thing is large
  List<double> energy_by_step = {};  // more than at the start, as a share of what the scene has to spend
  Aabb<double> view = {};            // [m] what is shown of it
  double top = 0;                    // [m] where its upper side belongs; 0: it is no stack
};

/// The largest of all steps so far.
double worst(const List<double>& by_step, int step);
/// What the first joint gives in a step [N]; 0 if there is none.
double pull_of(const EdgeCase& edge, int step);
/// By the steps so far.
Stamp stamp_of(const EdgeCase& edge, int step);

/// A scene, and what is measured of it.
struct SmallWorld {
  EdgeCase edge = {};
  Scene scene = Scene();
  double budget = 0;  // [J] the energy that it has to spend; infinite where errors in positions bring some
  std::function<double(const Snapshot&)> off = {};
};

/// In this order: heavy on light, light on heavy, the tower, a ball shot at a wall, one ten times as fast,
/// the pin, the sling, two pins that contradict each other.
List<SmallWorld> small_worlds(const WallSettings& settings);

inline constexpr int ball = 3, fast_ball = 4, pin = 5, sling = 6, two_pins = 7;
inline constexpr double ball_radius = 0.5;  // [m]
inline constexpr double pin_error = 0.05;   // [m] at the start
inline constexpr double pins_apart = 0.4;   // [m]
inline constexpr double pins_beta = 0.2;

/// One body, pinned in the middle to two places. It stands where the second pin wants it.
Scene two_pins_scene();
/// What each of the two pins pulls with after a step [N], by formula: in every sweep one gives m beta d / dt
/// more, which the other takes back.
double quarrel_by_formula(const WallSettings& settings, int step);

}  // namespace cairn::edges
