// Floor 9. The motion of what should rest.
#pragma once

#include <cairn/world/snapshot.hpp>

namespace cairn {

/// [m] How thin a body is: the shorter side of the box around its thinnest shape, in its own frame. What
/// overlaps and gaps are held against; infinite for a body of lines, or without shapes.
double thickness_of(const SnapshotBody& body);
/// [m] Of the thinnest dynamic body; infinite where there is none.
double thinnest_body(const Snapshot& snapshot);

/// Looks at the end of a run for bodies that rest: that stay within a fiftieth of their bounding radius of
/// one place from `begin` [s] on.
class Shaking {
 public:
  explicit Shaking(double begin) : begin_(begin) {}
  /// Looks at the bodies as they are after `time` [s].
  void see(const Snapshot& now, double time);
  /// [m/s] How far a body at rest goes to and fro in a second, as a point on its rim: the longest of their
  /// ways, less what they got on by; 0 where none rests.
  double speed() const;

 private:
  /// Of a body, since it was first seen.
  struct Way {
    Pose<double> first = {}, last = {};
    double radius = 0;    // [m] about the centre of mass
    double farthest = 0;  // [m] from the first pose, at its rim
    double length = 0;    // [m] gone
  };

  double begin_ = 0, first_ = 0, last_ = 0;  // [s]
  PerBody<Way> ways_ = {};
};

}  // namespace cairn
