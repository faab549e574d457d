// Floor 3. What kinds of joints say of themselves, and what drives one.
#pragma once

#include <optional>

namespace cairn {

/// What a kind of joint is to those who draw it, watch it or read of it.
struct JointTraits {
  bool holds_points =
      true;              // where it is fastened, it holds: it can come apart, and carries what hangs on it
  bool is_line = false;  // a rod or a rope, between ends that are apart; else it is where they are
  bool is_over_ground = false;  // a rope whose bodies hang from the ground, and not from each other
  bool turns = false;           // its motor drives an angle
  bool slides = false;          // b goes along a line of a
  bool is_shown = true;         // where it is fastened, in pictures
  bool has_servo = false;       // a motor that goes to a place and holds it
  bool has_spring = false;      // along the coordinate that its motor would drive
  bool has_ratchet = false;     // goes one way only
  int box2d_rows = 1;           // that Box2D's joint of this kind has
};

/// What drives the coordinate of a joint: of b, seen from a.
struct JointMotor {
  double speed = 0;      // [rad/s] of an angle, [m/s] of a slide
  double max_force = 0;  // [N m] or [N], at most
  /// [rad or m] of a servo: where it goes, at `speed` at most, and stays; none: it runs at `speed` for ever
  std::optional<double> target = {};
  double rate = 10;  // [1/s] of a servo: its speed for each rad or m that is missing
};

}  // namespace cairn
