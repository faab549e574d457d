// Exercise 02. Write equation (22), times dt. Then: bash lessons/run check 2
#include <cmath>

#include "lessons/exercise.hpp"

namespace cairn::exercise02 {

/// A body that meets a fixed peg. All numbers are those of the row: j = (0, 1, arm) for a push upwards.
struct Meeting {
  double inverse_mass = 0;     // [1/kg]
  double inverse_inertia = 0;  // [1/(kg m^2)]
  double arm = 0;              // [m] of the peg, right of the centre of mass
  double speed = 0;            // [m/s] j . v1: of the point above the peg, upwards
  double wanted = 0;           // [m/s] zeta: what j . v2 has to be
  double dt = 0;               // [s]
};

// The impulse lambda dt [N s] after which the point moves as wanted: equation (22), times dt.
double impulse_of(const Meeting& meeting) {
  double impulse = std::nan("");
  // Your code begins here: one or two lines.

  // Your code ends here.
  return impulse;
}

}  // namespace cairn::exercise02
