// Exercise 20: every misconception is told from the answer.
#include "lessons/20_only_what_the_scene_needs/exercise.hpp"

#include <algorithm>

#include "exercises/wrong_answers.hpp"
#include "math/list.hpp"

namespace cairn::exercise20 {
namespace {

int with_rows_a_box(const List<Island>& islands, int rows) {
  int updates = 0;
  for (const Island& island : islands) {
    if (!island.asleep) updates += (rows * island.boxes + 2 * island.pins) * island.sweeps;
  }
  return updates;
}

int sleepers_too(const List<Island>& islands) {
  int updates = 0;
  for (const Island& island : islands) updates += (3 * island.boxes + 2 * island.pins) * island.sweeps;
  return updates;
}

int all_wait(const List<Island>& islands) {
  int rows = 0, most = 0;
  for (const Island& island : islands) {
    if (island.asleep) continue;
    rows += 3 * island.boxes + 2 * island.pins;
    most = std::max(most, island.sweeps);
  }
  return rows * most;
}

int rows_only(const List<Island>& islands) {
  int rows = 0;
  for (const Island& island : islands) rows += island.asleep ? 0 : 3 * island.boxes + 2 * island.pins;
  return rows;
}

int two_frictions(const List<Island>& islands) { return with_rows_a_box(islands, 4); }

int no_friction(const List<Island>& islands) { return with_rows_a_box(islands, 2); }

}  // namespace

TEST_CASE(
    "exercise 20 tells sleepers that pay, islands that wait, rows without sweeps and miscounted friction") {
  CHECK(testing::tells<grade>(sleepers_too, "What sleeps has no rows"));
  CHECK(testing::tells<grade>(all_wait, "Nobody waits"));
  CHECK(testing::tells<grade>(rows_only, "How often is each swept"));
  CHECK(testing::tells<grade>(two_frictions, "share one row of friction"));
  CHECK(testing::tells<grade>(no_friction, "Where is the friction"));
}

}  // namespace cairn::exercise20
