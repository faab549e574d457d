// Mass properties against closed forms, and against an integral over the boundary.
#include "random_shapes.hpp"
#include "testing.hpp"

namespace cairn {
namespace {

constexpr double mass_epsilon = std::numeric_limits<double>::epsilon();

struct Integral {
  double area = 0;
  Vec2<double> centroid = {0, 0};
  double inertia = 0;
  double missing = 0;  // [m^2], a bound of the area between the shape and the polygon that was integrated
};

/// Green's theorem over the polygon through many points of the boundary.
Integral integrate(const Shape<double>& shape) {
  constexpr int directions = 20000;
  const test::Core core = test::core(shape, Pose<double>{});
  List<Vec2<long double>> boundary;
  for (int i = 0; i < directions; ++i) {
    const Rotation<long double> turn =
        test::exact_rotation(2 * std::numbers::pi_v<long double> * i / directions);
    const Vec2<long double> out = {turn.c, turn.s};
    boundary.emplace_back(test::farthest_corner(core, out) + core.radius * out);
  }
  long double area = 0;
  long double about_origin = 0;
  long double perimeter = 0;
  Vec2<long double> first_moment = {0, 0};
  for (int i = 0; i < boundary.size(); ++i) {
    const Vec2<long double>& p = boundary[i];
    const Vec2<long double>& q = boundary[(i + 1) % boundary.size()];
    const long double twice = cross(p, q);
    area += twice / 2;
    first_moment += (p + q) * twice / 6;
    about_origin += twice * (p.squaredNorm() + p.dot(q) + q.squaredNorm()) / 12;
    perimeter += (q - p).norm();
  }
  const Vec2<long double> centroid = first_moment / area;
  // No chord is farther from the boundary than the sagitta of an arc of one direction step.
  const long double sagitta = core.radius * (1 - std::cos(2 * std::numbers::pi_v<long double> / directions));
  return {static_cast<double>(area), centroid.cast<double>(),
          static_cast<double>(about_origin - area * centroid.squaredNorm()),
          static_cast<double>(perimeter * sagitta)};
}

TEST_CASE("a disc of mass m has the inertia m r^2 / 2 about its centre, wherever that is") {
  const MassProperties mass = mass_properties(circle(0.3, {1, 2}));
  CHECK(mass.area == doctest::Approx(pi * 0.09).epsilon(4 * mass_epsilon));
  CHECK(mass.centroid == Vec2<double>(1, 2));
  CHECK(mass.inertia == doctest::Approx(mass.area * 0.09 / 2).epsilon(4 * mass_epsilon));
}

TEST_CASE("a box of mass m has the inertia m (w^2 + h^2) / 12") {
  const MassProperties mass = mass_properties(box(2, 0.5));
  CHECK(mass.area == doctest::Approx(1).epsilon(4 * mass_epsilon));
  CHECK(mass.centroid.norm() <= 4 * mass_epsilon);
  CHECK(mass.inertia == doctest::Approx(4.25 / 12).epsilon(16 * mass_epsilon));
}

TEST_CASE("a rounded box is a box, four strips and a disc in quarters") {
  const double w = 2;
  const double h = 0.5;
  const double r = 0.2;
  const MassProperties mass = mass_properties(box(w, h, r));
  CHECK(mass.area == doctest::Approx(w * h + 2 * (w + h) * r + pi * r * r).epsilon(16 * mass_epsilon));
  CHECK(mass.centroid.norm() <= 16 * mass_epsilon);
  const double core = w * h * (w * w + h * h) / 12;
  const double along_w = 2 * w * r * ((w * w + r * r) / 12 + (h + r) * (h + r) / 4);
  const double along_h = 2 * h * r * ((h * h + r * r) / 12 + (w + r) * (w + r) / 4);
  const double quarters =
      pi * r * r * (w * w + h * h) / 4 + 4 * (w + h) * r * r * r / 3 + pi * r * r * r * r / 2;
  CHECK(mass.inertia == doctest::Approx(core + along_w + along_h + quarters).epsilon(64 * mass_epsilon));
}

TEST_CASE("a capsule is a box with two half discs") {
  const double r = 0.25;
  const double length = 1.5;
  const MassProperties mass = mass_properties(capsule({1, 1}, {1, 1 + length}, r));
  CHECK(mass.area == doctest::Approx(2 * r * length + pi * r * r).epsilon(8 * mass_epsilon));
  CHECK((mass.centroid - Vec2<double>(1, 1.75)).norm() <= 4 * mass_epsilon);
  // A half disc has its centroid 4 r / (3 pi) from its centre and the inertia m r^2 / 2 about that centre.
  const double half = pi * r * r / 2;
  const double out = 4 * r / (3 * pi);
  const double about_own = half * r * r / 2 - half * out * out;
  const double ends = 2 * (about_own + half * (length / 2 + out) * (length / 2 + out));
  const double middle = 2 * r * length * (length * length + 4 * r * r) / 12;
  CHECK(mass.inertia == doctest::Approx(middle + ends).epsilon(32 * mass_epsilon));
}

TEST_CASE("a segment has no mass") {
  const MassProperties mass = mass_properties(segment({0, 0}, {2, 0}));
  CHECK(mass.area == 0);
  CHECK(mass.inertia == 0);
}

TEST_CASE("two halves have the mass of the whole") {
  const List<Shape<double>> halves = {moved(box(1, 0.5), {-0.5, 3}), moved(box(1, 0.5), {0.5, 3})};
  const MassProperties together = mass_properties(halves);
  CHECK(together.area == doctest::Approx(1).epsilon(8 * mass_epsilon));
  CHECK((together.centroid - Vec2<double>(0, 3)).norm() <= 16 * mass_epsilon);
  CHECK(together.inertia == doctest::Approx(4.25 / 12).epsilon(64 * mass_epsilon));
}

TEST_CASE("nothing, or segments alone, have mass properties zero") {
  const MassProperties nothing = mass_properties(Span<const Shape<double>>{});
  CHECK(nothing.area == 0);
  CHECK(nothing.inertia == 0);
  const List<Shape<double>> lines = {segment({1, 0}, {2, 0})};
  CHECK(mass_properties(lines).centroid == Vec2<double>(0, 0));
}

TEST_CASE("the mass properties of any shape agree with an integral over its boundary") {
  test::Random random(2);
  for (int round = 0; round < 40; ++round) {
    const Shape<double> shape = test::random_shape(round % 4, random);
    const MassProperties mass = mass_properties(shape);
    const Integral expected = integrate(shape);
    const double reach = bounding_radius(shape);
    // What is missing lies within `reach` of the origin; 64 eps for the sums of either side.
    const double tolerance = expected.missing + 64 * mass_epsilon * reach * reach;
    CAPTURE(round);
    CHECK(std::abs(mass.area - expected.area) <= tolerance);
    CHECK((mass.centroid - expected.centroid).norm() * mass.area <= 2 * reach * tolerance);
    CHECK(std::abs(mass.inertia - expected.inertia) <= 4 * reach * reach * tolerance);
  }
}

TEST_CASE("turning and moving a shape changes neither its area nor its inertia, and carries the centroid") {
  test::Random random(3);
  for (int round = 0; round < 40; ++round) {
    const Shape<double> shape = test::random_shape(round % 4, random);
    const Vec2<double> offset = random.point(10);
    const double angle = random.uniform(-pi, pi);
    const MassProperties before = mass_properties(shape);
    const MassProperties after = mass_properties(moved(shape, offset, angle));
    // Corners 10 m away are rounded by 10 eps each; the inertia of 1 m shapes follows with a factor of few.
    CHECK(std::abs(after.area - before.area) <= 256 * mass_epsilon);
    CHECK(std::abs(after.inertia - before.inertia) <= 256 * mass_epsilon);
    CHECK((after.centroid - Pose<double>{offset, angle}.world(before.centroid)).norm() <= 256 * mass_epsilon);
  }
}

}  // namespace
}  // namespace cairn
