// Exercise 21. Write the masses that keep a chain together. Then: bash lessons/run check 21
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise21 {

// Bead i hangs on rod i and carries rod i + 1: there is one rod more than beads. Neighbours that swing
// against each other stretch each of these springs twice. Give each bead the least mass with which even this
// swing has ω Δt <= 2, and never less than it has.
//   force   [N]  with which each rod pulls
//   length  [m]  of each rod
//   mass    [kg] of each bead: yours to change
void raise_masses(const List<double>& force, const List<double>& length, List<double>& mass, double dt) {
  // Your code begins here: about four lines.

  // Your code ends here.
}

}  // namespace cairn::exercise21
