// Floor 3. Contact: keep two surfaces apart, and let friction resist their sliding.
#pragma once

#include <limits>

#include <cairn/collision/manifold.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Where friction acts.
enum class FrictionRows {
  per_point,     // one row behind each normal row
  per_manifold,  // one row for both points of a manifold: they slide on one line, so that two would say the
                 // same
};

/// Two bodies in contact where a substep begins: all that its rows are made of, but for the masses and the
/// rule that all contacts share.
template <Scalar Real>
struct Contact {
  BodyId a = {};                                            // the first body
  BodyId b = {};                                            // the second body
  Manifold<Real> manifold = {};                             // between their shapes
  Vec2<Real> center_a = Vec2<Real>::Zero();                 // [m] of mass
  Vec2<Real> center_b = Vec2<Real>::Zero();                 // [m] of mass
  Real friction = 0;                                        // mu; of what sticks mu_s
  Real restitution = 0;                                     // e: separation speed over approach speed
  Real slop_limit = std::numeric_limits<Real>::infinity();  // [m] no slop above this
  FixedList<Real, 2> rebound = {};  // [m/s] with which each point parts that will meet; 0: it need not
  FixedList<bool, 2> rigid = {};    // whether each point is too fast for a spring: it rebounds, or strikes
};

}  // namespace cairn
