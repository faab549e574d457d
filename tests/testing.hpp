// What tests of the core share: the library, doctest, and words for what most of them do with a world.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <cairn/cairn.hpp>

namespace cairn::testing {

/// Steps the world so often; the report of the last step.
template <Scalar Real>
StepReport take_steps(World<Real>& world, Solver<Real>& solver, int steps) {
  StepReport report;
  for (int i = 0; i < steps; ++i) report = world.step(solver);
  return report;
}

/// By sequential impulses; a solver of its own in every call, as none keeps anything from step to step.
template <Scalar Real>
StepReport take_steps(World<Real>& world, int steps, int iterations = 10) {
  SequentialImpulse<Real> solver({.iterations = iterations});
  return take_steps(world, solver, steps);
}

/// A world of this scene, so many steps later.
template <Scalar Real = double>
World<Real> world_after(const Scene& scene, int steps, int iterations = 10) {
  World<Real> world(scene);
  take_steps(world, steps, iterations);
  return world;
}

/// What the world would hand to its solver after so many steps.
inline VelocityProblem<double> problem_after(const Scene& scene, int steps) {
  return world_after(scene, steps).velocity_problem();
}

/// Of a body: where it is, and how fast.
template <Scalar Real>
const Pose<Real>& pose_of(const World<Real>& world, BodyId body) {
  return world.bodies().pose[body];
}
template <Scalar Real>
const Vec3<Real>& velocity_of(const World<Real>& world, BodyId body) {
  return world.bodies().velocity[body];
}

/// Bit by bit, of the bodies that both worlds have; what is no number is equal to nothing.
template <Scalar Real>
bool same_poses(const World<Real>& one, const World<Real>& other) {
  bool same = true;
  for (int i = 0; i < std::min(one.bodies().pose.size(), other.bodies().pose.size()); ++i) {
    const BodyId body{i};
    if (one.scene().bodies()[body].removed || other.scene().bodies()[body].removed) continue;
    same = same && pose_of(one, body).position == pose_of(other, body).position &&
           pose_of(one, body).angle == pose_of(other, body).angle;
  }
  return same;
}

/// Poses, velocities, and who is awake.
template <Scalar Real>
bool same_motion(const World<Real>& one, const World<Real>& other) {
  bool same = same_poses(one, other);
  for (int i = 0; i < std::min(one.bodies().pose.size(), other.bodies().pose.size()); ++i) {
    const BodyId body{i};
    if (one.scene().bodies()[body].removed || other.scene().bodies()[body].removed) continue;
    same = same && velocity_of(one, body) == velocity_of(other, body) &&
           one.is_awake(body) == other.is_awake(body);
  }
  return same;
}

/// Motion and time.
template <Scalar Real>
bool go_alike(const World<Real>& one, const World<Real>& other) {
  return same_motion(one, other) && one.clock().time == other.clock().time &&
         one.clock().steps == other.clock().steps && one.clock().dt == other.clock().dt;
}

/// Both worlds, so many steps further on.
template <Scalar Real>
bool go_on_alike(World<Real>& one, World<Real>& other, int steps) {
  take_steps(one, steps);
  take_steps(other, steps);
  return go_alike(one, other);
}

/// Motion, time, and the impulses of the last step.
template <Scalar Real>
bool same_state(const World<Real>& one, const World<Real>& other) {
  return go_alike(one, other) && one.last_step().problem.impulse == other.last_step().problem.impulse;
}

/// Row by row, to the last bit.
template <Scalar Real>
void check_same_problem(const VelocityProblem<Real>& one, const VelocityProblem<Real>& other) {
  REQUIRE(one.row_count() == other.row_count());
  CHECK(one.impulse == other.impulse);
  CHECK(one.velocity == other.velocity);
  CHECK(one.inverse_mass == other.inverse_mass);
  CHECK(one.dt == other.dt);
  for (int i = 0; i < one.row_count(); ++i) {
    const ConstraintRow<Real>&row = one.rows[i], &expected = other.rows[i];
    CHECK(row.key == expected.key);
    CHECK(row.a == expected.a);
    CHECK(row.b == expected.b);
    CHECK(row.jacobian_a == expected.jacobian_a);
    CHECK(row.jacobian_b == expected.jacobian_b);
    CHECK(row.bias == expected.bias);
    CHECK(row.softness == expected.softness);
    CHECK(row.bounds.lower == expected.bounds.lower);
    CHECK(row.bounds.upper == expected.bounds.upper);
    CHECK(row.bounds.normal_row == expected.bounds.normal_row);
    CHECK(row.bounds.friction == expected.bounds.friction);
  }
}

/// The largest coordinate of the difference of two velocities of a body [m/s, rad/s].
template <Scalar Real>
Real largest_gap(const PerBody<Vec3<Real>>& one, const PerBody<Vec3<Real>>& other) {
  Real largest = 0;
  for (const BodyId body : one.indices()) {
    const Vec3<Real> gap = one[body] - other[body];
    largest = std::max(largest, gap.cwiseAbs().maxCoeff());
  }
  return largest;
}

/// What an action is refused with; empty where it is not.
template <typename Error = std::invalid_argument, typename Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// The row of a joint that is stated at these poses.
inline RowSpecs<double> rows_of(const Constraint& joint, const PerBody<Pose<double>>& poses) {
  RowSpecs<double> rows;
  joint.append_rows(poses, rows);
  return rows;
}

/// The policies of stabilization, all of them.
inline constexpr StabilizationPolicy every_policy[] = {
    StabilizationPolicy::none, StabilizationPolicy::baumgarte, StabilizationPolicy::relaxed,
    StabilizationPolicy::soft, StabilizationPolicy::split_impulse};

/// All ways to look for contacts.
inline constexpr ContactSearch every_search[] = {ContactSearch::every_substep, ContactSearch::every_step,
                                                 ContactSearch::when_moved};

}  // namespace cairn::testing
