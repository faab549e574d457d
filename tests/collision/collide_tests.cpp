// Manifolds of shapes whose contact can be written down by hand.
#include <set>

#include "../geometry/random_shapes.hpp"
#include <cairn/collision/collide.hpp>
#include "testing.hpp"

namespace cairn {
namespace {

constexpr double collide_epsilon = std::numeric_limits<double>::epsilon();

Pose<double> at(double x, double y, double angle = 0) { return {{x, y}, angle}; }

std::set<std::uint32_t> features(const Manifold<double>& manifold) {
  std::set<std::uint32_t> result;
  for (int i = 0; i < manifold.count; ++i) result.insert(manifold.points[i].feature);
  return result;
}

TEST_CASE_TEMPLATE("a box flat on a box touches at the two corners with separation zero", Real, float,
                   double) {
  const Shape<Real> square = shape_cast<Real>(box(1, 1));
  const Pose<Real> below = {{3, 0}, 0};
  const Pose<Real> above = {{3, 1}, 0};
  const Manifold<Real> manifold = collide(square, below, square, above, Real(0.01));
  REQUIRE(manifold.count == 2);
  CHECK(manifold.normal == Vec2<Real>(0, 1));
  CHECK(manifold.points[0].separation == 0);
  CHECK(manifold.points[1].separation == 0);
  CHECK(std::abs(manifold.points[0].position.x() - 3) == Real(0.5));
  CHECK(manifold.points[0].position.x() + manifold.points[1].position.x() == 6);
  CHECK(manifold.points[0].feature != manifold.points[1].feature);
  // The arms about the tangent are the heights, identical to the last bit.
  const Vec2<Real> tangent = {1, 0};
  for (const Pose<Real>& pose : {below, above}) {
    const Vec2<Real> r_0 = manifold.points[0].position - pose.position;
    const Vec2<Real> r_1 = manifold.points[1].position - pose.position;
    CHECK(cross(r_0, tangent) == cross(r_1, tangent));
    CHECK(std::abs(cross(r_0, tangent)) == Real(0.5));
  }
}

TEST_CASE("a tilted box has points at one height, each with its own separation") {
  const double tilt = 0.01;
  const Manifold<double> manifold = collide<double>(box(4, 1), at(0, 0), box(1, 1), at(0, 1, tilt), 0.1);
  REQUIRE(manifold.count == 2);
  CHECK(manifold.points[0].position.y() == manifold.points[1].position.y());
  // The corners of the upper box are at 1 - cos / 2 -+ sin / 2, the face below is at 1 / 2.
  const double low = 0.5 - std::cos(tilt) / 2 - std::sin(tilt) / 2;
  const double high = 0.5 - std::cos(tilt) / 2 + std::sin(tilt) / 2;
  CHECK(std::min(manifold.points[0].separation, manifold.points[1].separation) ==
        doctest::Approx(low).epsilon(64 * collide_epsilon / tilt));
  CHECK(std::max(manifold.points[0].separation, manifold.points[1].separation) ==
        doctest::Approx(high).epsilon(64 * collide_epsilon / tilt));
  CHECK(std::abs(manifold.points[0].position.y() - (0.5 + (low + high) / 4)) <= 8 * collide_epsilon);
}

TEST_CASE("aligned boxes keep both points and their features while noise moves them") {
  const Manifold<double> still = collide<double>(box(1, 1), at(0, 0), box(1, 1), at(0, 1), 0.01);
  test::Random random(10);
  for (const double noise : {1e-17, 1e-16, 1e-12, 1e-8, 1e-5}) {
    for (int round = 0; round < 100; ++round) {
      const Pose<double> pose = {Vec2<double>(0, 1) + random.point(noise), random.uniform(-noise, noise)};
      const Manifold<double> manifold = collide<double>(box(1, 1), at(0, 0), box(1, 1), pose, 0.01);
      CHECK(manifold.count == 2);
      CHECK(features(manifold) == features(still));
    }
  }
}

TEST_CASE_TEMPLATE("boxes stacked in line touch at two points wherever the stack stands and leans", Real,
                   float, double) {
  test::Random random(9);
  for (int round = 0; round < 5000; ++round) {
    const double radius = random.below(2) == 0 ? 0 : 0.125;
    const double gap = std::pow(10, random.uniform(-16, -3)) * (random.below(2) == 0 ? 1 : -1);
    const Shape<Real> square = shape_cast<Real>(box(1, 1, radius));
    const Pose<Real> below = {random.point(100).cast<Real>(), static_cast<Real>(random.uniform(-4, 4))};
    const Vec2<Real> up = {0, static_cast<Real>(1 + 2 * radius) + static_cast<Real>(gap)};
    const Manifold<Real> manifold =
        collide(square, below, square, Pose<Real>{below.world(up), below.angle}, Real(0.01));
    REQUIRE(manifold.count == 2);
    // Positions of 100 m are rounded to 100 eps, and so is the gap.
    const Real tolerance = 200 * std::numeric_limits<Real>::epsilon();
    CHECK(std::abs(manifold.points[0].separation - static_cast<Real>(gap)) <= tolerance);
    CHECK(std::abs(manifold.points[1].separation - static_cast<Real>(gap)) <= tolerance);
  }
}

TEST_CASE("the reference face stays with the first shape at every size") {
  for (const double size : {1e-4, 1.0, 1e4}) {
    const Shape<double> square = box(size, size);
    const Manifold<double> still = collide<double>(square, at(0, 0), square, at(size / 2, size), size / 100);
    for (const double tilt : {-1e-4, -1e-8, 1e-8, 1e-4}) {
      const Pose<double> tilted = at(size / 2, size, tilt);
      CHECK(features(collide<double>(square, at(0, 0), square, tilted, size / 100)) == features(still));
    }
  }
}

TEST_CASE("a wide box on a narrow one is cut to the narrow one's width, whichever comes first") {
  const Manifold<double> wide_above = collide<double>(box(1, 1), at(0, 0), box(4, 1), at(0.3, 1), 0.01);
  const Manifold<double> wide_below = collide<double>(box(4, 1), at(0.3, -1), box(1, 1), at(0, 0), 0.01);
  for (const Manifold<double>& manifold : {wide_above, wide_below}) {
    REQUIRE(manifold.count == 2);
    CHECK(std::abs(manifold.points[0].position.x()) == doctest::Approx(0.5).epsilon(4 * collide_epsilon));
    CHECK(manifold.points[0].position.x() == doctest::Approx(-manifold.points[1].position.x()));
  }
}

TEST_CASE("boxes that meet at a corner touch in one point") {
  const Manifold<double> manifold = collide<double>(box(1, 1), at(0, 0), box(1, 1), at(1, 1), 0.01);
  REQUIRE(manifold.count == 1);
  CHECK(manifold.points[0].separation == 0);
  CHECK((manifold.points[0].position - Vec2<double>(0.5, 0.5)).norm() <= 2 * collide_epsilon);
}

TEST_CASE("a box that stands on its corner keeps its feature while it tips over") {
  const double half_diagonal = std::sqrt(0.5);
  const Manifold<double> upright =
      collide<double>(box(4, 1), at(0, 0), box(1, 1), at(0, 0.5 + half_diagonal, pi / 4), 0.01);
  REQUIRE(upright.count == 1);
  for (const double tilt : {-1e-3, -1e-15, 1e-15, 1e-3}) {
    const Pose<double> tilted = at(0, 0.5 + half_diagonal, pi / 4 + tilt);
    CHECK(features(collide<double>(box(4, 1), at(0, 0), box(1, 1), tilted, 0.01)) == features(upright));
  }
}

TEST_CASE("corners that are apart are as far apart as their distance") {
  const Manifold<double> sharp = collide<double>(box(1, 1), at(0, 0), box(1, 1), at(1.3, 1.4), 1);
  REQUIRE(sharp.count == 1);
  CHECK(sharp.points[0].separation == doctest::Approx(0.5).epsilon(4 * collide_epsilon));  // 3, 4, 5
  CHECK((sharp.normal - Vec2<double>(0.6, 0.8)).norm() <= 4 * collide_epsilon);
  CHECK((sharp.points[0].position - Vec2<double>(0.65, 0.7)).norm() <= 4 * collide_epsilon);

  const Manifold<double> rounded = collide<double>(box(1, 1, 0.2), at(0, 0), box(1, 1, 0.1), at(1.3, 1.4), 1);
  REQUIRE(rounded.count == 1);
  CHECK(rounded.points[0].separation == doctest::Approx(0.2).epsilon(16 * collide_epsilon));
  // 0.2 of the first radius and half of the gap from the corner (0.5, 0.5).
  CHECK((rounded.points[0].position - Vec2<double>(0.68, 0.74)).norm() <= 8 * collide_epsilon);
}

TEST_CASE("discs touch on the line of their centres") {
  const Manifold<double> manifold = collide<double>(circle(1), at(0, 0), circle(2), at(3, 4), 3);
  REQUIRE(manifold.count == 1);
  CHECK(manifold.points[0].separation == 2);
  CHECK((manifold.normal - Vec2<double>(0.6, 0.8)).norm() <= 2 * collide_epsilon);
  CHECK((manifold.points[0].position - Vec2<double>(1.2, 1.6)).norm() <= 4 * collide_epsilon);
}

TEST_CASE_TEMPLATE("shapes with the same centre have a unit normal and the full depth", Real, float, double) {
  const Pose<Real> pose = {{7, -3}, 1};
  const Shape<Real> disc = shape_cast<Real>(circle(0.5));
  const Manifold<Real> discs = collide(disc, pose, disc, pose, Real(0));
  REQUIRE(discs.count == 1);
  CHECK(discs.normal == Vec2<Real>(0, 1));
  CHECK(discs.points[0].separation == -1);
  test::Random random(11);
  for (int kind = 0; kind < test::shape_kinds; ++kind) {
    const Shape<Real> shape = shape_cast<Real>(test::random_shape(kind, random));
    const Manifold<Real> manifold = collide(shape, pose, shape, pose, Real(0.01));
    CAPTURE(kind);
    CHECK(manifold.count >= 1);
    CHECK(std::abs(manifold.normal.norm() - 1) <= 4 * std::numeric_limits<Real>::epsilon());
    CHECK(manifold.points[0].position.allFinite());
  }
}

TEST_CASE("a disc on the line of a segment, on a corner and in a box has a unit normal") {
  const Shape<double> line = segment({-1, 0}, {1, 0});
  const Manifold<double> on_line = collide<double>(line, at(0, 0), circle(0.5), at(0.2, 0), 0);
  REQUIRE(on_line.count == 1);
  CHECK(std::abs(on_line.normal.y()) == 1);
  CHECK(on_line.points[0].separation == -0.5);
  const Manifold<double> at_end = collide<double>(line, at(0, 0), circle(0.5), at(1.25, 0), 0);
  REQUIRE(at_end.count == 1);
  CHECK(at_end.normal == Vec2<double>(1, 0));
  CHECK(at_end.points[0].separation == -0.25);
  const Manifold<double> on_corner = collide<double>(box(1, 1), at(0, 0), circle(0.5), at(0.5, 0.5), 0);
  REQUIRE(on_corner.count == 1);
  CHECK(on_corner.normal.norm() == 1);
  CHECK(on_corner.points[0].separation == -0.5);
  const Manifold<double> inside = collide<double>(box(1, 1), at(0, 0), circle(0.5), at(0.25, 0.1), 0);
  REQUIRE(inside.count == 1);
  CHECK(inside.normal == Vec2<double>(1, 0));
  CHECK(inside.points[0].separation == -0.75);
}

TEST_CASE("a segment collides on both sides") {
  const Shape<double> line = segment({-1, 0}, {1, 0});
  for (const double side : {-1.0, 1.0}) {
    const Manifold<double> manifold = collide<double>(line, at(0, 0), box(1, 1), at(0, 0.5 * side), 0.01);
    REQUIRE(manifold.count == 2);
    CHECK(manifold.normal == Vec2<double>(0, side));
    CHECK(manifold.points[0].separation == 0);
  }
}

TEST_CASE("segments touch only within the margin") {
  const Shape<double> line = segment({-1, 0}, {1, 0});
  CHECK(collide<double>(line, at(0, 0), line, at(0, 0.1), 0).count == 0);
  CHECK(collide<double>(line, at(0, 0), line, at(0, 0.1), 0.05).count == 0);
  const Manifold<double> beside = collide<double>(line, at(0, 0), line, at(0.5, 0.1), 0.2);
  REQUIRE(beside.count == 2);
  CHECK(beside.points[0].separation == 0.1);
  const Manifold<double> end_to_end = collide<double>(line, at(0, 0), line, at(2.25, 0), 0.5);
  REQUIRE(end_to_end.count == 1);
  CHECK(end_to_end.points[0].separation == 0.25);
  CHECK(end_to_end.normal == Vec2<double>(1, 0));
  // Two crossed segments overlap by the shorter way out: 0.5 along the second one.
  const Manifold<double> crossed = collide<double>(line, at(0, 0), line, at(0, 0.5, pi / 2), 0.01);
  REQUIRE(crossed.count >= 1);
  CHECK(crossed.points[0].separation == doctest::Approx(-0.5).epsilon(8 * collide_epsilon));
  CHECK((crossed.normal - Vec2<double>(0, 1)).norm() <= 8 * collide_epsilon);
}

TEST_CASE("capsules that lie in one line, end to end, touch at their round ends") {
  const Shape<double> pill = capsule({-1, 0}, {1, 0}, 0.5);
  for (const double angle : {0.0, 0.3, 1.0, 2.5}) {
    const Rotation<double> turn(angle);
    const Vec2<double> along = turn * Vec2<double>(1, 0);
    const Pose<double> next = {along * 2.75, angle};
    const Manifold<double> manifold = collide<double>(pill, at(0, 0, angle), pill, next, 0);
    REQUIRE(manifold.count == 1);
    CHECK(manifold.points[0].separation == doctest::Approx(-0.25).epsilon(32 * collide_epsilon));
    CHECK((manifold.normal - along).norm() <= 32 * collide_epsilon);
  }
}

TEST_CASE("a point is reported when its separation is below the margin, and not at the margin") {
  CHECK(collide<double>(circle(1), at(0, 0), circle(1), at(2.5, 0), 0.5).count == 0);
  CHECK(collide<double>(circle(1), at(0, 0), circle(1), at(2.5, 0), 0.5 + 2 * collide_epsilon).count == 1);
  CHECK(collide<double>(box(1, 1), at(0, 0), box(1, 1), at(0, 1.5), 0.5).count == 0);
}

TEST_CASE_TEMPLATE("far from the origin nothing becomes not-a-number", Real, float, double) {
  test::Random random(12);
  for (const double far : {1e4, 1e7, 1e12, 1e30}) {
    for (int round = 0; round < 100; ++round) {
      const Shape<Real> a = shape_cast<Real>(test::random_shape(random.below(test::shape_kinds), random));
      const Shape<Real> b = shape_cast<Real>(test::random_shape(random.below(test::shape_kinds), random));
      const Vec2<double> place = random.point(far);
      const Pose<Real> pose_a = {place.cast<Real>(), static_cast<Real>(random.uniform(-9, 9))};
      const Pose<Real> pose_b = {(place + random.point(1)).cast<Real>(),
                                 static_cast<Real>(random.uniform(-9, 9))};
      const Manifold<Real> manifold = collide(a, pose_a, b, pose_b, Real(0.1));
      for (int i = 0; i < manifold.count; ++i) {
        const ManifoldPoint<Real>& point = manifold.points[i];
        CHECK(point.position.allFinite());
        CHECK(std::isfinite(point.separation));
        CHECK(std::abs(manifold.normal.norm() - 1) <= 8 * std::numeric_limits<Real>::epsilon());
      }
    }
  }
}

TEST_CASE("a pose that is not a number touches nothing") {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  test::Random random(13);
  for (int kind = 0; kind < test::shape_kinds; ++kind) {
    const Shape<double> shape = test::random_shape(kind, random);
    const Shape<double> other = test::random_shape(random.below(test::shape_kinds), random);
    CHECK(collide(shape, at(not_a_number, 0), other, at(0, 0), 1.0).count == 0);
    CHECK(collide(shape, at(0, 0), other, at(0, not_a_number), 1.0).count == 0);
    CHECK(collide(shape, at(0, 0, not_a_number), other, at(0, 0), 1.0).count == 0);
  }
}

}  // namespace
}  // namespace cairn
