// The broadphases against each other and against the definition.
#include <doctest/doctest.h>

#include <limits>
#include <stdexcept>

#include "../geometry/random_shapes.hpp"
#include "collision/broadphase.hpp"
#include "math/list.hpp"

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

TEST_CASE_TEMPLATE("both broadphases find the same pairs in the same order", Real, float, double,
                   long double) {
  test::Random random(6);
  for (int round = 0; round < 200; ++round) {
    const Crowd<Real> crowd = random_crowd<Real>(random.below(60), random);
    const Pairs expected = crowd.pairs(BroadphaseKind::all_pairs);
    CHECK(crowd.pairs(BroadphaseKind::sweep) == expected);
    CHECK(std::is_sorted(expected.begin(), expected.end()));
    for (const auto& [i, j] : expected) CHECK(i < j);
  }
}

TEST_CASE("a pair is found when its boxes overlap or touch, and one of the two can move") {
  for (const BroadphaseKind kind : {BroadphaseKind::all_pairs, BroadphaseKind::sweep}) {
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
  for (const BroadphaseKind kind : {BroadphaseKind::all_pairs, BroadphaseKind::sweep}) {
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

TEST_CASE_TEMPLATE("boxes that are not numbers overlap nothing and disturb nobody", Real, float, double,
                   long double) {
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
    const Pairs pairs = crowd.pairs(BroadphaseKind::sweep);
    CHECK(pairs == crowd.pairs(BroadphaseKind::all_pairs));
    for (const auto& [i, j] : pairs) {
      CHECK(!broken[i]);
      CHECK(!broken[j]);
    }
  }
}

TEST_CASE("a broadphase that is used again remembers nothing") {
  test::Random random(8);
  Broadphase<double> sweep(BroadphaseKind::sweep);
  for (int round = 0; round < 50; ++round) {
    const Crowd<double> crowd = random_crowd<double>(random.below(60), random);
    CHECK(sweep.pairs(crowd.boxes, crowd.movable) == crowd.pairs(BroadphaseKind::all_pairs));
  }
}

TEST_CASE("more pairs than a step has room for are refused, before they are all written down") {
  for (const BroadphaseKind kind : {BroadphaseKind::all_pairs, BroadphaseKind::sweep}) {
    Crowd<double> crowd;
    for (int i = 0; i < 1414; ++i) crowd.add({0, 0}, {1, 1});
    CHECK(crowd.pairs(kind).size() == 1414 * 1413 / 2);
    crowd.add({0, 0}, {1, 1});
    CHECK_THROWS_AS(crowd.pairs(kind), std::length_error);
  }
}

}  // namespace
}  // namespace cairn
