// Outlines that are not convex, and the convex pieces they become.
#include "testing.hpp"

#include <cairn/geometry/mass.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

using Points = List<Vec2<double>>;

Points scaled(Points points, double scale, const Vec2<double>& offset = {0, 0}) {
  for (Vec2<double>& point : points) point = scale * point + offset;
  return points;
}

Points turned_round(const Points& points) { return {points.as_vector().rbegin(), points.as_vector().rend()}; }

/// An L of width `a`, height `b` and arms `t` thick.
Points ell(double a, double b, double t) { return {{0, 0}, {a, 0}, {a, t}, {t, t}, {t, b}, {0, b}}; }

/// A star with `rays` tips at `outer` from its middle, and corners between them at `inner`.
Points star(int rays, double outer, double inner) {
  Points points;
  for (int i = 0; i < 2 * rays; ++i) {
    const double angle = pi * i / rays, radius = i % 2 == 0 ? outer : inner;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return points;
}

/// A comb with `teeth` teeth of width 1, 1 apart, on a back 1 thick: many corners in line with each other.
Points comb(int teeth) {
  Points points = {{0, 0}, {2.0 * teeth - 1, 0}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double x = 2.0 * i;
    if (i < teeth - 1) points.push_back({x + 1, 1});
    points.push_back({x + 1, 3});
    points.push_back({x, 3});
    if (i > 0) points.push_back({x, 1});
  }
  return points;
}

/// The shoelace formula and those of second order, for any outline: exact.
MassProperties of_outline(const Points& points) {
  double area = 0, second = 0;
  Vec2<double> first = {0, 0};
  for (const int i : points.indices()) {
    const Vec2<double>&a = points[i], &b = points[(i + 1) % points.size()];
    const double twice = cross(a, b);
    area += twice / 2;
    first += twice / 6 * (a + b);
    second += twice / 12 * (a.dot(a) + a.dot(b) + b.dot(b));
  }
  const Vec2<double> centroid = first / area;
  return {std::abs(area), centroid, std::abs(second - area * centroid.squaredNorm())};
}

void check_pieces(const Points& points, int most_pieces) {
  const List<Shape<double>> pieces = outline(points);
  CHECK(pieces.size() <= most_pieces);
  const MassProperties got = mass_properties(pieces), expected = of_outline(points);
  // Sums of as many terms as there are corners.
  const double within = 1e-12 * points.size();
  CHECK(got.area == doctest::Approx(expected.area).epsilon(within));
  CHECK(got.inertia == doctest::Approx(expected.inertia).epsilon(within));
  CHECK((got.centroid - expected.centroid).norm() <= within * std::sqrt(expected.area));
  for (const Shape<double>& piece : pieces) {
    CHECK(std::get<Polygon<double>>(piece).vertices.size() <= max_polygon_vertices);
    CHECK(std::get<Polygon<double>>(piece).is_piece == (pieces.size() > 1));
  }
}

}  // namespace

TEST_CASE("area, centre and inertia of an L and a star are those of their formulas") {
  const MassProperties l = mass_properties(outline(ell(3, 4, 1)));
  CHECK(l.area == doctest::Approx(3 + 4 - 1));
  CHECK(l.centroid.x() == doctest::Approx((3 * 1.5 + 3 * 0.5) / 6));
  CHECK(l.centroid.y() == doctest::Approx((3 * 0.5 + 3 * 2.5) / 6));
  // Two boxes of area 3 each, from (1.5, 0.5) and (0.5, 2.5) to the middle between them.
  CHECK(l.inertia == doctest::Approx(2 * 3 * (9.0 + 1) / 12 + 2 * 3 * (0.25 + 1)));
  // A star is 2 n triangles with two sides R and r and the angle pi/n between them.
  const int n = 5;
  const double outer = 2, inner = 0.8, angle = pi / n;
  const MassProperties s = mass_properties(outline(star(n, outer, inner)));
  const double area = n * outer * inner * std::sin(angle);
  CHECK(s.area == doctest::Approx(area));
  CHECK(s.centroid.norm() <= 1e-14);
  CHECK(s.inertia ==
        doctest::Approx(area / 6 * (outer * outer + inner * inner + outer * inner * std::cos(angle))));
}

TEST_CASE("an outline of any form becomes few convex pieces with its area, centre and inertia") {
  check_pieces(ell(3, 4, 1), 2);
  check_pieces(turned_round(ell(3, 4, 1)), 2);
  check_pieces(star(5, 2, 0.8), 6);
  check_pieces(star(40, 2, 0.8), 160);
  check_pieces(comb(2), 3);
  check_pieces(comb(10), 4 * 11);  // teeth and a back would do
  check_pieces({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 3);  // a U
  check_pieces({{0, 0}, {2, 1}, {4, 0}, {2, 5}}, 2);                                  // an arrow
  Points spiral;
  for (int i = 0; i < 60; ++i)
    spiral.push_back({(1 + 0.2 * i) * std::cos(0.3 * i), (1 + 0.2 * i) * std::sin(0.3 * i)});
  for (int i = 59; i >= 0; --i)
    spiral.push_back({(2 + 0.2 * i) * std::cos(0.3 * i), (2 + 0.2 * i) * std::sin(0.3 * i)});
  check_pieces(spiral, 119);
}

TEST_CASE("tiny, huge, far and thin outlines are cut, too") {
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) check_pieces(scaled(star(7, 2, 0.5), scale), 10);
  // As if it stood at the origin, up to roundings of its place squared.
  const MassProperties near = mass_properties(outline(ell(3, 4, 1)));
  const MassProperties far = mass_properties(outline(scaled(ell(3, 4, 1), 1, {100, -200})));
  CHECK(far.area == doctest::Approx(near.area).epsilon(1e-11));
  CHECK(far.inertia == doctest::Approx(near.inertia).epsilon(1e-9));
  check_pieces(ell(3, 4, 1e-3), 2);
}

TEST_CASE("a convex outline stays one polygon, with more than 16 corners several") {
  const Points square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  REQUIRE(outline(square).size() == 1);
  CHECK(std::get<Polygon<double>>(outline(square)[0]) == polygon(square));
  check_pieces(star(8, 1, 0.95), 1);
  check_pieces(star(20, 1, 0.999), 3);
}

TEST_CASE("outlines that are none are refused, and told why") {
  const Points bow = {{0, 0}, {2, 2}, {2, 0}, {0, 2}};
  CHECK_THROWS_WITH_AS(
      outline(bow),
      "outline: edges must be apart (2.82843e-06 m and more): an outline does not cross or touch "
      "itself, got points[0] to points[1] and points[2] to points[3]",
      std::invalid_argument);
  CHECK_THROWS_AS(outline({{0, 0}, {1, 0}}), std::invalid_argument);
  CHECK_THROWS_AS(outline({{0, 0}, {1, 0}, {0, 1}, {1, 0}}), std::invalid_argument);  // twice
  CHECK_THROWS_AS(outline({{0, 0}, {1, 0}, {2, 0}}), std::invalid_argument);          // no area
  CHECK_THROWS_AS(outline({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}),
                  std::invalid_argument);  // touches itself
  CHECK_THROWS_AS(outline({{0, 0}, {2, 0}, {2, NAN}, {0, 2}}), std::invalid_argument);
  CHECK_THROWS_AS(outline(Points(501, {1, 1})), std::invalid_argument);
}
