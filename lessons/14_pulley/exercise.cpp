// Exercise 14. Write the row of a pair of gears. Then: bash lessons/run check 14
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise14 {

// j v = j_a omega_a + j_b omega_b is 0 where the teeth of both wheels move along together, and the wheels
// mesh from outside. Returns (j_a, j_b); any length will do.
FixedList<double, 2> gear_row(double teeth_a, double teeth_b) {
  (void)teeth_a, (void)teeth_b;
  return {std::nan(""), std::nan("")};  // <- your code
}

}  // namespace cairn::exercise14
