// Floor 5. Bodies that a solve has left going through each other are kept apart.
#pragma once

#include "constraints/row.hpp"
#include "math/list.hpp"

namespace cairn {

/// A normal row of a problem, and how far its two bodies may come into each other.
template <Scalar Real>
struct ContactLimit {
  int row = 0;          // of the problem
  Real separation = 0;  // [m] where the step began
  Real depth = 0;       // [m] of overlap at the end of it, at most
};

/// Whether, at these velocities, two bodies would be deeper in each other after the step than they may be,
/// and deeper than they were before it.
template <Scalar Real>
bool goes_too_deep(const VelocityProblem<Real>& problem, const ContactLimit<Real>& contact,
                   const PerBody<Vec3<Real>>& velocity);

/// Stops what still approaches, from the immovable bodies outwards: a body gives way to those that are fewer
/// contacts away from what cannot be moved, as if they could not be moved either. So a heavy body rests on a
/// light one, and the ground has the last word. It throws nothing: a body is stopped by it, and not set in
/// motion, unless by what moves by itself. Weight is not passed on downwards, friction and joints are left
/// alone: it is for steps whose solve has failed. Source: E. Guendelman, R. Bridson, R. Fedkiw, Nonconvex
/// Rigid Bodies with Stacking (2003), for such shock propagation.
template <Scalar Real>
void keep_bodies_apart(const VelocityProblem<Real>& problem, List<ContactLimit<Real>> contacts,
                       PerBody<Vec3<Real>>& velocity);

}  // namespace cairn
