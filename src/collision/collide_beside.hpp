// Floor 2. The narrowphase where one of two hulls has neighbours.
#pragma once

#include <cairn/collision/hull_contact.hpp>
#include <cairn/collision/neighbours.hpp>

namespace cairn::narrowphase {

/// Which hull of a pair.
enum class Side { a, b };

/// The manifold of two hulls of which the one on side `still` has neighbours, given in the frame of a body
/// turned by `rotation`. It has only the normals that these allow, and no point that belongs to a
/// neighbour.
template <Scalar Real>
Manifold<Real> collide_beside(const Pair<Real>& pair, Side still, const Neighbours<Real>& around,
                              const Rotation<Real>& rotation);

}  // namespace cairn::narrowphase
