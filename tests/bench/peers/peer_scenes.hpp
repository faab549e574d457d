// The scenes that engines are compared in: one cairn::Scene for all of them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/world/scene.hpp>

namespace cairn::bench {

/// The largest errors that the table of equal error allows.
struct Target {
  double error = 0;    // [m] overlap, or gap of joints
  double sinking = 0;  // [m] that the top may sink or rise; 0: not asked for
};

struct PeerScene {
  std::string name = {};
  std::string about = {};  // what it is, as the tables say it
  std::function<Scene()> make = {};
  bool stands = false;  // it should: the tables say whether it did
  int loose = 0;        // bodies at its end that do not stand, where all others should
  bool quick = true;    // small enough to be among those that run unless all are asked for
  int steps = 0;        // at most; 0: as many as all others
  std::optional<Target> target = {};
  /// Whether a place is where no body can come to, unless it went through a wall. Empty: there are no walls.
  std::function<bool(const Vec2<double>&)> outside = {};
};

const List<PeerScene>& peer_scenes();

// Parts of the list, and what they share.

/// Those of Box2D 3's benchmark that move.
List<PeerScene> benchmark_scenes();
/// Those that mix: a pyramid beside something far away, and a block that falls.
List<PeerScene> mixed_scenes();
/// Boxes of 1 m that touch, on the ground, in rows of base, base - 1, ..., 1.
Scene pyramid(int base);

}  // namespace cairn::bench
