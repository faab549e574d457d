// When two shapes on their way come near each other, by closed forms.
#include "testing.hpp"

using namespace cairn;

namespace {

constexpr double near_by = 1e-4;  // [m]

Course<double> course(const Vec2<double>& from, const Vec2<double>& speed, double turn = 0,
                      double radius = 0) {
  return {{from, 0}, {speed.x(), speed.y(), turn}, radius};
}

}  // namespace

TEST_CASE("two discs come near when the circle around both says so") {
  // |d + t v| = r + s, with d = (4, 0.3), v = (-20, 0), r + s = 0.5 + near / 2.
  const Shape<double> disc = circle(0.2), other = circle(0.3);
  const Approach<double> met =
      approach<double>(disc, course({0, 0}, {5, 1}), other, course({4, 0.3}, {-15, 1}), 1, near_by);
  for (const double gap : {0.0, near_by}) {
    const double time = (4 - std::sqrt((0.5 + gap) * (0.5 + gap) - 0.09)) / 20;
    CHECK(met.time == doctest::Approx(time).epsilon(1e-4));
  }
  CHECK(met.separation <= near_by);
  CHECK(met.separation >= 0);
}

TEST_CASE("what goes by is near no time, and is as near as it comes where it begins to part") {
  // The least distance of a point from the origin's disc: 0.7 m aside, less both radii.
  const Shape<double> disc = circle(0.2), other = circle(0.3);
  const Approach<double> met =
      approach<double>(disc, course({0, 0}, {0, 0}), other, course({4, 0.7}, {-20, 0}), 1, near_by);
  CHECK(met.separation > near_by);
  CHECK(met.separation < 3.5);
  const Approach<double> parting =
      approach<double>(disc, course({0, 0}, {0, 0}), other, course({4, 0.7}, {20, 0}), 1, near_by);
  CHECK(parting.time == 0);
  const Approach<double> slow =
      approach<double>(disc, course({0, 0}, {0, 0}), other, course({4, 0}, {-1, 0}), 1, near_by);
  CHECK(slow.time == 1);
  CHECK(slow.separation == doctest::Approx(4 - 1 - 0.5).epsilon(1e-12));
}

TEST_CASE("boxes are near at their faces, and at their corners where those come first") {
  const Shape<double> a = box(2, 1), b = box(1, 1);
  const Approach<double> faces =
      approach<double>(a, course({0, 0}, {0, 0}), b, course({0.9, 5}, {3, -8}), 1, near_by);
  CHECK(faces.time == doctest::Approx((5 - 1) / 8.0).epsilon(1e-4));
  const Approach<double> missed =
      approach<double>(a, course({0, 0}, {0, 0}), b, course({0.9, 5}, {4, -8}), 1, near_by);
  CHECK(missed.separation > near_by);
}

TEST_CASE("what stays beyond a distance all the while is told of at once, with less than it is away") {
  // 4 m above, and 2 m of them are left after a second: as near as 2 m, and no nearer.
  const Shape<double> a = box(2, 1), b = box(1, 1);
  const auto met = [&](double far) {
    return approach<double>(a, course({0, 0}, {0, 0}), b, course({0.3, 5}, {20, -2}), 1, near_by, far);
  };
  CHECK(met(1.9).time == 0);
  CHECK(met(1.9).separation == doctest::Approx(4).epsilon(1e-15));
  CHECK(met(2.1).time > 0);
  CHECK(met(2.1).separation > near_by);
}

TEST_CASE("a bar that turns is near a post when the angle between them says so") {
  // A bar of half thickness d comes to a post at (2, h) of radius r once it has turned by w t, where the
  // distance of the post from the middle line of the bar is h cos(w t) - 2 sin(w t) = r + d.
  const double w = 10, r = 0.1, d = 0.05, h = 1;
  const double far = std::hypot(2.0, h), at = std::atan2(h, 2.0) - std::asin((r + d) / far);
  const double length = 6, reach = std::hypot(length / 2, d);
  const Approach<double> met =
      approach<double>(Shape<double>(box(length, 2 * d)), course({0, 0}, {0, 0}, w, reach), circle(r),
                       course({2, h}, {0, 0}), 0.2, near_by);
  CHECK(met.time == doctest::Approx(at / w).epsilon(1e-3));
  CHECK(met.time <= at / w);
  CHECK(met.separation <= near_by);
}

TEST_CASE("a disc that spins comes no nearer") {
  const Approach<double> met = approach<double>(Shape<double>(circle(0.5)), course({0, 0}, {0, 0}, 1e4),
                                                circle(0.5), course({1.1, 0}, {0, 0}, -1e4), 1, near_by);
  CHECK(met.time == 0);
  CHECK(met.separation == doctest::Approx(0.1).epsilon(1e-12));
}

TEST_CASE("shapes that touch or overlap are near now") {
  for (const double x : {0.0, 0.2, 0.999}) {
    const Approach<double> met = approach<double>(Shape<double>(box(1, 1)), course({0, 0}, {9, 0}), box(1, 1),
                                                  course({x, 0.1}, {-9, 0}), 1, near_by);
    CHECK(met.time == 0);
    CHECK(met.separation < 0);
  }
}

TEST_CASE("along a direction two shapes are apart by the way between them less how far both reach") {
  const double half = std::sqrt(0.5);  // of a box of 1 m the corner, on its diagonal
  const Shape<double> square = box(1, 1), disc = circle(0.5);
  const Frame<double> here, there = Pose<double>{{3, 0}, pi / 4};
  CHECK(gap_along<double>({1, 0}, square, here, square, there) == doctest::Approx(3 - 0.5 - half));
  CHECK(gap_along<double>({0, 1}, square, here, square, there) == doctest::Approx(-0.5 - half));
  CHECK(gap_along<double>({half, half}, square, here, square, there) ==
        doctest::Approx(half * 3 - half - 0.5));
  CHECK(gap_along<double>({half, half}, disc, here, disc, there) == doctest::Approx(half * 3 - 1));
  CHECK(gap_along<double>({1, 0}, capsule({0, -1}, {0, 1}, 0.1), here, segment({0, -1}, {0, 1}), there) ==
        doctest::Approx(3 - 0.1 - half));
}
