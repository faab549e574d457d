// What the tests of joints share: rows of a joint by name, refusals, and one step of a world.
#pragma once

#include "testing.hpp"
#include <cairn/validation/case_constants.hpp>

namespace cairn::testing {

inline constexpr double joint_gravity = 10;           // [m/s^2]
inline constexpr double joint_dt = 1.0 / 60;          // [s]
inline constexpr double never_found = -1e300;         // no impulse is that large
inline const PerBody<Pose<double>> two_at_origin(2);  // the ground and one body

/// A disc of the given mass [kg] and inertia [kg m^2] at `position`, that touches nothing.
inline BodySpec disc(const Vec2<double>& position, double mass, double inertia = 1) {
  return {.shapes = {circle(0.1)}, .position = position, .mass = mass, .inertia = inertia};
}

/// A mass on a spring, step by step by hand, with the formula of softness.hpp.
struct HandSwing {
  double x = 0;      // [m]
  double v = 0;      // [m/s]
  double omega = 0;  // [rad/s]
  double zeta = 0;

  void step(double h, double acceleration = 0) { cases::swing_step(x, v, h, omega, zeta, acceleration); }
};

/// The impulse [N s] that the row `part` of the scene's joint number `joint` gave in the last step.
template <Scalar Real>
Real joint_impulse(const World<Real>& world, JointPart part, std::uint64_t joint = 0) {
  const VelocityProblem<Real>& problem = world.last_step().problem;
  const RowKey key{joint, static_cast<std::uint64_t>(part)};
  for (int i = 0; i < problem.row_count(); ++i) {
    if (problem.rows[i].key == key) return problem.impulse[i];
  }
  return static_cast<Real>(never_found);
}

template <Scalar Real>
int joint_row_count(const World<Real>& world) {
  return world.velocity_problem().row_count();
}

template <Scalar Real>
void step_often(World<Real>& world, int steps, int iterations = 100) {
  take_steps(world, steps, iterations);
}

/// What making a Joint of this spec between the ground and body 1 is refused with; empty if it is not.
template <typename Joint>
std::string refusal_of(const typename Joint::Spec& spec) {
  return message_of([&] { Joint joint(spec, two_at_origin); });
}

}  // namespace cairn::testing
