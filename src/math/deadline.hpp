// Floor 0. Giving a long computation up.
#pragma once

#include <chrono>
#include <stdexcept>

namespace cairn {

/// A computation went on for longer than its Deadline allows, and was given up.
struct TimeUp : std::runtime_error {
  /// "stopped when its time was up"
  TimeUp();
};

/// While it lives, what this thread computes ends with TimeUp once its time is up: a substep, a sweep, a
/// pivot, a linear system or a mode of the contacts is not begun later. For those who cannot wait, as a page
/// with one thread; without one nothing is given up. A step that is given up is not done (World::step). Of
/// one inside another the earlier holds. Which computations are given up depends on the machine; the bits of
/// those that end do not.
class Deadline {
 public:
  /// [s] from now; 0: none, but for the one outside.
  explicit Deadline(double seconds);
  ~Deadline();
  Deadline(const Deadline&) = delete;
  Deadline& operator=(const Deadline&) = delete;

  /// For what takes long: asked before each piece of the work. @throws TimeUp
  static void go_on();

 private:
  using Clock = std::chrono::steady_clock;

  static thread_local Clock::time_point end_;  // of the innermost one; Clock::time_point::max(): none

  Clock::time_point outside_;  // the end that holds without this one
};

}  // namespace cairn
