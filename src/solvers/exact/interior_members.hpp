// Floor 4. Which rows go through the interior of their bounds together.
#pragma once

#include <cairn/solvers/exact/scaled_rows.hpp>

namespace cairn {

/// One impulse p that is never negative, with its speed z.
struct InteriorSide {
  double impulse = 0;         // p
  double speed = 0;           // z
  double impulse_change = 0;  // of the direction
  double speed_change = 0;    // likewise
  double error = 0;           // of the speed, beside what the velocities say
  double product = 0;         // of changes
};

/// What a row gives, with its friction where it has some.
struct InteriorMember {
  int row = 0;              // its number
  int friction = -1;        // that of its friction; below 0: none
  int sides = 1;            // 0: without bounds
  double direction = 1;     // -1: it has an upper bound
  double bound = 0;         // or, without bounds, the impulse itself
  double ratio = 0;         // m
  double lift_slope = 0;    // d|w_t| / dw_t, smooth at 0
  InteriorSide plus = {};   // the first, and
  InteriorSide minus = {};  // the second of its impulses
  double plus_slope = 0;    // -dp / dz of the first,
  double minus_slope = 0;   // of the second,
  double mixed_slope = 0;   // and with each other
};

/// One for each row that can do anything and is no friction, in the order of rows.
/// @returns false for rows of other kinds: two bounds, discs, several normals or frictions a contact; and
/// where no row has a bound, so that there is nothing to be inside of.
bool find_interior_members(const ScaledRows<double>& rows, List<InteriorMember>& members);

}  // namespace cairn
