// Exercise 20: the bill of a step.
#pragma once

#include "lessons/exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise20 {

/// Things that touch or hold each other.
struct Island {
  int boxes = 0;   // that stand on each other or on the ground, each on one manifold of two points
  int pins = 0;    // two rows each
  int sweeps = 0;  // after which the island is content
  bool asleep = false;
};

/// How many row updates a step takes that does only what it has to: each contact point has a normal row, each
/// manifold one row of friction; what sleeps has none; and every island is swept until it is content,
/// whatever the others need.
int row_updates(const List<Island>& islands);

using Answer = int (*)(const List<Island>&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise20
