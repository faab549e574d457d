// Making chains: what is refused, with which words, and how they go on at their ends.
#include "testing.hpp"

namespace cairn {
namespace {

std::string chain_refusal(const List<Vec2<double>>& points, const ChainEnds& ends = {}) {
  return testing::message_of([&] { chain(points, ends); });
}

}  // namespace

TEST_CASE("a refused chain names the point, the rule and the value") {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(chain_refusal({}) == "chain: number of points must be at least 2, got 0");
  CHECK(chain_refusal({{0, 0}}) == "chain: number of points must be at least 2, got 1");
  CHECK(chain_refusal({{0, 0}, {1, 0}}, {.closed = true}) ==
        "chain: number of points must be at least 3, got 2");
  CHECK(chain_refusal({{0, 0}, {infinity, 0}}) ==
        "chain: points[1] must be finite numbers of m, got (inf, 0)");
  CHECK(chain_refusal({{0, nan}, {1, 0}}) == "chain: points[0] must be finite numbers of m, got (0, nan)");
  CHECK(chain_refusal({{0, 0}, {1, 0}, {1, 0}}) ==
        "chain: points[2] must be farther than 1e-06 m from the point beside it, got (1, 0)");
  CHECK(chain_refusal({{0, 0}, {1, 0}, {0, 1}, {0, 0}}, {.closed = true}) ==
        "chain: points[0] must be farther than 1e-06 m from the point beside it, got (0, 0)");
  CHECK(chain_refusal({{0, 0}, {2, 0}, {1, 0}}) ==
        "chain: points[1] must be a corner that does not turn straight back, got (2, 0)");
  CHECK(chain_refusal({{0, 0}, {1, 0}}, {.before = Vec2<double>(0, 0)}) ==
        "chain: before must be farther than 1e-06 m from the point beside it, got (0, 0)");
  CHECK(chain_refusal({{0, 0}, {1, 0}}, {.after = Vec2<double>(nan, 0)}) ==
        "chain: after must be finite numbers of m, got (nan, 0)");
  CHECK(chain_refusal({{0, 0}, {1, 0}}, {.after = Vec2<double>(0.5, 0)}) ==
        "chain: points[1] must be a corner that does not turn straight back, got (1, 0)");
  CHECK(chain_refusal({{0, 0}, {1, 0}, {0, 1}}, {.closed = true, .before = Vec2<double>(5, 5)}) ==
        "chain: closed must be false beside points before or after it, got true");
}

TEST_CASE("an open chain goes on straight unless it is told otherwise, a closed one goes round") {
  const Chain<double> open = chain({{0, 0}, {1, 0}, {1, 2}});
  CHECK(open.link_count() == 2);
  CHECK(open.point(-1) == Vec2<double>(-1, 0));
  CHECK(open.point(3) == Vec2<double>(1, 4));
  const Chain<double> bent =
      chain({{0, 0}, {1, 0}}, {.before = Vec2<double>(0, 1), .after = Vec2<double>(2, 1)});
  CHECK(bent.point(-1) == Vec2<double>(0, 1));
  CHECK(bent.point(2) == Vec2<double>(2, 1));
  const Chain<double> closed = chain({{0, 0}, {1, 0}, {0, 1}}, {.closed = true});
  CHECK(closed.link_count() == 3);
  CHECK(closed.point(-1) == Vec2<double>(0, 1));
  CHECK(closed.point(4) == Vec2<double>(1, 0));
}

TEST_CASE("a chain has a box and a circle around it, no mass, and as many pieces as links") {
  const Shape<double> line = chain({{0, 0}, {3, 4}, {-1, 2}});
  const Aabb<double> box = bounding_box(line, Pose<double>{});
  CHECK(box.lower == Vec2<double>(-1, 0));
  CHECK(box.upper == Vec2<double>(3, 4));
  CHECK(bounding_radius(line) == 5);
  CHECK(mass_properties(line).area == 0);
  CHECK(shape_name(line) == "chain");
  CHECK(piece_count(line) == 2);
  CHECK(piece_count<double>(circle(1)) == 1);
}

TEST_CASE("a chain that is moved or cast takes its ends along") {
  const Shape<double> line = moved(chain({{0, 0}, {1, 0}}), {0, 5}, pi / 2);
  const auto& turned = std::get<Chain<double>>(line);
  CHECK((turned.before - Vec2<double>(0, 4)).norm() < 1e-15);
  CHECK((turned.after - Vec2<double>(0, 7)).norm() < 1e-15);
  const auto cast = std::get<Chain<float>>(shape_cast<float>(line));
  CHECK(cast.points.size() == 2);
  CHECK((cast.after - Vec2<float>(0, 7)).norm() < 1e-6f);
  CHECK_FALSE(cast.closed);
}

}  // namespace cairn
