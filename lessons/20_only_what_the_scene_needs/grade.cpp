// Exercise 20, graded: bills written out row by row.
#include <algorithm>
#include <string>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise20 {
namespace {

/// Who pays for how many rows, and how often.
struct Tariff {
  int rows_a_box = 3;
  bool sleepers_pay = false;
  bool all_wait = false;  // for the island that needs the most sweeps
  bool once = false;      // one sweep only
};

int bill(const List<Island>& islands, const Tariff& tariff) {
  int most = 0, updates = 0;
  for (const Island& island : islands) {
    if (!island.asleep || tariff.sleepers_pay) most = std::max(most, island.sweeps);
  }
  for (const Island& island : islands) {
    if (island.asleep && !tariff.sleepers_pay) continue;
    const int sweeps = tariff.once ? 1 : tariff.all_wait ? most : island.sweeps;
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      for (int box = 0; box < island.boxes; ++box) updates += tariff.rows_a_box;
      for (int pin = 0; pin < island.pins; ++pin) updates += 2;
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
               "Nobody waits for the slowest island: each has sweeps of its own."},
              {static_cast<double>(bill(islands, {.once = true})),
               "Those are the rows. How often is each swept?"},
              {static_cast<double>(bill(islands, {.rows_a_box = 4})),
               "Two points share one row of friction: three rows a manifold, not four."},
              {static_cast<double>(bill(islands, {.rows_a_box = 2})), "Where is the friction?"}}};
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const List<Island> scene = {{.boxes = 15, .sweeps = 12, .asleep = false},
                              {.boxes = 10, .sweeps = 60, .asleep = true},
                              {.pins = 5, .sweeps = 40}};
  grade.number(expected("pyramid awake, tower asleep, chain", scene), answer(scene));
  const List<Island> towers = {{.boxes = 10, .sweeps = 30}, {.boxes = 3, .pins = 1, .sweeps = 7}};
  grade.number(expected("two towers", towers), answer(towers));
  const List<Island> night = {{.boxes = 100, .sweeps = 50, .asleep = true}};
  grade.number(expected("all asleep", night), answer(night));
}

Exercise exercise() {
  return {.lesson = 20,
          .task = "The row updates of a step that does only what it has to.",
          .file = "lessons/20_only_what_the_scene_needs/exercise.cpp",
          .hints = {"An island costs its rows times its sweeps. Which islands have rows at all?",
                    "A manifold of two points: two normals and one friction. A pin: two.",
                    "Add (3 boxes + 2 pins) sweeps over the islands that are awake."},
          .grade = [](Grade& marks) { grade(marks, row_updates); }};
}

}  // namespace cairn::exercise20
