// Exercise 11. One sweep over a block that slides on two corners. Then: bash lessons/run check 11
#include <algorithm>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise11 {

/// A block on a slope: x points downhill, y away from the slope.
struct Block {
  double inverse_mass = 0;     // [1/kg]
  double inverse_inertia = 0;  // [1/(kg m²)]
  double x_velocity = 0;       // [m/s]
  double y_velocity = 0;       // [m/s]
  double spin = 0;             // [rad/s]
};

/// One of its corners on the slope, and what the two rows of its contact have given so far.
struct Corner {
  double x = 0, y = 0;         // [m] from the centre of the block
  double normal_impulse = 0;   // [N s] along y
  double tangent_impulse = 0;  // [N s] along x
};

// One sweep: at each corner the normal row, then the friction row. A corner moves at y_velocity + x spin away
// from the slope, and at x_velocity - y spin along it. Both should be 0, as far as the two intervals allow.
void sweep(List<Corner>& corners, double friction, Block& block) {
  for (Corner& corner : corners) {
    // Your code begins here: about twelve lines.

    // Your code ends here.
  }
}

}  // namespace cairn::exercise11
