// Geometric stiffness, against the second derivatives of C, which are differences of its Jacobians.
#include <Eigen/Eigenvalues>

#include "constraint_list.hpp"
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr int joined_bodies = 5;  // the ground, which does not move, and those of the list
constexpr int joined_freedoms = 3 * (joined_bodies - 1);
using Stiffness = Eigen::Matrix<double, joined_freedoms, joined_freedoms>;
using Poses = PerBody<Pose<double>>;

double& freedom(Poses& poses, int k) {
  Pose<double>& pose = poses[BodyId{1 + k / 3}];
  return k % 3 == 2 ? pose.angle : pose.position[k % 3];
}

RowForces<double> random_forces(const Constraint& joint, const Poses& poses, test::Random& random) {
  const RowSpecs<double> rows = rows_of(joint, poses);
  RowForces<double> forces;
  for (const RowSpec<double>& row : rows) forces.rows.push_back({row.part, random.uniform(-50, 50)});
  return forces;
}

/// J^T lambda: the forces and moments on all joined_freedoms.
Eigen::Matrix<double, joined_freedoms, 1> forces_on_bodies(const Constraint& joint, const Poses& poses,
                                                           const RowForces<double>& forces) {
  const RowSpecs<double> rows = rows_of(joint, poses);
  Eigen::Matrix<double, joined_freedoms, 1> sum = Eigen::Matrix<double, joined_freedoms, 1>::Zero();
  const auto add = [&](BodyId body, const Vec3<double>& jacobian, double force) {
    if (body != ground) sum.segment<3>(3 * (body.index - 1)) += force * jacobian;
  };
  for (const RowSpec<double>& row : rows) {
    add(row.a, row.jacobian_a, forces.of(row.part));
    add(row.b, row.jacobian_b, forces.of(row.part));
    for (int k = 0; k < row.extra_count; ++k)
      add(row.extra[k].body, row.extra[k].jacobian, forces.of(row.part));
  }
  return sum;
}

/// -sum of lambda d^2C/dx^2, by central differences: off by about step^2 times the third derivatives of
/// J^T lambda, which are below 1e4 where forces are below 50 N and lines longer than 1 m, and by the
/// rounding of the forces, 1e-16 times 1e3 N m, divided by the step.
Stiffness stiffness_of(const Constraint& joint, Poses poses, const RowForces<double>& forces) {
  constexpr double step = 1e-5;
  Stiffness result;
  for (int k = 0; k < joined_freedoms; ++k) {
    const double before = freedom(poses, k);
    freedom(poses, k) = before + step;
    const auto ahead = forces_on_bodies(joint, poses, forces);
    freedom(poses, k) = before - step;
    const auto behind = forces_on_bodies(joint, poses, forces);
    freedom(poses, k) = before;
    result.col(k) = -(ahead - behind) / (2 * step);
  }
  return result;
}

Stiffness bound_of(const Constraint& joint, const Poses& poses, const RowForces<double>& forces) {
  PerBody<Vec3<double>> stiffness(joined_bodies, Vec3<double>::Zero());
  joint.add_stiffness(poses, forces, stiffness);
  Stiffness result = Stiffness::Zero();
  for (int k = 0; k < joined_freedoms; ++k) result(k, k) = stiffness[BodyId{1 + k / 3}][k % 3];
  return result;
}

constexpr double rounding_of_differences = 1e-4;  // [N/m, N m/rad] of the differences above

double least_eigenvalue(const Stiffness& matrix) {
  return Eigen::SelfAdjointEigenSolver<Stiffness>((matrix + matrix.transpose()) / 2).eigenvalues().minCoeff();
}

}  // namespace

TEST_CASE(
    "the geometric stiffness that a joint states bounds the second derivatives of its C from both sides") {
  test::Random random(7);
  for (int round = 0; round < 50; ++round) {
    CAPTURE(round);
    const Poses poses = random_poses(random);
    for (const ConstraintUnderTest<double>& constraint : all_constraints<double>(poses, random)) {
      CAPTURE(constraint.name);
      // What couples the sliding of two bodies with their turning has no place on a diagonal.
      if (!constraint.rows.joint || constraint.rows.joint->traits().slides) continue;
      if (constraint.name == "rack on a carrier") continue;
      const Constraint& joint = *constraint.rows.joint;
      const RowForces<double> forces = random_forces(joint, poses, random);
      const Stiffness known = stiffness_of(joint, poses, forces);
      const Stiffness bound = bound_of(joint, poses, forces);
      CHECK(least_eigenvalue(bound - known) > -rounding_of_differences);
      CHECK(least_eigenvalue(bound + known) > -rounding_of_differences);
    }
  }
}

TEST_CASE("the stiffness of a pin is that of its C, and of no more than what turns") {
  test::Random random(8);
  const Poses poses = random_poses(random);
  const RevoluteJoint pin({.a = {1}, .b = {2}, .anchor = random.point(2)}, poses);
  const RowForces<double> forces = random_forces(pin, poses, random);
  const Stiffness known = stiffness_of(pin, poses, forces), bound = bound_of(pin, poses, forces);
  for (int k = 0; k < joined_freedoms; ++k)
    CHECK(bound(k, k) ==
          doctest::Approx(std::abs(known(k, k))).epsilon(0).scale(1).epsilon(rounding_of_differences));
}

TEST_CASE("what is linear in positions and angles has no geometric stiffness") {
  const Poses poses(joined_bodies);
  const GearJoint gear({.a = {1}, .b = {2}}, poses);
  CHECK(bound_of(gear, poses, {.rows = {{0, 100}}}).isZero(0));
}
