// The broadphases against each other and against the definition.
#include "../geometry/random_shapes.hpp"
#include "testing.hpp"

namespace cairn {
namespace {

using Pairs = List<std::pair<int, int>>;

template <Scalar Real>
struct Crowd {
  List<Aabb<Real>> boxes;
  List<char> movable;

  void add(const Vec2<double>& lower, const Vec2<double>& upper) {
    boxes.push_back({lower.cast<Real>(), upper.cast<Real>()});
    movable.push_back(1);
  }
  Pairs pairs(BroadphaseKind kind) const { return Broadphase<Real>(kind).pairs(boxes, movable); }
};

/// Boxes in a wide or a tall region, on a coarse grid so that many edges coincide.
template <Scalar Real>
Crowd<Real> random_crowd(int count, test::Random& random) {
  Crowd<Real> crowd;
  const Vec2<double> region = {random.uniform(1, 30), random.uniform(1, 30)};
  for (int i = 0; i < count; ++i) {
    const Vec2<double> place = {random.uniform(0, region.x()), random.uniform(0, region.y())};
    const Vec2<double> lower = {std::floor(place.x() * 2) / 2, std::floor(place.y() * 2) / 2};
    crowd.add(lower, lower + Vec2<double>(random.below(4) * 0.5, random.below(4) * 0.5));
    crowd.movable.back() = random.below(4) > 0 ? 1 : 0;
  }
  return crowd;
}

TEST_CASE_TEMPLATE("both broadphases find the same pairs in the same order", Real, float, double) {
  test::Random random(6);
  for (int round = 0; round < 200; ++round) {
    const Crowd<Real> crowd = random_crowd<Real>(random.below(60), random);
    const Pairs expected = crowd.pairs(BroadphaseKind::all_pairs);
    CHECK(crowd.pairs(BroadphaseKind::grid) == expected);
    CHECK(std::is_sorted(expected.begin(), expected.end()));
    for (const auto& [i, j] : expected) CHECK(i < j);
  }
}

TEST_CASE_TEMPLATE("sizes of every magnitude, and places as far out as numbers go, make the same pairs", Real,
                   float, double) {
  test::Random random(9);
  for (int round = 0; round < 200; ++round) {
    Crowd<Real> crowd;
    const double far = std::pow(10.0, random.uniform(-3, 30));
    for (int i = 0; i < 60; ++i) {
      const double side = std::pow(10.0, random.uniform(-12, 6));
      const Vec2<double> lower = {random.uniform(-1, 1) * (i % 3 == 0 ? far : side),
                                  random.uniform(-1, 1) * (i % 5 == 0 ? far : side)};
      crowd.add(lower, lower + Vec2<double>(side, random.uniform(0, 1) * side));
    }
    CHECK(crowd.pairs(BroadphaseKind::grid) == crowd.pairs(BroadphaseKind::all_pairs));
  }
}

TEST_CASE_TEMPLATE("boxes that fill their cells to the last bit are found", Real, float, double) {
  test::Random random(10);
  for (int round = 0; round < 200; ++round) {
    Crowd<Real> crowd;
    const int base = random.below(1000000) + 1;
    for (int i = 0; i < 60; ++i) {
      // Sides of a power of two, and their neighbours, at places where such a side is a few roundings.
      Vec2<Real> lower(static_cast<Real>(base + random.below(3)), static_cast<Real>(random.below(3)));
      const Real side = std::ldexp(Real(1), random.below(3) - 1);
      Vec2<Real> upper = lower + Vec2<Real>(side, side);
      const Real end = random.below(2) == 0 ? Real(0) : std::numeric_limits<Real>::infinity();
      if (random.below(3) != 0) upper.x() = std::nextafter(upper.x(), end);
      if (random.below(3) != 0) lower.x() = std::nextafter(lower.x(), end);
      crowd.boxes.push_back({lower, upper});
      crowd.movable.push_back(1);
    }
    CHECK(crowd.pairs(BroadphaseKind::grid) == crowd.pairs(BroadphaseKind::all_pairs));
  }
}

TEST_CASE("a pair is found when its boxes overlap or touch, and one of the two can move") {
  for (const BroadphaseKind kind : {BroadphaseKind::all_pairs, BroadphaseKind::grid}) {
    Crowd<double> crowd;
    crowd.add({0, 0}, {1, 1});
    crowd.add({5, 0}, {6, 1});
    crowd.add({1, 0}, {2, 1});  // touches the first
    crowd.add({0, 0}, {9, 9});  // holds all others
    CHECK(crowd.pairs(kind) == Pairs{{0, 2}, {0, 3}, {1, 3}, {2, 3}});
    crowd.movable = {0, 1, 0, 0};
    CHECK(crowd.pairs(kind) == Pairs{{1, 3}});
  }
}

TEST_CASE("no boxes, equal boxes, points and boxes without end are all in order") {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const BroadphaseKind kind : {BroadphaseKind::all_pairs, BroadphaseKind::grid}) {
    Crowd<double> crowd;
    CHECK(crowd.pairs(kind).empty());
    crowd.add({0, 0}, {0, 0});
    CHECK(crowd.pairs(kind).empty());
    crowd.add({0, 0}, {0, 0});
    crowd.add({0, 0}, {0, 0});
    CHECK(crowd.pairs(kind) == Pairs{{0, 1}, {0, 2}, {1, 2}});
    crowd.add({-infinity, -infinity}, {infinity, infinity});
    CHECK(crowd.pairs(kind) == Pairs{{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}});
  }
}

TEST_CASE_TEMPLATE("boxes that are not numbers overlap nothing and disturb nobody", Real, float, double) {
  constexpr Real not_a_number = std::numeric_limits<Real>::quiet_NaN();
  test::Random random(7);
  for (int round = 0; round < 200; ++round) {
    Crowd<Real> crowd = random_crowd<Real>(40, random);
    List<char> broken(40, 0);
    for (int i = 0; i < 40; ++i) {
      if (random.below(4) != 0) continue;
      broken[i] = 1;
      Vec2<Real>& corner = random.below(2) == 0 ? crowd.boxes[i].lower : crowd.boxes[i].upper;
      corner[random.below(2)] = not_a_number;
    }
    const Pairs pairs = crowd.pairs(BroadphaseKind::grid);
    CHECK(pairs == crowd.pairs(BroadphaseKind::all_pairs));
    for (const auto& [i, j] : pairs) {
      CHECK(!broken[i]);
      CHECK(!broken[j]);
    }
  }
}

TEST_CASE_TEMPLATE("boxes that are put elsewhere overlap what they would had they always been there", Real,
                   float, double) {
  test::Random random(11);
  const auto random_box = [&random] {
    const double side = std::pow(10.0, random.uniform(-3, 3));
    const double far = std::pow(10.0, random.below(8) == 0 ? random.uniform(0, 30) : 1);
    const Vec2<double> lower = {random.uniform(-far, far), random.uniform(-far, far)};
    const Vec2<double> upper = lower + Vec2<double>(side, random.uniform(0, 1) * side);
    return Aabb<Real>{lower.cast<Real>(), upper.cast<Real>()};
  };
  const int count = 60;
  List<Aabb<Real>> boxes(count);
  Broadphase<Real> grid(BroadphaseKind::grid);
  grid.reset(count);
  for (int round = 0; round < 200; ++round) {
    for (int i = 0; i < count; ++i) {
      if (round == 0 || random.below(4) == 0) grid.put(i, boxes[i] = random_box());
    }
    const int i = random.below(count);
    List<int> overlapping = grid.overlapping(i), expected;
    std::sort(overlapping.begin(), overlapping.end());
    for (int j = 0; j < count; ++j) {
      if (j != i && boxes[i].overlaps(boxes[j])) expected.push_back(j);
    }
    CHECK(overlapping == expected);
  }
}

TEST_CASE("a broadphase that is used again remembers nothing") {
  test::Random random(8);
  Broadphase<double> grid(BroadphaseKind::grid);
  for (int round = 0; round < 50; ++round) {
    const Crowd<double> crowd = random_crowd<double>(random.below(60), random);
    CHECK(grid.pairs(crowd.boxes, crowd.movable) == crowd.pairs(BroadphaseKind::all_pairs));
  }
}

TEST_CASE("more pairs than a step has room for are refused, before they are all written down") {
  for (const BroadphaseKind kind : {BroadphaseKind::all_pairs, BroadphaseKind::grid}) {
    Crowd<double> crowd;
    for (int i = 0; i < 1414; ++i) crowd.add({0, 0}, {1, 1});
    CHECK(crowd.pairs(kind).size() == 1414 * 1413 / 2);
    crowd.add({0, 0}, {1, 1});
    CHECK_THROWS_AS(crowd.pairs(kind), std::length_error);
  }
}

}  // namespace
}  // namespace cairn
