// Exercise 17. Write a step of the tower. Then: bash lessons/run check 17
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise17 {

/// Boxes that can only move up and down, from the ground up.
struct Tower {
  List<double> mass = {};      // [kg]
  List<double> velocity = {};  // [m/s] upwards
  List<double> impulse = {};   // [N s] that box i got from what is below it in the last step; at first 0
};

// One step: gravity, then the warm start, then the sweeps of SI, from the ground up. The contact of box i
// with the one below can only push. Positions are nobody's business here: ζ is 0.
void step(Tower& tower, double gravity, double dt, int sweeps) {
  List<double>& v = tower.velocity;
  const int boxes = v.size();
  // Your code begins here: about fifteen lines.

  // Your code ends here.
}

}  // namespace cairn::exercise17
