// Exercise NN. Write equation (22), times Δt. Then: bash lessons/run check NUMBER
#include "lessons/exercise.hpp"

namespace cairn::exerciseNN {

/// The impulse [N s] that stops a ball of this mass [kg] that comes down at this speed [m/s].
double impulse_of(double mass, double speed) {
  double impulse = 0;
  // Your code begins here: one line.

  // Your code ends here.
  return impulse;
}

}  // namespace cairn::exerciseNN
