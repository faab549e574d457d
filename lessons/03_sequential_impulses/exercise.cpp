// Exercise 03. Sweep over wheels until their rims slip no more. Then: bash lessons/run check 3
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise03 {

/// A wheel on a fixed axle. Its rim touches that of the next wheel in the list.
struct Wheel {
  double radius = 0;           // [m]
  double inverse_inertia = 0;  // [1/(kg m²)]; 0: held fast, and so is no wheel beside it
  double spin = 0;             // [rad/s], counterclockwise
};

// Where two wheels a and b touch, the slip of their rims is j·v = r_a ω_a + r_b ω_b, and 0 is wanted. Sweep
// over the pairs from the first to the last. Stop when no pair slips faster than `limit` [m/s], in either
// direction, or when there have been `most` sweeps. Returns how many there have been.
int sweeps_until(List<Wheel>& wheels, double limit, int most) {
  int sweeps = 0;
  // Your code begins here: some fifteen lines.

  // Your code ends here.
  return sweeps;
}

}  // namespace cairn::exercise03
