// What lies beside a static shape: tiles give the contacts of the block that they make.
#include <cairn/collision/collide.hpp>
#include "geometry/random_shapes.hpp"
#include "testing.hpp"

namespace cairn {
namespace {

using Around = std::optional<Neighbours<double>>;
using EndKind = FaceEnd<double>::Kind;

List<Around> around_of(const List<Shape<double>>& shapes) {
  List<StillShape> still;
  for (const Shape<double>& shape : shapes) still.push_back({&shape});
  return find_neighbours(still);
}

/// From x = left to right, and from y = bottom to top.
Shape<double> tile(double left, double right, double bottom, double top) {
  return moved(box(right - left, top - bottom), {(left + right) / 2, (bottom + top) / 2});
}

// Faces of a box, in order: below, right, above, left; vertex 2 is at the upper right.
constexpr int right_face = 1, upper_face = 2, left_face = 3;

/// A block 6 m wide and 1 m high below y = 0, in tiles of many widths and so many layers.
List<Shape<double>> block_of_tiles(int layers) {
  const List<double> at = {-3, -2.5, -1, -0.9, 0.4, 1, 1.75, 3};
  List<Shape<double>> tiles;
  for (int i = 0; i + 1 < at.size(); ++i) {
    for (int k = 0; k < layers; ++k) {
      const double height = 1.0 / layers;
      tiles.push_back(tile(at[i], at[i + 1], -1 + k * height, -1 + (k + 1) * height));
    }
  }
  return tiles;
}

struct Deepest {
  double separation = std::numeric_limits<double>::infinity();  // [m]
  double slope = 0;                                             // of the normal that is farthest from upright
};

void take_in(const Manifold<double>& manifold, Deepest& deepest) {
  for (int i = 0; i < manifold.count; ++i) {
    deepest.separation = std::min(deepest.separation, manifold.points[i].separation);
    deepest.slope = std::max(deepest.slope, std::abs(manifold.normal.x()));
  }
}

struct Visitor {
  Shape<double> shape = {};
  Pose<double> pose = {};
};

/// Up to 40 mm deep in the block's surface, or in its margin.
Visitor random_visitor(int round, double margin, test::Random& random) {
  Visitor visitor;
  const double size = random.uniform(0.1, 1.2);
  const List<Shape<double>> kinds = {circle(size / 2),
                                     box(size, random.uniform(0.1, 1.2)),
                                     box(size, 0.02),
                                     capsule({-size / 2, 0}, {size / 2, 0}, random.uniform(0.05, 0.3)),
                                     polygon({{-0.3, 0}, {0.3, -0.1}, {0.2, 0.5}}),
                                     box(size, size, 0.05)};
  visitor.shape = kinds[round % kinds.size()];
  const double tilt = round % 3 == 0 ? 0 : round % 3 == 1 ? 0.01 : 3;
  visitor.pose = {{random.uniform(-4, 4), 0}, random.uniform(-tilt, tilt)};
  const double bottom = bounding_box(visitor.shape, Frame<double>(visitor.pose)).lower.y();
  visitor.pose.position.y() = -bottom + random.uniform(-0.02, margin + 0.001);
  return visitor;
}

/// Whether it touches both: a whole, and what was made of parts.
bool check_as_deep(const Visitor& visitor, const Deepest& whole, const Deepest& parts) {
  CAPTURE(visitor.pose.position.x());
  CAPTURE(visitor.pose.position.y());
  CAPTURE(visitor.pose.angle);
  // Of two faces that are within 5e-4 of the smaller size as far apart either may be the reference, and the
  // size of these is below 2 m. Tilted by d, lengths on one and on the other differ by d^2 / 2 too.
  const bool both_miss = std::isinf(whole.separation) && std::isinf(parts.separation);
  CHECK((both_miss || std::abs(whole.separation - parts.separation) < 1e-3));
  return !both_miss;
}

}  // namespace

TEST_CASE("tiles side by side and on each other touch what the block that they make touches, as deep") {
  test::Random random(29);
  const Shape<double> block = tile(-3, 3, -1, 0);
  for (const int layers : {1, 2}) {
    const List<Shape<double>> tiles = block_of_tiles(layers);
    const List<Around> around = around_of(tiles);
    for (const double margin : {0.0, 0.02, 0.3}) {
      for (int round = 0; round < 3000; ++round) {
        const Visitor visitor = random_visitor(round, margin, random);
        const bool block_first = round % 2 == 0;
        Deepest whole, parts;
        const auto touch = [&](const Shape<double>& still, const Neighbours<double>* beside, Deepest& into) {
          const Pose<double> origin;
          take_in(block_first
                      ? collide(still, origin, visitor.shape, visitor.pose, margin, {beside, nullptr})
                      : collide(visitor.shape, visitor.pose, still, origin, margin, {nullptr, beside}),
                  into);
        };
        touch(block, nullptr, whole);
        for (const int i : tiles.indices()) touch(tiles[i], around[i] ? &*around[i] : nullptr, parts);
        CAPTURE(layers);
        CAPTURE(margin);
        CAPTURE(round);
        check_as_deep(visitor, whole, parts);
        const bool is_inside = std::abs(visitor.pose.position.x()) < 2;
        if (is_inside && !std::isinf(parts.separation)) CHECK(parts.slope <= whole.slope + 1e-6);
      }
    }
  }
}

TEST_CASE("a closed chain around a polygon touches what the polygon touches, as deep, on its outer side") {
  test::Random random(31);
  const double slop = 0.005;  // [m]
  int touching = 0;
  for (const int corners : {5, 12}) {
    List<Vec2<double>> points;
    for (int i = 0; i < corners; ++i) {
      points.push_back({2 * std::cos(2 * pi * i / corners), 2 * std::sin(2 * pi * i / corners)});
    }
    const Shape<double> whole = polygon(points);
    const Chain<double> around = chain(points, {.closed = true});
    for (const double margin : {0.0, 0.02, 0.3}) {
      for (int round = 0; round < 3000; ++round) {
        Visitor visitor = random_visitor(round, margin, random);
        // Turned about the middle of the polygon, whose corners come nearer to it than its edges.
        const double turn = random.uniform(-pi, pi), apothem = 2 * std::cos(pi / corners);
        visitor.pose.position = Rotation<double>(turn) * Vec2<double>(0, visitor.pose.position.y() + apothem);
        visitor.pose.angle += turn;
        const Pose<double> origin;
        Deepest polygon_touch, chain_touch;
        take_in(collide(whole, origin, visitor.shape, visitor.pose, margin), polygon_touch);
        for (int i = 0; i < around.link_count(); ++i) {
          const Neighbours<double> beside = link_neighbours(around, i);
          const Shape<double> link = Segment<double>{around.point(i), around.point(i + 1)};
          take_in(collide(link, origin, visitor.shape, visitor.pose, margin, {&beside, nullptr}),
                  chain_touch);
        }
        CAPTURE(corners);
        CAPTURE(margin);
        CAPTURE(round);
        if (polygon_touch.separation < -slop) continue;  // what is deep has its middle behind a link
        touching += check_as_deep(visitor, polygon_touch, chain_touch) ? 1 : 0;
      }
    }
  }
  CHECK(touching > 3000);
}

TEST_CASE("the side between two level tiles is covered, and their common corner has one normal") {
  const List<Around> around = around_of({tile(-1, 0, -1, 0), tile(0, 1, -1, 0)});
  REQUIRE(around[0]);
  REQUIRE(around[1]);
  CHECK(around[0]->faces[right_face].is_covered());
  CHECK_FALSE(around[0]->faces[left_face].is_covered());
  CHECK(around[1]->faces[left_face].is_covered());
  const auto& corner = around[0]->corners[2];
  REQUIRE(corner.count == 1);
  CHECK((corner.cones[0].from - Vec2<double>(0, 1)).norm() < 1e-15);
  CHECK(corner.cones[0].from == corner.cones[0].to);
  CHECK(around[0]->corners[3].is_alone);
  CHECK(around[0]->faces[upper_face].start.kind == EndKind::neighbour);
  CHECK(around[0]->faces[upper_face].end.kind == EndKind::corner);
}

TEST_CASE("a side is covered as far as its neighbour reaches, and a step leaves a valley at its foot") {
  const List<Around> step = around_of({tile(-1, 0, -1, 0), tile(0, 1, -1, 0.2)});
  REQUIRE(step[0]);
  REQUIRE(step[1]);
  const auto& wall = step[1]->faces[left_face];  // runs downwards from y = 0.2
  CHECK(wall.first == 0);
  CHECK(wall.last == doctest::Approx(0.2));
  CHECK(step[1]->corners[3].is_alone);
  CHECK(step[0]->faces[right_face].is_covered());
  CHECK(step[0]->corners[2].count == 0);
  CHECK_FALSE(step[0]->corners[2].is_alone);
  CHECK(step[0]->faces[upper_face].start.kind == EndKind::valley);
  CHECK(step[0]->faces[upper_face].start.rise == doctest::Approx(1));
  // Covered in the middle, it is met at both ends, and so as a whole.
  CHECK_FALSE(around_of({tile(-1, 0, -1, 0), tile(0, 1, -1.5, 0.2)})[1]);
  const List<Around> deeper = around_of({tile(-1, 0, -1, 0), tile(0, 1, -1.5, 0)});
  REQUIRE(deeper[1]);
  CHECK(deeper[1]->faces[left_face].first == doctest::Approx(1));
  CHECK(deeper[1]->faces[left_face].last == doctest::Approx(1.5));
}

TEST_CASE("segments that share an end have the normals between theirs outside, and none inside") {
  const double angle = 0.1;
  const List<Around> bent =
      around_of({segment({-1, 0}, {0, 0}), segment({0, 0}, {std::cos(angle), -std::sin(angle)})});
  REQUIRE(bent[0]);
  const auto& ridge = bent[0]->corners[1];
  REQUIRE(ridge.count == 1);
  CHECK((ridge.cones[0].to - Vec2<double>(0, 1)).norm() < 1e-15);
  CHECK((ridge.cones[0].from - Vec2<double>(std::sin(angle), std::cos(angle))).norm() < 1e-15);
  const List<Around> straight = around_of({segment({-1, 0}, {0, 0}), segment({0, 0}, {1, 0})});
  REQUIRE(straight[0]);
  CHECK(straight[0]->corners[1].count == 2);  // one on each side
  CHECK(straight[0]->corners[0].is_alone);
}

TEST_CASE(
    "shapes that nothing touches, that lie apart, or are of another group or radius have no neighbours") {
  CHECK_FALSE(around_of({tile(-1, 0, -1, 0)})[0]);
  CHECK_FALSE(around_of({tile(-1, 0, -1, 0), tile(0.01, 1, -1, 0)})[0]);
  CHECK_FALSE(around_of({tile(-1, 0, -1, 0), circle(1, {1, 0})})[0]);
  CHECK_FALSE(around_of({tile(-1, 0, -1, 0), moved(box(0.8, 0.8, 0.1), {0.5, -0.5})})[0]);
  const Shape<double> left = tile(-1, 0, -1, 0), right = tile(0, 1, -1, 0);
  const List<StillShape> apart = {{&left, {}, 0}, {&right, {}, 1}};
  CHECK_FALSE(find_neighbours(apart)[0]);
}

TEST_CASE("a gap counts as closed, and tops as level, up to 5e-4 of the smaller tile's size") {
  const double size = std::sqrt(2.0);  // of tiles of 1 m
  for (const double share : {0.5, 0.9}) {
    const double off = share * level_share * size;
    const List<Around> gap = around_of({tile(-1, 0, -1, 0), tile(off, 1 + off, -1, 0)});
    REQUIRE(gap[0]);
    CHECK(gap[0]->faces[right_face].is_covered());
    const List<Around> lower = around_of({tile(-1, 0, -1, 0), tile(0, 1, -1 - off, -off)});
    REQUIRE(lower[0]);
    CHECK(lower[0]->faces[right_face].is_covered());
    CHECK(lower[0]->corners[2].count == 1);
  }
  const double off = 3 * level_share * size;
  CHECK_FALSE(around_of({tile(-1, 0, -1, 0), tile(off, 1 + off, -1, 0)})[0]);
  const List<Around> step = around_of({tile(-1, 0, -1, 0), tile(0, 1, -1 - off, -off)});
  REQUIRE(step[0]);
  CHECK_FALSE(step[0]->faces[right_face].is_covered());
}

TEST_CASE("a link of a chain has its back covered, and the normals between it and the next") {
  const Chain<double> hill = chain({{1, -1}, {0, 0}, {-1, 0}, {-2, 1}});
  const Neighbours<double> first = link_neighbours(hill, 0), second = link_neighbours(hill, 1);
  CHECK(first.one_sided);
  CHECK(first.faces[1].is_covered());
  CHECK(first.faces[0].start.kind == EndKind::neighbour);  // straight on
  CHECK(first.faces[0].end.kind == EndKind::neighbour);    // over a ridge
  CHECK(first.corners[1] == second.corners[0]);
  CHECK((first.corners[1].cones[0].from - Vec2<double>(1, 1).normalized()).norm() < 1e-15);
  CHECK((first.corners[1].cones[0].to - Vec2<double>(0, 1)).norm() < 1e-15);
  CHECK(second.faces[0].end.kind == EndKind::valley);
  CHECK(second.faces[0].end.rise == doctest::Approx(std::sqrt(0.5)));
  CHECK(second.corners[1].count == 0);
}

}  // namespace cairn
