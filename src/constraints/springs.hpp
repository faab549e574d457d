// Floor 3. Rows with a spring of their own, and what it holds.
#pragma once

#include <cairn/constraints/constraint.hpp>

namespace cairn {

/// 1 / m [1/kg] of the masses that the spring of a row carries: what A_ii would be if no body turned. Of a
/// row that turns bodies and does not move them, its A_ii. The rows of one point share it, whichever way the
/// axes are turned. With A_ii, inertia that hardly resists would make the spring weak for the mass too, which
/// hangs on it along the arm: a pin 1 m from 1 kg and 1e-3 kg m^2 would give way a thousand times as far.
template <Scalar Real>
Real carried_inverse_mass(const RowSpec<Real>& spec, const PerBody<Vec3<Real>>& inverse_mass);
/// The same of a rigid row, which may be on a spring of the policy soft.
template <Scalar Real>
Real carried_inverse_mass(const RigidRow<Real>& row, const PerBody<Vec3<Real>>& inverse_mass);

/// k C^2 / 2 [J] that the row's own spring holds; of a force that is limited, what it can give back. 0
/// without a spring.
template <Scalar Real>
double spring_energy(const RowSpec<Real>& spec, const PerBody<Vec3<Real>>& inverse_mass);

/// Gives the row of a spec with a spring its bias and its softness in a step of dt [s] that begins so.
template <Scalar Real>
void put_on_spring(const RowSpec<Real>& spec, const BodyState<Real>& begin, Real dt,
                   ConstraintRow<Real>& row);

}  // namespace cairn
