// Floor 3. Rows with a spring of their own, and what it holds.
#include <cairn/constraints/springs.hpp>

#include <algorithm>
#include <cmath>

namespace cairn {

namespace {

/// Sums of what resists a row: A_ii, and what of it are masses.
template <Scalar Real>
struct RowMass {
  Real of_all = 0;     // [1/kg]
  Real of_masses = 0;  // [1/kg]

  Real carried() const { return of_masses > 0 ? of_masses : of_all; }
};

template <Scalar Real>
void add_mass(const Vec3<Real>& inverse_mass, const Vec3<Real>& jacobian, RowMass<Real>& mass) {
  mass.of_all += dot<Real>(jacobian, inverse_mass.cwiseProduct(jacobian));
  mass.of_masses += inverse_mass.x() * jacobian.template head<2>().squaredNorm();
}

template <Scalar Real>
RowMass<Real> mass_of(const RigidRow<Real>& row, const PerBody<Vec3<Real>>& inverse_mass) {
  RowMass<Real> mass;
  add_mass(inverse_mass[row.a], row.jacobian_a, mass);
  add_mass(inverse_mass[row.b], row.jacobian_b, mass);
  return mass;
}

template <Scalar Real>
RowMass<Real> mass_of(const RowSpec<Real>& spec, const PerBody<Vec3<Real>>& inverse_mass) {
  RowMass<Real> mass = mass_of<Real>(static_cast<const RigidRow<Real>&>(spec), inverse_mass);
  for (int k = 0; k < spec.extra_count; ++k)
    add_mass(inverse_mass[spec.extra[k].body], spec.extra[k].jacobian, mass);
  return mass;
}

}  // namespace

template <Scalar Real>
Real carried_inverse_mass(const RowSpec<Real>& spec, const PerBody<Vec3<Real>>& inverse_mass) {
  return mass_of(spec, inverse_mass).carried();
}

template <Scalar Real>
Real carried_inverse_mass(const RigidRow<Real>& row, const PerBody<Vec3<Real>>& inverse_mass) {
  return mass_of(row, inverse_mass).carried();
}

template <Scalar Real>
double spring_energy(const RowSpec<Real>& spec, const PerBody<Vec3<Real>>& inverse_mass) {
  if (!spec.softness || (spec.bounds.is_unilateral() && spec.error >= 0)) return 0;
  const double carried = static_cast<double>(carried_inverse_mass(spec, inverse_mass));
  if (!(carried > 0)) return 0;
  const double k = stiffness_of(*spec.softness, carried), error = std::abs(static_cast<double>(spec.error));
  if (!spec.max_force || !(k * error > static_cast<double>(*spec.max_force))) return k * error * error / 2;
  const double most = static_cast<double>(*spec.max_force);
  return most * (error - most / k / 2);
}

template <Scalar Real>
void put_on_spring(const RowSpec<Real>& spec, const BodyState<Real>& begin, Real dt,
                   ConstraintRow<Real>& row) {
  const RowMass<Real> mass = mass_of(spec, begin.inverse_mass);
  const SpringRow<Real> spring = spring_row<Real>(*spec.softness,
                                                  {.error = spec.error,
                                                   .speed = row_velocity(spec, begin.velocity),
                                                   .inverse_mass = mass.of_all,
                                                   .of_masses = mass.carried(),
                                                   .only_pushes = spec.bounds.is_unilateral()},
                                                  dt);
  row.bias = spec.speed + spring.bias;
  row.softness = spring.softness;
}

template float carried_inverse_mass(const RowSpec<float>&, const PerBody<Vec3<float>>&);
template float carried_inverse_mass(const RigidRow<float>&, const PerBody<Vec3<float>>&);
template double spring_energy(const RowSpec<float>&, const PerBody<Vec3<float>>&);
template void put_on_spring(const RowSpec<float>&, const BodyState<float>&, float, ConstraintRow<float>&);
template double carried_inverse_mass(const RowSpec<double>&, const PerBody<Vec3<double>>&);
template double carried_inverse_mass(const RigidRow<double>&, const PerBody<Vec3<double>>&);
template double spring_energy(const RowSpec<double>&, const PerBody<Vec3<double>>&);
template void put_on_spring(const RowSpec<double>&, const BodyState<double>&, double, ConstraintRow<double>&);

}  // namespace cairn
