// What is not to be stepped at all, what must not matter, and what has no answer.
#pragma once

#include <string>

#include "cairn.hpp"
#include "math/list.hpp"

namespace cairn::edges {

/// A thing that no engine could simulate, and what this one says to it.
struct Refusal {
  std::string asked = {};    // "a mass of 0"
  std::string message = {};  // empty: it was taken
};

/// A mass of zero, a step of zero, a place that is no number, a rod without length, friction below zero.
List<Refusal> try_bad_input();

/// What a joint that divides zero by zero leaves behind.
struct Guarded {
  int joined = 0;       // the first body of that joint
  int body = -1;        // the one that the report names; -1: none
  double moved = 0;     // [m] how far anything has gone in that step
  bool finite = false;  // whether all numbers of the world are
};
Guarded try_not_a_number();

/// How far the heights of a tower differ [m] with all masses multiplied by 2^20, and by 2^-20.
struct Scaled {
  double heavy = 0;
  double light = 0;
};
Scaled try_scaled_masses(int sweeps);

/// How far a pendulum with its rod stated twice is from one with its rod stated once, at most [m].
double try_twice(int sweeps, int steps);

/// Of the two pins in one solve of thousands of sweeps: why it ended.
Stop try_long_quarrel();

/// By how much the rod of a sling is too long after one step [m], for a turn of so many radians: it goes
/// straight on.
double first_step_by_formula(double turn);

}  // namespace cairn::edges
