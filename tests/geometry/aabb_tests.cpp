// Bounding boxes against the farthest points of the shapes.
#include "random_shapes.hpp"
#include "testing.hpp"

namespace cairn {
namespace {

TEST_CASE_TEMPLATE("a bounding box touches the shape on all four sides", Real, float, double) {
  test::Random random(4);
  for (int round = 0; round < 200; ++round) {
    const Shape<Real> shape = shape_cast<Real>(test::random_shape(round % test::shape_kinds, random));
    const Pose<Real> pose = {random.point(10).cast<Real>(), static_cast<Real>(random.uniform(-10, 10))};
    const Real margin = static_cast<Real>(random.uniform(0, 0.1));
    const Aabb<Real> box = bounding_box(shape, pose, margin);
    const test::Core core = test::core(shape, pose);
    const long double grown = core.radius + margin;
    // Coordinates below 12 m go through a rotation and four sums, each rounded once.
    const long double tolerance = 6 * 12 * std::numeric_limits<Real>::epsilon();
    CAPTURE(round);
    CHECK(std::abs(box.upper.x() - (test::farthest_corner(core, {1, 0}).x() + grown)) <= tolerance);
    CHECK(std::abs(box.upper.y() - (test::farthest_corner(core, {0, 1}).y() + grown)) <= tolerance);
    CHECK(std::abs(box.lower.x() - (test::farthest_corner(core, {-1, 0}).x() - grown)) <= tolerance);
    CHECK(std::abs(box.lower.y() - (test::farthest_corner(core, {0, -1}).y() - grown)) <= tolerance);
  }
}

TEST_CASE_TEMPLATE("a bounding circle touches the shape and holds all of it", Real, float, double) {
  test::Random random(5);
  for (int round = 0; round < 200; ++round) {
    const Shape<Real> shape = shape_cast<Real>(test::random_shape(round % test::shape_kinds, random));
    const test::Core core = test::core(shape, Pose<Real>{});
    long double farthest = 0;
    for (const Vec2<long double>& corner : core.corners) farthest = std::max(farthest, corner.norm());
    const long double tolerance = 4 * std::numeric_limits<Real>::epsilon();
    CHECK(std::abs(bounding_radius(shape) - (farthest + core.radius)) <= tolerance);
  }
}

TEST_CASE("boxes that share no more than an edge overlap") {
  const Shape<double> square = box(1, 1);
  const Aabb<double> left = bounding_box(square, Pose<double>{{0, 0}, 0});
  CHECK(left.overlaps(bounding_box(square, Pose<double>{{1, 0}, 0})));
  CHECK(!left.overlaps(bounding_box(square, Pose<double>{{1.001, 0}, 0})));
  CHECK(left.overlaps(bounding_box(square, Pose<double>{{1.001, 0}, 0}, 0.01)));
  CHECK(!left.overlaps(bounding_box(square, Pose<double>{{0, -1.001}, 0})));
}

TEST_CASE("the box of a pose that is not a number overlaps nothing") {
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  const Shape<double> square = box(1, 1);
  const Aabb<double> here = bounding_box(square, Pose<double>{});
  CHECK(!here.overlaps(bounding_box(square, Pose<double>{{not_a_number, 0}, 0})));
  CHECK(!here.overlaps(bounding_box(square, Pose<double>{{0, 0}, not_a_number})));
}

}  // namespace
}  // namespace cairn
