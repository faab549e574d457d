// Floor 5. What is done to a body for a while: it never is over and done, but holds from its time on.
#pragma once

#include <limits>

#include <cairn/dynamics/body.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Pulls at a body with a force and a torque. A substep that it begins or ends in has its share of both.
struct ApplyForce {
  BodyId body = {};             // a dynamic one
  Vec2<double> force = {0, 0};  // [N]
  double torque = 0;            // [N m]
  Vec2<double> point = {0, 0};  // [m] where it pulls, in the frame of the centre of mass
  bool turns = false;           // the force turns with the body, as that of an engine does
  double seconds = std::numeric_limits<double>::infinity();  // [s] for so long

  /// The force [N] in the world on a body that stands so.
  Vec2<double> in_world(const Rotation<double>& rotation) const { return turns ? rotation * force : force; }
};

/// How a path goes on at its end.
enum class PathKind {
  once,        // it ends there
  to_and_fro,  // back the same way, and so on
  round,       // straight to its beginning, and so on
};

/// Takes a kinematic body along straight lines from point to point, at one speed. Until its time, or the
/// touch that it waits for, the body stays at the first point. Contacts see the velocity with which it goes.
struct FollowPath {
  BodyId body = {};                // a kinematic one
  List<Vec2<double>> points = {};  // [m] of the centre of mass: two or more
  double speed = 1;                // [m/s]
  PathKind kind = PathKind::once;  // at its end

  /// [m] Of the whole way, until it begins anew.
  double length() const;
  /// [m] Where the body is so long [s] after it began.
  Vec2<double> place(double seconds) const;
};

}  // namespace cairn
