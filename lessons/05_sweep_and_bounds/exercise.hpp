// Exercise 05: intervals, and what they do to a λ.
#pragma once

#include <utility>

#include "lessons/exercise.hpp"

namespace cairn::exercise05 {

/// What a row may do.
enum class RowKind {
  joint,    // pushes and pulls
  contact,  // j v is how fast the bodies part; it only pushes them apart
  rope,     // j v is how fast it gets longer; it only pulls the bodies together
  motor     // pushes and pulls, with at most `strength`
};

/// The interval [N] that a λ has to stay in.
struct Interval {
  double lower = 0;
  double upper = 0;
};

/// The interval of a row. `strength` [N] is that of a motor; other kinds take no notice of it.
Interval interval_of(RowKind kind, double strength);

/// The value in the interval that is next to `lambda`.
double clamped(double lambda, const Interval& interval);

using Answer = std::pair<Interval (*)(RowKind, double), double (*)(double, const Interval&)>;
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise05
