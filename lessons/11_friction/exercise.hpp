// Exercise 11: a friction row, whose bound depends on its neighbour.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise11 {

/// A block on a plane.
struct Block {
  double inverse_mass = 0;  // [1/kg]
  double slide = 0;         // [m/s] along the plane: j v of the friction row
};

/// What the contact under it has given so far, in total.
struct Contact {
  double normal_impulse = 0;   // [N s]
  double tangent_impulse = 0;  // [N s]
  double friction = 0;         // mu
};

/// One update of the friction row: takes the sliding away, as far as +-mu times the normal impulse allows.
void update(Contact& contact, Block& block);

using Answer = void (*)(Contact&, Block&);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise11
