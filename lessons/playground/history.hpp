// What the bodies and the pairs of bodies of a world did, step by step, for a plot.
#pragma once

#include <deque>
#include <utility>

#include <cairn/math/list.hpp>
#include <cairn/world/snapshot.hpp>

namespace cairn::playground {

/// The steps that can be taken back. Every step is kept, however many there are between two pictures.
class History {
 public:
  /// A history of at most so many steps.
  explicit History(int most_steps) : most_steps_(most_steps) {}

  /// The world at one of its steps. What was kept of that step and of later ones goes.
  void keep(const Snapshot& snapshot);
  /// Shows no step after this one, until the next is kept.
  void show(int last_step);
  /// Steps that are shown.
  int size() const { return shown_; }
  /// Of each, the oldest first: time [s], height of the centre of mass [m], speed [m/s], angular velocity
  /// [rad/s]. NaN where the body was not there.
  List<double> of_body(BodyId body) const;
  /// Of each, the oldest first: time [s], and the size of the force of contacts and joints between them [N],
  /// the mean over the step's last substep.
  List<double> of_pair(BodyId a, BodyId b) const;

 private:
  struct BodyMoment {
    double y = 0, speed = 0, omega = 0;
    bool is_there = false;
  };
  struct Push {
    std::pair<BodyId, BodyId> pair = {};
    Vec2<double> force = {0, 0};  // [N] on the second one
  };
  struct Moment {
    int step = 0;
    double time = 0;
    PerBody<BodyMoment> bodies = {};
    List<Push> pushes = {};
  };

  int most_steps_;
  int shown_ = 0;
  std::deque<Moment> moments_;
};

}  // namespace cairn::playground
