// What every constraint must do, for every scalar: Jacobians that are derivatives, forces that come in pairs.
#include "constraint_list.hpp"
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr int random_rounds = 20;

/// The poses with one coordinate of one body (0, 1: x, y; 2: angle) changed.
template <Scalar Real>
PerBody<Pose<Real>> nudged(PerBody<Pose<Real>> poses, BodyId body, int coordinate, Real by) {
  if (coordinate == 2) {
    poses[body].angle += by;
  } else {
    poses[body].position(coordinate) += by;
  }
  return poses;
}

/// dC/dq of row `row`, by central differences of step h.
template <Scalar Real>
Real difference_quotient(const StateRows<Real>& rows, int row, const PerBody<Pose<Real>>& poses, BodyId body,
                         int coordinate, Real h) {
  const Real above = rows(nudged(poses, body, coordinate, h)).at(row).error;
  const Real below = rows(nudged(poses, body, coordinate, -h)).at(row).error;
  return (above - below) / (2 * h);
}

/// Calls check(constraint, poses) with every constraint at random poses. Where `moved` is not 0, the bodies
/// have left the poses that their joints were made for by up to so much.
template <Scalar Real, typename Check>
void for_all_constraints(std::uint64_t seed, double moved, const Check& check) {
  test::Random random(seed);
  for (int round = 0; round < random_rounds; ++round) {
    PerBody<Pose<double>> poses = random_poses(random);
    const List<ConstraintUnderTest<Real>> constraints = all_constraints<Real>(poses, random);
    for (const BodyId body : poses.indices()) {
      if (body == ground) continue;
      poses[body].position += random.point(moved);
      poses[body].angle += random.uniform(-moved, moved);
    }
    for (const ConstraintUnderTest<Real>& constraint : constraints) {
      CAPTURE(constraint.name);
      CAPTURE(round);
      check(constraint, poses_in<Real>(poses));
    }
  }
}

}  // namespace

TEST_CASE_TEMPLATE("every constraint's Jacobian is the derivative of its error", Real, float, double) {
  // Central differences err by h^2 |C'''| / 6 and by the rounding of C over h. Coordinates and arms are below
  // 10 m and C''' below 8 of them, as no two anchors come nearer than 1 m: the best h is about the third root
  // of epsilon.
  const Real epsilon = std::numeric_limits<Real>::epsilon();
  const Real h = std::cbrt(epsilon);
  const Real size = 10;
  const Real tolerance = 8 * size * h * h / 6 + 8 * epsilon * size / h;
  for_all_constraints<Real>(
      1, 0.2, [&](const ConstraintUnderTest<Real>& constraint, const PerBody<Pose<Real>>& poses) {
        const RowSpecs<Real> rows = constraint.rows(poses);
        REQUIRE_FALSE(rows.empty());
        for (int row = 0; row < rows.size(); ++row) {
          for (const BodyId body : poses.indices()) {
            if (body == ground) continue;
            const Vec3<Real> jacobian = jacobian_of(rows[row], body);
            for (int coordinate = 0; coordinate < 3; ++coordinate) {
              const Real slope = difference_quotient(constraint.rows, row, poses, body, coordinate, h);
              CHECK(std::abs(jacobian(coordinate) - slope) <= tolerance);
            }
          }
        }
      });
}

TEST_CASE_TEMPLATE("every row's forces on its bodies cancel, and turn the world as a whole by nothing", Real,
                   float, double) {
  const Real tolerance =
      64 * std::numeric_limits<Real>::epsilon() * 10;  // [m] coordinates and arms are below 10 m
  const auto check_pair = [&](const RowSpec<Real>& row, const PerBody<Pose<Real>>& poses, Real drift) {
    Vec2<Real> sum = Vec2<Real>::Zero();
    Real torque = 0;
    for (const BodyId body : poses.indices()) {
      if (body == ground) continue;
      const Vec3<Real> jacobian = jacobian_of(row, body);
      const Vec2<Real> force = jacobian.template head<2>();
      sum += force;
      torque += cross(poses[body].position, force) + jacobian.z();
    }
    CHECK(sum.cwiseAbs().maxCoeff() == 0);
    CHECK(std::abs(torque) <= tolerance + drift);
  };
  // A pin that has drifted by C acts at two points, and turns the world by C x force.
  for_all_constraints<Real>(
      2, 0, [&](const ConstraintUnderTest<Real>& constraint, const PerBody<Pose<Real>>& poses) {
        if (!constraint.is_free) return;
        const RowSpecs<Real> rows = constraint.rows(poses);
        Real drift = 0;
        for (const RowSpec<Real>& row : rows)
          drift += row.bounds.is_equality() ? std::abs(row.error) : Real(0);
        for (const RowSpec<Real>& row : rows) check_pair(row, poses, drift);
      });
  test::Random random(3);
  for (int round = 0; round < random_rounds; ++round) {
    const PerBody<Pose<Real>> poses = poses_in<Real>(random_poses(random));
    const RowSpecs<Real> rows = contact_rows<Real>(circle(0.3, {0.1, 0.2}), box(4, 1), 0.5)(poses);
    REQUIRE(rows.size() % 2 == 0);
    for (const RowSpec<Real>& row : rows) check_pair(row, poses, 0);
  }
}

TEST_CASE("a joint has no error where it was made, and names the bodies and anchors it was given") {
  test::Random random(4);
  for (int round = 0; round < random_rounds; ++round) {
    const PerBody<Pose<double>> poses = random_poses(random);
    const Vec2<double> anchor_a = random.point(3), anchor_b = random.point(3);
    const DistanceJoint rod({.a = {1}, .b = {2}, .anchor_a = anchor_a, .anchor_b = anchor_b}, poses);
    const RevoluteJoint pin({.a = {2}, .b = {1}, .anchor = anchor_a}, poses);
    RowSpecs<double> rows = rows_of(rod, poses);
    pin.append_rows(poses, rows);
    REQUIRE(rows.size() == 3);
    const double tolerance = 64 * std::numeric_limits<double>::epsilon() * 10;  // [m] of numbers below 10 m
    for (const RowSpec<double>& row : rows) CHECK(std::abs(row.error) <= tolerance);
    CHECK(rod.attachments()[0].body == BodyId{1});
    CHECK(rod.attachments()[1].body == BodyId{2});
    CHECK(pin.attachments()[0].body == BodyId{2});
    CHECK(pin.attachments()[1].body == BodyId{1});
    CHECK((poses[{1}].world(rod.attachments()[0].anchor) - anchor_a).norm() <= tolerance);
    CHECK((poses[{2}].world(rod.attachments()[1].anchor) - anchor_b).norm() <= tolerance);
    CHECK((poses[{2}].world(pin.attachments()[0].anchor) - anchor_a).norm() <= tolerance);
    CHECK((poses[{1}].world(pin.attachments()[1].anchor) - anchor_a).norm() <= tolerance);
  }
}

TEST_CASE("a contact has a friction row behind each normal row, and none where mu is 0") {
  const PerBody<Pose<double>> poses = {{}, {{0, 0}, 0}, {{0, 1}, 0}};
  const RowSpecs<double> smooth = contact_rows<double>(box(1, 1), box(1, 1), 0)(poses);
  const RowSpecs<double> rough = contact_rows<double>(box(1, 1), box(1, 1), 0.5)(poses);
  CHECK(smooth.size() == 2);
  REQUIRE(rough.size() == 4);
  for (int i = 0; i < 4; i += 2) {
    CHECK(rough[i].bounds.is_unilateral());
    CHECK(rough[i].part == smooth[i / 2].part);
    CHECK(rough[i + 1].bounds.is_friction());
    CHECK(rough[i + 1].bounds.normal_row == i);
    CHECK(rough[i + 1].part == (rough[i].part | 1));
    // The normal is up, so that the tangent is to the right; all tangents of a manifold have one arm.
    CHECK(rough[i + 1].jacobian_b == rough[1].jacobian_b);
    CHECK(Vec2<double>(rough[i + 1].jacobian_b.head<2>()) == Vec2<double>(1, 0));
  }
}
