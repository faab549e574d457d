// Floor 2. Semi-implicit Euler.
#include "dynamics/integrate.hpp"

namespace cairn {

template <Scalar Real>
void apply_gravity(std::vector<Vec3<Real>>& velocity, const std::vector<Vec3<Real>>& inverse_mass,
                   const std::vector<BodyForces<Real>>& forces, const Vec2<Real>& gravity, Real dt) {
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    if (inverse_mass[i].x() > 0) velocity[i].template head<2>() += dt * forces[i].gravity_scale * gravity;
  }
}

template <Scalar Real>
void apply_damping(std::vector<Vec3<Real>>& velocity, const std::vector<Vec3<Real>>& inverse_mass,
                   const std::vector<BodyForces<Real>>& forces, Real dt) {
  for (std::size_t i = 0; i < velocity.size(); ++i) {
    if (!(inverse_mass[i].x() > 0)) continue;
    velocity[i].template head<2>() /= 1 + dt * forces[i].linear_damping;
    velocity[i].z() /= 1 + dt * forces[i].angular_damping;
  }
}

template <Scalar Real>
void integrate_positions(BodyState<Real>& state, Real dt) {
  for (std::size_t i = 0; i < state.velocity.size(); ++i) {
    state.pose[i].position += dt * state.velocity[i].template head<2>();
    state.pose[i].angle += dt * state.velocity[i].z();
  }
}

template void apply_gravity(std::vector<Vec3<float>>&, const std::vector<Vec3<float>>&,
                            const std::vector<BodyForces<float>>&, const Vec2<float>&, float);
template void apply_damping(std::vector<Vec3<float>>&, const std::vector<Vec3<float>>&,
                            const std::vector<BodyForces<float>>&, float);
template void integrate_positions(BodyState<float>&, float);
template void apply_gravity(std::vector<Vec3<double>>&, const std::vector<Vec3<double>>&,
                            const std::vector<BodyForces<double>>&, const Vec2<double>&, double);
template void apply_damping(std::vector<Vec3<double>>&, const std::vector<Vec3<double>>&,
                            const std::vector<BodyForces<double>>&, double);
template void integrate_positions(BodyState<double>&, double);
template void apply_gravity(std::vector<Vec3<long double>>&, const std::vector<Vec3<long double>>&,
                            const std::vector<BodyForces<long double>>&, const Vec2<long double>&,
                            long double);
template void apply_damping(std::vector<Vec3<long double>>&, const std::vector<Vec3<long double>>&,
                            const std::vector<BodyForces<long double>>&, long double);
template void integrate_positions(BodyState<long double>&, long double);

}  // namespace cairn
