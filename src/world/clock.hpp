// Floor 5. When a world is.
#pragma once

namespace cairn {

/// Since the start of a world.
struct Clock {
  double time = 0;  // [s] that has passed
  int steps = 0;    // that were taken
  double dt = 0;    // [s] of the next step
};

}  // namespace cairn
