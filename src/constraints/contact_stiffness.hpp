// Floor 3. The geometric stiffness of contacts.
#pragma once

#include <cairn/constraints/constraint.hpp>
#include <cairn/constraints/contact.hpp>

namespace cairn {

/// Adds the geometric stiffness of a contact under the forces of its rows, K = -sum of lambda d^2C/dx^2 as of
/// Constraint::add_stiffness(): its diagonal in how the two bodies turn [N m/rad], with its sign, for it only
/// pushes. The cores of the shapes are rounded by the radii [m]. A point p of the core of body o, on the face
/// of body f with the normal m, has C = m . (p - x_f) less a constant; as f turns, m'' = -m, and as o does,
/// (p - x_o)'' = -(p - x_o):
///   K_q of f = lambda m . (p - x_f),   K_q of o = lambda m . (p - x_o)
/// So a flat side on a disc of radius R has lambda R and more, for the touch runs along the disc as it turns;
/// the disc has none; and a corner that stands on a face topples: its K_q is negative. Two corners both have
/// the K_q of o, with the normal towards them; what their curvatures take away is left out. How turning goes
/// with sliding, lambda on both sides of the diagonal, is left to the masses. Sources: D. Montana, The
/// Kinematics of Contact and Grasp (1988); E. Rimon, J. Burdick, Mobility of Bodies in Contact (1998), for
/// second derivatives of gaps; M. Tournier and others (2015).
template <Scalar Real>
void add_contact_stiffness(const Contact<Real>& contact, Real radius_a, Real radius_b,
                           const RowForces<Real>& forces, PerBody<Vec3<Real>>& stiffness);

}  // namespace cairn
