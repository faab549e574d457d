// Making shapes: what is refused, with which words, and what is stored.
#include "random_shapes.hpp"
#include "testing.hpp"

namespace cairn {

using testing::message_of;

namespace {

constexpr double shape_infinity = std::numeric_limits<double>::infinity();
constexpr double shape_not_a_number = std::numeric_limits<double>::quiet_NaN();

std::string polygon_refusal(const List<Vec2<double>>& points) {
  return message_of([&] { polygon(points); });
}

bool says(const std::string& message, const std::string& part) {
  return message.find(part) != std::string::npos;
}

/// A star with five points, drawn in one line that crosses itself.
List<Vec2<double>> pentagram() {
  List<Vec2<double>> points;
  for (int i = 0; i < 5; ++i) points.emplace_back(std::cos(0.8 * pi * i), std::sin(0.8 * pi * i));
  return points;
}

List<Vec2<double>> regular(int count) {
  List<Vec2<double>> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(std::cos(2 * pi * i / count), std::sin(2 * pi * i / count));
  return points;
}

TEST_CASE("a refused shape names maker, field, rule, unit and value") {
  CHECK(message_of([] { circle(-1); }) == "circle: radius must be > 0 m, got -1");
  CHECK(message_of([] { circle(0); }) == "circle: radius must be > 0 m, got 0");
  CHECK(message_of([] { circle(shape_not_a_number); }) == "circle: radius must be > 0 m, got nan");
  CHECK(message_of([] { circle(shape_infinity); }) == "circle: radius must be a finite number of m, got inf");
  CHECK(message_of([] {
          circle(1, {0, shape_infinity});
        }) == "circle: center must be finite numbers of m, got (0, inf)");
  CHECK(message_of([] { capsule({0, 0}, {1, 0}, 0); }) == "capsule: radius must be > 0 m, got 0");
  CHECK(message_of([] {
          capsule({1, 2}, {1, 2}, 1);
        }) == "capsule: point2 must be another point than point1, got (1, 2)");
  CHECK(message_of([] {
          segment({1, 2}, {1, 2});
        }) == "segment: point2 must be another point than point1, got (1, 2)");
  CHECK(message_of([] {
          segment({shape_not_a_number, 2}, {1, 2});
        }) == "segment: point1 must be finite numbers of m, got (nan, 2)");
  CHECK(message_of([] { box(0, 1); }) == "box: width must be > 0 m, got 0");
  CHECK(message_of([] { box(1, -0.1); }) == "box: height must be > 0 m, got -0.1");
  CHECK(message_of([] { box(1, 1, -0.5); }) == "box: radius must be >= 0 m, got -0.5");
  CHECK(message_of([] { box(1, shape_infinity); }) == "box: height must be a finite number of m, got inf");
  CHECK(message_of([] {
          moved(circle(1), {shape_not_a_number, 0});
        }) == "moved: offset must be finite numbers of m, got (nan, 0)");
  CHECK(message_of([] {
          moved(circle(1), {0, 0}, shape_infinity);
        }) == "moved: angle must be a finite number of rad, got inf");
}

TEST_CASE("a polygon that is not a convex area is refused, and the message names the point") {
  CHECK(polygon_refusal({{0, 0}, {1, 0}}) == "polygon: number of points must be 3 to 16, got 2");
  CHECK(polygon_refusal(regular(17)) == "polygon: number of points must be 3 to 16, got 17");
  CHECK(polygon_refusal(regular(16)) == "");
  CHECK(polygon_refusal({{0, 0}, {1, 0}, {0, shape_not_a_number}}) ==
        "polygon: points[2] must be finite numbers of m, got (0, nan)");
  CHECK(polygon_refusal({{0, 0}, {3, 0}, {3, 4}, {0, 0}}) ==
        "polygon: points[3] must be farther than 5e-06 m from points[0], got (0, 0)");
  CHECK(says(polygon_refusal({{0, 0}, {1, 0}, {1, 1}, {1, 1 + 1e-8}}), "points[3]"));
  CHECK(says(polygon_refusal({{0, 0}, {1, 0}, {2, 0}}), "polygon: area must be >"));
  CHECK(says(polygon_refusal({{0, 0}, {1, 0}, {0.5, 1e-9}}), "polygon: area must be >"));
  CHECK(polygon_refusal({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}) ==
        "polygon: points[1] must be out of line with its neighbours, got (1, 0)");
  CHECK(polygon_refusal({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}}) ==
        "polygon: points[3] must be a corner that turns outwards (convex), got (1, 0.5)");
  CHECK(says(polygon_refusal({{0, 0}, {2, 1}, {2, 0}, {0, 2}}), "(convex)"));  // a bow tie
  CHECK(polygon_refusal(pentagram()) ==
        "polygon: number of turns around the inside must be 1 (the edges cross), got 2");
  CHECK(message_of([] { polygon(regular(3), -1); }) == "polygon: radius must be >= 0 m, got -1");
  CHECK(says(polygon_refusal({{0, 0}, {1e300, 0}, {0, 1e300}}), "polygon: area"));
  CHECK(polygon_refusal({{0, 0}, {1e-300, 0}, {0, 1e-300}}) != "");  // its area is 0 in double
}

TEST_CASE("a clockwise polygon names the points as they were given") {
  CHECK(polygon_refusal({{0, 2}, {1, 0.5}, {2, 2}, {2, 0}, {0, 0}}) ==
        "polygon: points[1] must be a corner that turns outwards (convex), got (1, 0.5)");
}

TEST_CASE("a polygon is stored counter-clockwise with outward unit normals, whichever way it was given") {
  test::Random random(1);
  for (int round = 0; round < 100; ++round) {
    const Polygon<double> forward = std::get<Polygon<double>>(test::random_shape(2, random));
    List<Vec2<double>> points = forward.vertices;
    std::reverse(points.begin(), points.end());
    const Polygon<double> backward = polygon(points);
    for (const Polygon<double>& shape : {forward, backward}) {
      for (int i = 0; i < shape.vertices.size(); ++i) {
        const Vec2<double>& normal = shape.normals[i];
        // Each component is rounded once, by at most half an ulp.
        CHECK(std::abs(normal.norm() - 1) <= 2 * std::numeric_limits<double>::epsilon());
        for (int j = 0; j < shape.vertices.size(); ++j) {
          const Vec2<double> arm = shape.vertices[j] - shape.vertices[i];
          const bool on_the_edge = j == i || j == (i + 1) % shape.vertices.size();
          if (on_the_edge) CHECK(std::abs(normal.dot(arm)) <= 4 * std::numeric_limits<double>::epsilon());
          if (!on_the_edge) CHECK(normal.dot(arm) < 0);
        }
      }
    }
  }
}

TEST_CASE("a box has its normals exactly along the axes, in every scalar") {
  const Polygon<float> shape = std::get<Polygon<float>>(shape_cast<float>(box(0.1, 0.3)));
  CHECK(shape.normals[0] == Vec2<float>(0, -1));
  CHECK(shape.normals[1] == Vec2<float>(1, 0));
  CHECK(shape.normals[2] == Vec2<float>(0, 1));
  CHECK(shape.normals[3] == Vec2<float>(-1, 0));
}

TEST_CASE("a shape is turned about the origin first and moved then") {
  const Circle<double> round = std::get<Circle<double>>(moved(circle(0.5, {1, 0}), {10, 20}, pi / 2));
  // cos(pi / 2) is 6e-17 in double; 20 + 1 is exact.
  CHECK(std::abs(round.center.x() - 10) <= 2e-15);
  CHECK(round.center.y() == 21);
  const Polygon<double> square = std::get<Polygon<double>>(moved(box(2, 2), {1, 1}));
  CHECK(square.vertices[0] == Vec2<double>(0, 0));
  CHECK(square.normals[0] == Vec2<double>(0, -1));
}

TEST_CASE("a polygon moved so far that its corners coincide is refused") {
  CHECK(says(message_of([] { moved(box(1, 1), {1e17, 0}); }), "another point than the next"));
}

TEST_CASE("every shape has a name") {
  CHECK(shape_name(circle(1)) == "circle");
  CHECK(shape_name(capsule({0, 0}, {1, 0}, 1)) == "capsule");
  CHECK(shape_name(box(1, 1)) == "polygon");
  CHECK(shape_name(segment({0, 0}, {1, 0})) == "segment");
}

}  // namespace
}  // namespace cairn
