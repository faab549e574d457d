// Exercise 06: the inner loop of Algorithm 1.
#pragma once

#include "lessons/exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise06 {

/// A box that can only move up and down.
struct Box {
  double inverse_mass = 0;  // [1/kg]; 0: the ground
  double velocity = 0;      // [m/s] upwards
};

/// One-sided: the box above may rise from the one below, and must not sink into it. j v = v_above - v_below.
struct Contact {
  int below = 0;  // places in the list of boxes
  int above = 0;
  double impulse = 0;  // [N s] that it has given so far, in total
};

/// One row update: corrects j v of this contact to 0, as far as a contact that cannot pull is able to.
void update(Contact& contact, List<Box>& boxes);

using Answer = void (*)(Contact&, List<Box>&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise06
