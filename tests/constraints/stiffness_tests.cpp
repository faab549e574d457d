// Geometric stiffness, against the second derivatives of C, which are differences of its Jacobians.
#include <Eigen/Eigenvalues>
#include <random>

#include "testing.hpp"

using namespace cairn;

namespace {

constexpr int joined_bodies = 3;  // the ground, which does not move, and two others
constexpr int joined_freedoms = 3 * (joined_bodies - 1);
using Stiffness = Eigen::Matrix<double, joined_freedoms, joined_freedoms>;
using Poses = PerBody<Pose<double>>;

double between(std::mt19937& random, double least, double most) {
  return std::uniform_real_distribution<double>(least, most)(random);
}

Vec2<double> point(std::mt19937& random) { return {between(random, -2, 2), between(random, -2, 2)}; }

Poses random_poses(std::mt19937& random) {
  Poses poses;
  poses.push_back({});
  for (int i = 1; i < joined_bodies; ++i)
    poses.push_back({.position = point(random), .angle = between(random, -3, 3)});
  return poses;
}

double& freedom(Poses& poses, int k) {
  Pose<double>& pose = poses[BodyId{1 + k / 3}];
  return k % 3 == 2 ? pose.angle : pose.position[k % 3];
}

RowForces<double> random_forces(const Constraint& joint, const Poses& poses, std::mt19937& random) {
  const RowSpecs<double> rows = rows_of(joint, poses);
  RowForces<double> forces;
  for (const RowSpec<double>& row : rows) forces.rows.push_back({row.part, between(random, -50, 50)});
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
/// J^T lambda, which are below 1e4 where forces are below 50 N and lines longer than 0.2 m, and by the
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

/// On a carrier: in so many parts over a roller, or none of them on a drum.
PulleyJoint::Spec rope_over(std::mt19937& random, int parts) {
  PulleyJoint::End end{.body = {2}, .anchor = point(random), .roller = point(random), .carrier = {1}};
  if (parts == 0) {
    end.kind = PulleyJoint::Roller::drum;
    return {.ends = {end}};
  }
  end.parts = parts;
  return {.ends = {end}, .kind = PulleyJoint::Kind::taut};
}

/// Makes joints of a kind at random places.
struct BoundedKind {
  std::string name = {};
  std::function<std::shared_ptr<const Constraint>(const Poses&, std::mt19937&)> make = {};
};

template <typename Joint>
BoundedKind kind(const std::string& name, typename Joint::Spec (*spec)(std::mt19937&)) {
  return {name, [spec](const Poses& poses, std::mt19937& random) {
            return std::make_shared<const Joint>(spec(random), poses);
          }};
}

using Random = std::mt19937;

const List<BoundedKind> bounded_kinds = {
    kind<DistanceJoint>("rod",
                        [](Random& random) -> DistanceJoint::Spec {
                          return {.a = {1}, .b = {2}, .anchor_a = point(random), .anchor_b = point(random)};
                        }),
    kind<DistanceJoint>("rope to the ground",
                        [](Random& random) -> DistanceJoint::Spec {
                          return {.b = {2},
                                  .anchor_a = point(random),
                                  .anchor_b = point(random),
                                  .kind = DistanceJoint::Kind::rope};
                        }),
    kind<RevoluteJoint>("pin",
                        [](Random& random) -> RevoluteJoint::Spec {
                          return {.a = {1}, .b = {2}, .anchor = point(random), .lower = -1, .upper = 1};
                        }),
    kind<WeldJoint>(
        "weld",
        [](Random& random) -> WeldJoint::Spec { return {.a = {1}, .b = {2}, .anchor = point(random)}; }),
    kind<PrismaticJoint>(
        "slide on the ground",
        [](Random& random) -> PrismaticJoint::Spec {
          return {.b = {2}, .anchor = point(random), .axis = {0.6, 0.8}, .lower = -1, .upper = 1};
        }),
    kind<DragJoint>("hand",
                    [](Random& random) -> DragJoint::Spec {
                      return {.body = {2}, .anchor = point(random), .target = point(random)};
                    }),
    kind<PulleyJoint>("tackle on a carrier", [](Random& random) { return rope_over(random, 3); }),
    kind<PulleyJoint>("rope on a drum", [](Random& random) { return rope_over(random, 0); })};

}  // namespace

TEST_CASE(
    "the geometric stiffness that a joint states bounds the second derivatives of its C from both sides") {
  std::mt19937 random(7);
  for (const BoundedKind& kind : bounded_kinds) {
    CAPTURE(kind.name);
    for (int i = 0; i < 200; ++i) {
      CAPTURE(i);
      const Poses poses = random_poses(random);
      const auto joint = kind.make(poses, random);
      const List<Attachment> ends = joint->attachments();
      const auto place = [&](const Attachment& end) {
        const Pose<double>& pose = poses[end.body];
        return Vec2<double>(pose.position + Rotation<double>(pose.angle) * end.anchor);
      };
      const double length = (place(ends[0]) - place(ends[ends.size() - 1])).norm();
      const bool is_line =
          joint->name() == "distance" || joint->name() == "rope" || joint->name() == "pulley";
      if (is_line && length < 0.2) continue;
      const RowForces<double> forces = random_forces(*joint, poses, random);
      const Stiffness known = stiffness_of(*joint, poses, forces);
      const Stiffness bound = bound_of(*joint, poses, forces);
      CHECK(least_eigenvalue(bound - known) > -rounding_of_differences);
      CHECK(least_eigenvalue(bound + known) > -rounding_of_differences);
    }
  }
}

TEST_CASE("the stiffness of a pin is that of its C, and of no more than what turns") {
  std::mt19937 random(8);
  const Poses poses = random_poses(random);
  const RevoluteJoint pin({.a = {1}, .b = {2}, .anchor = point(random)}, poses);
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
