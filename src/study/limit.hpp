// Floor 9. A number beside the most that it may be.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace cairn {

/// The value over its limit: above 1 exactly where the value is above the limit, infinite where that is 0 or
/// the value is NaN; 0 for a value below 0.
inline double share_of(double value, double limit) {
  if (value <= limit) return limit > 0 && std::isfinite(limit) ? std::max(value, 0.0) / limit : 0;
  const double share = limit > 0 ? value / limit : std::numeric_limits<double>::infinity();
  if (std::isnan(share)) return std::numeric_limits<double>::infinity();
  return std::max(share, std::nextafter(1.0, 2.0));
}

}  // namespace cairn
