// Exercise 08. Give every row its own impulse to begin with. Then: bash lessons/run check 8
#include <algorithm>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise08 {

/// A row's impulse, as it was kept from the last step.
struct Kept {
  int key = 0;         // names the row from step to step
  double impulse = 0;  // [N s]
};

/// A body that moves up and down.
struct Body {
  double inverse_mass = 0;  // [1/kg]; 0: the ground
  double velocity = 0;      // [m/s] upwards
};

/// A contact: it pushes the body `above` up and the body `below` down.
struct Row {
  int key = 0;
  int below = 0;  // places in the list of bodies
  int above = 0;
  double impulse = 0;  // [N s]
};

// Lines 1 to 6 of Algorithm 1. Each row begins with what the row of its key had in `kept`, and with 0 if that
// has none; its bodies get that impulse before the first sweep. When the step changes from dt_before [s] to
// dt_now [s], the force stays, and the impulse does not.
void begin_step(List<Row>& rows, List<Body>& bodies, const List<Kept>& kept, double dt_now,
                double dt_before) {
  // Your code begins here: about eight lines.

  // Your code ends here.
}

}  // namespace cairn::exercise08
