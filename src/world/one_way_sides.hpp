// Floor 5. What came to a one-way body from its outer side, and so is held off.
#pragma once

#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// A shape of a one-way body and another body are in a search for contacts either outside of each other, as
/// seen along the direction of the shape, or not. The shape holds off what is outside. It goes on to hold off
/// what it held in the search before as long as the two overlap, however deep that is; everything else
/// passes.
class OneWaySides {
 public:
  /// Of a shape and one of another body: whether that lies outside, and whether they overlap.
  struct Sight {
    int shape = 0;          // the number of the one-way one
    BodyId other = {};      // whose shape is near to it
    bool outside = true;    // with all of its shapes, once sights are put together
    bool overlaps = false;  // with some of them
  };

  /// Nothing is near in this search yet.
  void begin() { sights_.clear(); }
  /// Two shapes that are near.
  void see(const Sight& sight) { sights_.push_back(sight); }
  /// All have been seen: who is held off from now on.
  void end();

  /// Whether the shape holds the body off.
  bool holds(int shape, BodyId other) const;

  /// As ContactCache.
  void begin_step() { first_held_ = held_; }
  /// As ContactCache.
  void leave_step() { held_ = first_held_; }
  /// Takes over who was held off in a world that was edited: `numbers` has the number now of each shape, or
  /// -1.
  void carry_over(const OneWaySides& before, Span<const int> numbers);

 private:
  struct Held {
    int shape = 0;
    BodyId other = {};
    auto operator<=>(const Held&) const = default;
  };

  List<Held> held_;        // sorted
  List<Held> first_held_;  // when the step began
  List<Sight> sights_;     // scratch
};

}  // namespace cairn
