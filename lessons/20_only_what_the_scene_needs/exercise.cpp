// Exercise 20. What does a step cost? Then: bash lessons/run check 20
#include <algorithm>

#include "lessons/exercise.hpp"

namespace cairn::exercise20 {

/// Things that touch or hold each other.
struct Island {
  int boxes = 0;   // that stand on each other or on the ground, each on one manifold of two points
  int pins = 0;    // two rows each
  int sweeps = 0;  // after which the errors of the island are small enough
  bool asleep = false;
};

// The row updates of a step that does only what it has to. A manifold has a normal row for each of its two
// points, and one friction row for both. What sleeps has no rows, and each island stops on its own.
int row_updates(const List<Island>& islands) {
  int updates = 0;
  // Your code begins here: about four lines.

  // Your code ends here.
  return updates;
}

}  // namespace cairn::exercise20
