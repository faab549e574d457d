// Floor 3. Contact: keep two surfaces apart, and let friction resist their sliding.
#pragma once

#include <limits>

#include "collision/manifold.hpp"
#include "constraints/constraint.hpp"
#include "constraints/stabilization.hpp"

namespace cairn {

/// Where friction acts.
enum class FrictionRows {
  per_point,     // one row behind each normal row
  per_manifold,  // one row for both points of a manifold: they slide on one line, so that two would say the
                 // same
};

/// How two surfaces meet: the mixture of two materials.
template <Scalar Real>
struct ContactMaterial {
  Real friction = 0;                                        // mu
  Real restitution = 0;                                     // e: separation speed over approach speed
  Real restitution_threshold = 0;                           // [m/s] slower approaches do not rebound
  FrictionRows friction_rows = FrictionRows::per_point;     // for both points of a manifold, or for each
  Real slop_limit = std::numeric_limits<Real>::infinity();  // [m] no slop above this, whatever is asked for
};

/// Writes the rows of a manifold between bodies a and b. For each point, with arms r_a, r_b from the centres
/// of mass, unit normal n from a to b and tangent t (n turned by -90 degrees: right, where n is up):
///   normal    C = separation >= 0,  j = (-n, -(r_a x n), n, r_b x n),  impulse >= 0
///   friction  no C,                 j = (-t, -(r_a x t), t, r_b x t),  |impulse| <= mu * normal impulse
/// Normal before friction, so that friction sees the normal impulse of the same sweep. No friction row where
/// mu is 0. A friction row for a whole manifold acts in the middle between its points and may take mu times
/// the sum of their normal impulses: the same forces, as both points slide along the same line, in fewer rows
/// and with a J of full rank. Restitution asks for e times the approach speed in `velocity` (the one before
/// gravity acts: then an elastic bounce keeps the discrete energy exactly), should the surfaces meet in this
/// step. Source: E. Catto, Iterative Dynamics with Temporal Coherence (2005).
///
/// dt, inverse masses and velocities of the problem are those of the step without constraints. Rows go over
/// those from `next` on; `next` is then the row behind them. Their key's source is `source`. Between bodies
/// that nothing moves there are none. Behind `relaxed` comes what each is in a second solve; null: there is
/// none.
template <Scalar Real>
void write_contact_rows(const Manifold<Real>& manifold, BodyId a, BodyId b,
                        const ContactMaterial<Real>& material, const PerBody<Pose<Real>>& poses,
                        const PerBody<Vec3<Real>>& velocity, const RowRule<Real>& rule, std::uint64_t source,
                        VelocityProblem<Real>& problem, int& next, List<RelaxedRow<Real>>* relaxed = nullptr);

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
void add_contact_stiffness(const Manifold<Real>& manifold, BodyId a, BodyId b, Real radius_a, Real radius_b,
                           const PerBody<Pose<Real>>& poses, const RowForces<Real>& forces,
                           PerBody<Vec3<Real>>& stiffness);

/// Row parts of a contact point: its feature id with one bit for the kind of row.
constexpr std::uint64_t normal_part(std::uint32_t feature) { return std::uint64_t{feature} << 1; }
/// The part of the friction row behind normal_part(feature).
constexpr std::uint64_t friction_part(std::uint32_t feature) { return normal_part(feature) | 1; }

}  // namespace cairn
