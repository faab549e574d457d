// Floor 2. Semi-implicit Euler.
#include <cairn/dynamics/integrate.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

template <Scalar Real>
void apply_gravity(PerBody<Vec3<Real>>& velocity, const PerBody<Vec3<Real>>& inverse_mass,
                   const PerBody<int>& kind, const List<BodyForces<Real>>& forces, const Vec2<Real>& gravity,
                   Real dt) {
  for (const BodyId body : velocity.indices()) {
    if (inverse_mass[body].x() > 0)
      velocity[body].template head<2>() += dt * forces[kind[body]].gravity_scale * gravity;
  }
}

template <Scalar Real>
void apply_damping(PerBody<Vec3<Real>>& velocity, const PerBody<Vec3<Real>>& inverse_mass,
                   const PerBody<int>& kind, const List<BodyForces<Real>>& forces, Real dt) {
  for (const BodyId body : velocity.indices()) {
    if (!(inverse_mass[body].x() > 0)) continue;
    velocity[body].template head<2>() /= 1 + dt * forces[kind[body]].linear_damping;
    velocity[body].z() /= 1 + dt * forces[kind[body]].angular_damping;
  }
}

template <Scalar Real>
void integrate_positions(BodyState<Real>& state, Real dt) {
  for (const BodyId body : state.velocity.indices()) {
    state.pose[body].position += dt * state.velocity[body].template head<2>();
    state.pose[body].angle += dt * state.velocity[body].z();
  }
}

template void apply_gravity(PerBody<Vec3<float>>&, const PerBody<Vec3<float>>&, const PerBody<int>&,
                            const List<BodyForces<float>>&, const Vec2<float>&, float);
template void apply_damping(PerBody<Vec3<float>>&, const PerBody<Vec3<float>>&, const PerBody<int>&,
                            const List<BodyForces<float>>&, float);
template void integrate_positions(BodyState<float>&, float);
template void apply_gravity(PerBody<Vec3<double>>&, const PerBody<Vec3<double>>&, const PerBody<int>&,
                            const List<BodyForces<double>>&, const Vec2<double>&, double);
template void apply_damping(PerBody<Vec3<double>>&, const PerBody<Vec3<double>>&, const PerBody<int>&,
                            const List<BodyForces<double>>&, double);
template void integrate_positions(BodyState<double>&, double);

}  // namespace cairn
