// Floor 5. What a body of a world has from its scene, and never changes.
#pragma once

#include <compare>

#include "math/math.hpp"

namespace cairn {

/// Bodies that are alike share one.
template <Scalar Real>
struct BodyTraits {
  Real slop_limit = 0;       // [m] a share of the smallest shape
  Real failed_error = 0;     // [m] likewise: deeper in another, it is on its way through
  double friction_root = 0;  // sqrt(mu): a pair's mu is the product of two
  Real radius = 0;           // [m] of a circle around all shapes, about the centre of mass

  /// Member by member.
  bool operator==(const BodyTraits&) const = default;
};

}  // namespace cairn
