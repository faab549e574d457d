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
  double speed = 45;   // [m/s] of both balls
  double beta = 2.1;   // of the pin that is pulled back too far
  double turn = 0.5;   // [rad] by which the sling turns in one step
  int steps = 60;
};

/// How a world has come through.
enum class Stamp {
  ok,      // off by 1 % at most, and without any energy from nowhere
  soft,    // by no more than its own size, and again without
  broken,  // neither
};
std::string stamp_text(Stamp stamp);

struct EdgeCase {
  std::string name = {};
  std::string quantity = {};  // what `off` is a share of
  double off = 0;             // the worst of all steps: 0 is right, 1 as far as the thing is large
  double energy_gain = 0;     // of the energy that the scene has to spend
  Stamp stamp = Stamp::ok;
  List<Snapshot> frames = {};  // one for each step, the start first
  List<double> off_by_step = {};
  Aabb<double> view = {};  // [m] what is shown of it
  double top = 0;          // [m] where its upper side belongs; 0: it is no stack
};

/// By `off` and `energy_gain`.
Stamp stamp_of(const EdgeCase& edge);

/// A scene, and what is measured of it.
struct SmallWorld {
  EdgeCase edge = {};
  Scene scene = Scene();
  double budget = 0;  // [J] the energy that it has to spend; infinite where errors in positions bring some
  std::function<double(const Snapshot&)> off = {};
};

/// In this order: heavy on light, light on heavy, the tower, a ball shot at a wall, one marked as fast, the
/// pin, the sling, two pins that contradict each other.
List<SmallWorld> small_worlds(const WallSettings& settings);

inline constexpr int ball = 3, fast_ball = 4, pin = 5, sling = 6, two_pins = 7;
inline constexpr double ball_radius = 0.5;  // [m]
inline constexpr double pin_error = 0.05;   // [m] at the start
inline constexpr double pins_apart = 0.4;   // [m]
inline constexpr double pins_beta = 0.2;

/// One body, pinned in the middle to two places. It stands where the second pin wants it.
Scene two_pins_scene();
/// What the first row of the two pins has given after each step [N].
List<double> quarrel(const EdgeCase& pins);
/// By formula: in every sweep it gives m beta d / dt more, which the other takes back.
double quarrel_by_formula(const WallSettings& settings, int step);

}  // namespace cairn::edges
