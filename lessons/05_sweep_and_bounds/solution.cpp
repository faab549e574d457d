// Exercise 05, answered.
#include <algorithm>
#include <limits>

#include "exercise.hpp"

namespace cairn::exercise05 {

Interval interval_of(RowKind kind, double strength) {
  const double infinite = std::numeric_limits<double>::infinity();
  switch (kind) {
    case RowKind::joint:
      return {-infinite, infinite};
    case RowKind::contact:
      return {0, infinite};
    case RowKind::rope:
      return {-infinite, 0};
    case RowKind::motor:
      break;
  }
  return {-strength, strength};
}

double clamped(double lambda, const Interval& interval) {
  return std::min(std::max(lambda, interval.lower), interval.upper);
}

}  // namespace cairn::exercise05
