// Exercise 13. Visit a soft row: a spring between two bodies. Then: bash lessons/run check 13
#include "lessons/kit/exercise.hpp"
#include <cairn/math/list.hpp>

namespace cairn::exercise13 {

/// Moves up and down only.
struct Body {
  double inverse_mass = 0;  // [1/kg] 0: the ground
  double velocity = 0;      // [m/s] upwards
};

/// A spring between a body and one above it. Its row has j·v = the velocity of the one above less that of the
/// one below.
struct Spring {
  double stiffness = 0;  // k [N/m]
  double damping = 0;    // d [N s/m]
  double error = 0;      // c [m] at the beginning of the step: length less length without load
  double impulse = 0;    // [N s] that the row has given in this step so far, all visits together
};

// One visit of the row in a sweep, (22) with γ: find γ and β of the spring for steps of dt [s], then the
// impulse that this visit adds, so that j·v + γ (all of the impulse) = −β c / Δt holds afterwards. A spring
// pushes and pulls: nothing is clamped. Update the spring's impulse and both velocities.
void visit(Spring& spring, Body& below, Body& above, double dt) {
  // Your code begins here: about nine lines.

  // Your code ends here.
}

}  // namespace cairn::exercise13
