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
  Real gravity = 0;  // [m/s^2] that a body in overlap has to rise against; 0: none
};

/// The rows of a manifold between bodies a and b. For each point, with arms r_a, r_b from the centres of
/// mass, unit normal n from a to b and tangent t (n turned by -90 degrees: right, where n is up):
///   normal    C = separation >= 0,  j = (-n, -(r_a x n), n, r_b x n),  impulse >= 0
///   friction  no C,                 j = (-t, -(r_a x t), t, r_b x t),  |impulse| <= mu * normal impulse
/// Normal before friction, so that friction sees the normal impulse of the same sweep. No friction row where
/// mu is 0. A friction row for a whole manifold acts in the middle between its points and may take mu times
/// the sum of their normal impulses: the same forces, as both points slide along the same line, in fewer rows
/// and with a J of full rank. Restitution asks for e times the approach speed in `velocity` (the one before
/// gravity acts: then an elastic bounce keeps the discrete energy exactly), should the surfaces meet in this
/// step. Source: E. Catto, Iterative Dynamics with Temporal Coherence (2005).
template <Scalar Real>
void append_contact_rows(const Manifold<Real>& manifold, BodyId a, BodyId b,
                         const ContactMaterial<Real>& material, const PerBody<Pose<Real>>& poses,
                         const PerBody<Vec3<Real>>& velocity, RowSpecs<Real>& rows);

/// Writes the same rows into a problem of which dt, inverse masses and velocities are those of the step
/// without constraints, over its rows from `next` on; `next` is then the row behind them. Their key's source
/// is `source`. Between bodies that nothing moves there are none. Behind `relaxed` comes what each is in a
/// second solve; null: there is none.
template <Scalar Real>
void write_contact_rows(const Manifold<Real>& manifold, BodyId a, BodyId b,
                        const ContactMaterial<Real>& material, const PerBody<Pose<Real>>& poses,
                        const PerBody<Vec3<Real>>& velocity, const ContactStabilization<Real>& stabilization,
                        std::uint64_t source, VelocityProblem<Real>& problem, int& next,
                        List<RelaxedRow<Real>>* relaxed = nullptr);

/// Row parts of a contact point: its feature id with one bit for the kind of row.
constexpr std::uint64_t normal_part(std::uint32_t feature) { return std::uint64_t{feature} << 1; }
/// The part of the friction row behind normal_part(feature).
constexpr std::uint64_t friction_part(std::uint32_t feature) { return normal_part(feature) | 1; }

}  // namespace cairn
