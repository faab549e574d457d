// Exercise 20, graded: bills written out row by row.
#include <algorithm>
#include <string>

#include "exercise.cpp"

namespace cairn::exercise20 {
namespace {

/// Who pays for how many rows, and how often.
struct Tariff {
  int rows_a_box = 3;
  int rows_a_pin = 2;
  bool sleepers_pay = false;
  bool awake_pay = true;
  bool all_wait = false;  // for the island that needs the most sweeps
  bool once = false;      // one sweep only
  bool last_only = false;
};

int bill(const List<Island>& islands, const Tariff& tariff) {
  int most = 0, updates = 0;
  for (const Island& island : islands) {
    if (!island.asleep || tariff.sleepers_pay) most = std::max(most, island.sweeps);
  }
  for (const Island& island : islands) {
    if (island.asleep ? !tariff.sleepers_pay : !tariff.awake_pay) continue;
    if (tariff.last_only) updates = 0;
    const int sweeps = tariff.once ? 1 : tariff.all_wait ? most : island.sweeps;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (int box = 0; box < island.boxes; ++box) updates += tariff.rows_a_box;
      for (int pin = 0; pin < island.pins; ++pin) updates += tariff.rows_a_pin;
    }
  }
  return updates;
}

ExpectedNumber expected(const std::string& what, const List<Island>& islands) {
  return {.what = what + ": row updates",
          .value = static_cast<double>(bill(islands, {})),
          .tolerance = 0,
          .misconceptions = {
              {static_cast<double>(bill(islands, {.sleepers_pay = true})), "What sleeps has no rows."},
              {static_cast<double>(bill(islands, {.all_wait = true})),
               "Nobody waits for the slowest island: each stops on its own."},
              {static_cast<double>(bill(islands, {.once = true})),
               "Those are the rows. How often is each swept?"},
              {static_cast<double>(bill(islands, {.rows_a_box = 4})),
               "Two points share one row of friction: three rows a manifold, not four."},
              {static_cast<double>(bill(islands, {.rows_a_box = 2})), "Where is the friction?"},
              {static_cast<double>(bill(islands, {.rows_a_pin = 1})),
               "A pin has two rows, one for each direction."},
              {static_cast<double>(bill(islands, {.rows_a_pin = 0})), "The pins of a chain have rows, too."},
              {static_cast<double>(bill(islands, {.rows_a_box = 0})),
               "Each box stands on a manifold of three rows."},
              {static_cast<double>(bill(islands, {.last_only = true})),
               "Add the islands up: a step pays for all."},
              {static_cast<double>(bill(islands, {.sleepers_pay = true, .awake_pay = false})),
               "Only those that are awake have rows, not those that sleep."}}};
}

void grade_all(Grade& grade) {
  const List<Island> scene = {{.boxes = 15, .sweeps = 12, .asleep = false},
                              {.boxes = 10, .sweeps = 60, .asleep = true},
                              {.pins = 5, .sweeps = 40}};
  grade.number(expected("pyramid awake, tower asleep, chain", scene), row_updates(scene));
  const List<Island> towers = {{.boxes = 10, .sweeps = 30}, {.boxes = 3, .pins = 1, .sweeps = 7}};
  grade.number(expected("two towers", towers), row_updates(towers));
  const List<Island> night = {{.boxes = 100, .sweeps = 50, .asleep = true}};
  grade.number(expected("all asleep", night), row_updates(night));
}

}  // namespace

Exercise exercise() {
  return {.lesson = 20,
          .task = "The row updates of a step that does only what it has to.",
          .file = "lessons/20_only_what_the_scene_needs/exercise.cpp",
          .hints = {"An island costs its rows times its sweeps. Which islands have rows at all?",
                    "A manifold of two points: two normals and one friction. A pin: two.",
                    "Add (3 boxes + 2 pins) sweeps over the islands that are awake."},
          .grade = grade_all};
}

}  // namespace cairn::exercise20
