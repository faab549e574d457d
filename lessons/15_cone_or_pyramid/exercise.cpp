// Exercise 15. Brake a puck: clamp a vector, not its parts. Then: bash lessons/run check 15
#include <algorithm>
#include <cmath>

#include "lessons/exercise.hpp"

namespace cairn::exercise15 {

/// Seen from above.
struct Puck {
  double mass = 0;  // [kg]
  double vx = 0;    // [m/s]
  double vy = 0;
};

// One step of friction, for both rows at once. Find the impulse that would stop the puck, (22) times Δt. Its
// length may be μNΔt at most; its direction stays. Then apply it.
void brake(Puck& puck, double normal_force, double friction, double dt) {
  // Your code begins here: about six lines.

  // Your code ends here.
}

}  // namespace cairn::exercise15
