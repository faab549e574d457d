// Exercise 02. One push between two bodies: its size, and what it changes. Then: bash lessons/run check 2
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise02 {

struct Body {
  double x = 0, y = 0;         // [m] its centre of mass
  double inverse_mass = 0;     // [1/kg] 0: it is fixed
  double inverse_inertia = 0;  // [1/(kg m²)]
  double vx = 0, vy = 0;       // [m/s]
  double spin = 0;             // [rad/s] counterclockwise
};

/// Where two bodies touch.
struct Contact {
  double x = 0, y = 0;    // [m]
  double nx = 0, ny = 0;  // of length 1, from the first body to the second
  double wanted = 0;      // [m/s] ζ: how fast their points have to part afterwards
};

// The impulse λ Δt [N s] that makes the points of both part as wanted, (22) times Δt. It acts along n on the
// second body and against n on the first, and changes all their velocities, (19) and (21).
double push(Body& first, Body& second, const Contact& contact) {
  double impulse = std::nan("");
  // Your code begins here: about twelve lines.

  // Your code ends here.
  return impulse;
}

}  // namespace cairn::exercise02
