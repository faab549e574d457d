// The scenes that engines are compared in: one cairn::Scene for all of them.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "math/list.hpp"
#include "world/scene.hpp"

namespace cairn::bench {

/// The largest errors that the table of equal error allows.
struct Target {
  double error = 0;    // [m] overlap, or gap of joints
  double sinking = 0;  // [m] that the top may sink or rise; 0: not asked for
};

struct PeerScene {
  std::string name = {};
  std::function<Scene()> make = {};
  bool stands = false;  // it should: the tables say whether it did
  bool quick = true;    // small enough to be among those that run unless all are asked for
  std::optional<Target> target = {};
};

const List<PeerScene>& peer_scenes();

}  // namespace cairn::bench
