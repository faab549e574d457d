// Exercise 15. Brake a puck by two rows that share a disc. Then: bash lessons/run check 15
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise15 {

/// Seen from above.
struct Puck {
  double mass = 0;  // [kg]
  double vx = 0;    // [m/s]
  double vy = 0;
};

/// The two friction rows of its contact: the first acts along (ax, ay), the second along (-ay, ax).
struct Rows {
  double ax = 1, ay = 0;  // of length 1
  double first = 0;       // [N s] what each has given so far
  double second = 0;
};

// One sweep. The first row stops the puck in its direction, within -limit .. limit [N s], which is μ λ_n Δt.
// The second has what the first leaves of the disc: first² + second² is at most limit². Both clamp what they
// have given in all.
void sweep(Rows& rows, double limit, Puck& puck) {
  // Your code begins here: about twelve lines.

  // Your code ends here.
}

}  // namespace cairn::exercise15
