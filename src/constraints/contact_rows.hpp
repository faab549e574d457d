// Floor 3. The rows of contacts: how many there are, what they are called, and what they say.
#pragma once

#include <cairn/constraints/row.hpp>

namespace cairn {

/// How many rows a contact of a problem has: of every point the normal row, and where there is friction a row
/// of friction behind it, or one behind both; behind those of a single point that of rolling resistance, if
/// there is any. None between bodies that nothing moves.
template <Scalar Real>
int contact_row_count(const Contact<Real>& contact, const VelocityProblem<Real>& problem);

/// Row parts of a contact point: its feature id with one bit for the kind of row.
constexpr std::uint64_t normal_part(std::uint32_t feature) { return std::uint64_t{feature} << 1; }
/// The part of the friction row behind normal_part(feature).
constexpr std::uint64_t friction_part(std::uint32_t feature) { return normal_part(feature) | 1; }
/// Whether a part is that of a normal row.
constexpr bool is_normal_part(std::uint64_t part) { return (part & 1) == 0 && part >> 33 == 0; }
/// The part of the row of rolling resistance behind these.
constexpr std::uint64_t rolling_part(std::uint32_t feature) {
  return normal_part(feature) | std::uint64_t{1} << 33;
}
/// Whether a row is one of rolling resistance: bounded as friction is, and it pushes nowhere.
template <Scalar Real>
bool is_rolling(const ConstraintRow<Real>& row) {
  return row.bounds.is_friction() && row.jacobian_b.template head<2>().isZero(0);
}
/// RowKey::part of the k-th of so many rows of a contact.
template <Scalar Real>
std::uint64_t contact_part(const Manifold<Real>& manifold, int rows, int k) {
  if (k == 2 && manifold.count == 1) return rolling_part(manifold.points[0].feature);
  const bool per_point = rows >= 2 * manifold.count;
  if (!per_point && k >= manifold.count) return friction_part(manifold.points[0].feature);
  const std::uint32_t feature = manifold.points[per_point ? k / 2 : k].feature;
  return per_point && k % 2 == 1 ? friction_part(feature) : normal_part(feature);
}

/// Decides how the bodies of a contact meet in the substep of a problem, whose velocities and rule are those
/// of the substep without constraints. A point rebounds with e times its approach speed in `before` [m/s],
/// the velocities before gravity acts (then an elastic bounce keeps the discrete energy exactly), if that is
/// above `threshold` [m/s] and the surfaces would meet there. It strikes where it overlaps and comes in
/// faster than overlap is taken back: no spring of the policy stops that.
template <Scalar Real>
void meet(Contact<Real>& contact, const PerBody<Vec3<Real>>& before, Real threshold,
          const VelocityProblem<Real>& problem);

/// Puts a block for each contact of the problem behind its blocks. `next` is the row behind theirs; it goes
/// on behind those of the contacts.
template <Scalar Real>
void add_contact_blocks(VelocityProblem<Real>& problem, int& next);

/// Writes the rows of a contact. For each point, with arms r_a, r_b from the centres of mass, unit normal n
/// from a to b and tangent t (n turned by -90 degrees: right, where n is up):
///   normal    C = separation >= 0,  j = (-n, -(r_a x n), n, r_b x n),  impulse >= 0
///   friction  no C,                 j = (-t, -(r_a x t), t, r_b x t),  |impulse| <= mu * normal impulse
///   rolling   no C,                 j = (0, -1, 0, 1),               |impulse| <= mu_r * normal impulse
/// Normal before friction, so that friction sees the normal impulse of the same sweep. No friction row where
/// mu is 0. A friction row for a whole manifold acts in the middle between its points and may take mu times
/// the sum of their normal impulses: the same forces, as both points slide along the same line, in fewer rows
/// and with a J of full rank. Two points are a face that stands, and no rolling
/// row is theirs: their normal impulses are a moment already. Bias and softness of normal rows are those of
/// contact_bias() and spring_softness(), by the problem's rule. Source: E. Catto, Iterative Dynamics with
/// Temporal Coherence (2005).
///
/// Rows go over those from `next` on; `next` is then the row behind them. Behind `second_rows` comes what
/// each is in a second solve; null: nobody asks.
template <Scalar Real>
void write_contact_rows(const Contact<Real>& contact, VelocityProblem<Real>& problem, int& next,
                        List<SecondRow<Real>>* second_rows = nullptr);

/// Writes the rows of all contacts of a problem behind those of its joints. Twice is the same as once.
template <Scalar Real>
void write_contact_rows(VelocityProblem<Real>& problem, List<SecondRow<Real>>* second_rows = nullptr);

}  // namespace cairn
