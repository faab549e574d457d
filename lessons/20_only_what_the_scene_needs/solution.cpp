// Exercise 20, answered.
#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise20 {

int row_updates(const List<Island>& islands) {
  int updates = 0;
  for (const Island& island : islands) {
    if (island.asleep) continue;
    updates += (3 * island.boxes + 2 * island.pins) * island.sweeps;
  }
  return updates;
}

}  // namespace cairn::exercise20
