// Floor 9. Motions whose end a formula knows: for measuring what a setting costs and misses.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <cairn/world/scene.hpp>
#include <cairn/world/snapshot.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Watches a run, and says at its end how far it was from the formula.
class MotionError {
 public:
  virtual ~MotionError() = default;
  virtual void see(const Snapshot& snapshot) = 0;
  /// Of the size that the formula gives, so that 0.01 is one per cent.
  virtual double value() const = 0;
};

struct AnsweredScene {
  std::string name = {};
  std::string what = {};     // the number that is compared: "angle after one period"
  std::string formula = {};  // and where it comes from
  double seconds = 1;        // [s] of the run
  std::function<Scene()> make = {};
  std::function<std::unique_ptr<MotionError>()> watch = {};
};

/// All of them. Of rods, pins, boxes and discs, but for the puck seen from above: Box2D can run the others.
const List<AnsweredScene>& answered_scenes();

}  // namespace cairn
