// What of a shape lies below a level, against its whole and against what is known of halves.
#include <doctest/doctest.h>

#include <cairn/geometry/immersion.hpp>
#include <cairn/geometry/mass.hpp>
#include "geometry/random_shapes.hpp"

using namespace cairn;
using test::Random;

TEST_CASE("what is below a level and what is above it are the whole of a shape") {
  Random random(7);
  for (int trial = 0; trial < 400; ++trial) {
    const Shape<double> shape = test::random_shape(trial % test::shape_kinds, random);
    const double angle = random.uniform(-pi, pi), tilt = random.uniform(-pi, pi),
                 level = random.uniform(-0.8, 0.8);
    const Vec2<double> up = Rotation<double>(tilt) * Vec2<double>(1, 0);
    const AreaMoments below = immersed(shape, angle, up, level), above = immersed(shape, angle, -up, -level);
    const MassProperties whole = mass_properties(shape);
    const Vec2<double> center = Rotation<double>(angle) * whole.centroid;
    CAPTURE(trial);
    // Sums of some hundred terms below 10.
    const double rounding = 1e-13;
    CHECK(std::abs(below.area + above.area - whole.area) < rounding);
    CHECK((below.first + above.first - whole.area * center).norm() < rounding);
    CHECK(std::abs(below.polar + above.polar - whole.inertia - whole.area * center.squaredNorm()) < rounding);
    CHECK(below.area >= -rounding);
    CHECK(up.dot(below.first) <= level * below.area + rounding);
  }
}

TEST_CASE("half of a disc and half of a box are where they are known to be, at every size") {
  for (const double size : {1e-6, 1e-3, 1.0, 1e3, 1e6}) {
    CAPTURE(size);
    const AreaMoments disc = immersed(circle(size), 0.3, {0, 1}, 0);
    CHECK(disc.area == doctest::Approx(pi * size * size / 2).epsilon(1e-14));
    CHECK(disc.first.y() / disc.area == doctest::Approx(-4 * size / (3 * pi)).epsilon(1e-14));
    CHECK(disc.polar == doctest::Approx(pi * std::pow(size, 4) / 4).epsilon(1e-14));
    const AreaMoments block = immersed(box(2 * size, size), 0, {0, 1}, 0);
    CHECK(block.area == doctest::Approx(size * size).epsilon(1e-14));
    CHECK(block.first.y() / block.area == doctest::Approx(-size / 4).epsilon(1e-14));
    CHECK(std::abs(block.first.x()) <= 1e-14 * std::pow(size, 3));
  }
}

TEST_CASE("a shape above the level has nothing below it, and segments and chains never have") {
  CHECK(immersed(box(1, 1), 0.7, {0, 1}, -0.8).area == 0);
  CHECK(immersed(circle(1), 0, {0, 1}, -1).area == 0);
  CHECK(immersed(segment({0, 0}, {1, 0}), 0, {0, 1}, 5).area == 0);
  CHECK(immersed(chain({{1, 0}, {0, 0}}), 0, {0, 1}, 5).area == 0);
}
