// The list of near pairs, held against the definition while boxes move, come near and go away.
#include "../geometry/random_shapes.hpp"
#include "testing.hpp"

namespace cairn {
namespace {

using Pairs = List<std::pair<int, int>>;

/// Boxes of 0.2 to 1 m, a quarter of them immovable.
struct MovingCrowd {
  List<Aabb<double>> boxes;
  List<char> movable;

  MovingCrowd(int count, test::Random& random) {
    for (int i = 0; i < count; ++i) {
      const Vec2<double> lower = {random.uniform(0, 8), random.uniform(0, 8)};
      boxes.push_back({lower, lower + Vec2<double>(random.uniform(0.2, 1), random.uniform(0.2, 1))});
      movable.push_back(random.below(4) > 0 ? 1 : 0);
    }
  }
  void move(int i, const Vec2<double>& way) {
    boxes[i].lower += way;
    boxes[i].upper += way;
  }
};

/// Every two boxes that overlap are listed, in order; and none that are farther apart than two proxies allow:
/// each is a tenth of a side of at most 1 m larger, and may have been left behind by twice as much.
void check_pairs(const MovingCrowd& crowd, const Pairs& pairs) {
  CHECK(std::is_sorted(pairs.begin(), pairs.end()));
  CHECK(std::adjacent_find(pairs.begin(), pairs.end()) == pairs.end());
  for (int i = 0; i < crowd.boxes.size(); ++i) {
    for (int j = i + 1; j < crowd.boxes.size(); ++j) {
      const bool listed = std::binary_search(pairs.begin(), pairs.end(), std::pair<int, int>(i, j));
      const bool may_meet = crowd.movable[i] || crowd.movable[j];
      Aabb<double> wide = crowd.boxes[i];
      wide.lower.array() -= 0.4;
      wide.upper.array() += 0.4;
      if (crowd.boxes[i].overlaps(crowd.boxes[j])) CHECK(listed == may_meet);
      if (!wide.overlaps(crowd.boxes[j]) || !may_meet) CHECK(!listed);
    }
  }
}

}  // namespace

TEST_CASE("near pairs hold all that overlap, whether a few boxes move or all of them") {
  for (const int moving : {0, 1, 5, 60, 90, 200}) {
    CAPTURE(moving);
    test::Random random(17);
    MovingCrowd crowd(200, random);
    NearPairs<double> near(BroadphaseKind::grid, crowd.movable);
    for (int step = 0; step < 12; ++step) {
      for (int k = 0; k < moving; ++k) {
        crowd.move(random.below(200), {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)});
      }
      near.update(crowd.boxes);
      check_pairs(crowd, near.pairs());
    }
  }
}

TEST_CASE("a box that was large for once is near no more than one that never was") {
  test::Random random(5);
  MovingCrowd crowd(200, random);
  NearPairs<double> near(BroadphaseKind::grid, crowd.movable);
  near.update(crowd.boxes);
  const List<Aabb<double>> before = crowd.boxes;
  for (const double reach : {1.0, 8.0, 1e3}) {
    for (Aabb<double>& box : crowd.boxes) box = {box.lower.array() - reach, box.upper.array() + reach};
    near.update(crowd.boxes);
    crowd.boxes = before;
    near.update(crowd.boxes);
    check_pairs(crowd, near.pairs());
  }
}

TEST_CASE("the list of near pairs stays while boxes stay in their proxies") {
  test::Random random(3);
  MovingCrowd crowd(50, random);
  NearPairs<double> near(BroadphaseKind::grid, crowd.movable);
  CHECK(near.update(crowd.boxes));
  CHECK(!near.update(crowd.boxes));
  // What has not moved has a proxy without room, so that only what overlaps is near.
  for (const auto& [i, j] : near.pairs()) CHECK(crowd.boxes[i].overlaps(crowd.boxes[j]));
  const auto move_all = [&crowd](double way) {
    for (int i = 0; i < 50; ++i) crowd.move(i, {way, -way});
  };
  move_all(0.001);  // all leave their proxies
  near.update(crowd.boxes);
  const Pairs before = near.pairs();
  move_all(0.015);  // of at least 0.2 m: a proxy is 0.02 m larger
  CHECK(!near.update(crowd.boxes));
  CHECK(near.pairs() == before);
}

TEST_CASE("boxes that are no numbers are near nothing, and are found again once they are numbers") {
  test::Random random(1);
  MovingCrowd crowd(0, random);
  crowd.boxes = {{{0, 0}, {1, 1}}, {{0.5, 0}, {1.5, 1}}};
  crowd.movable = {1, 1};
  NearPairs<double> near(BroadphaseKind::all_pairs, crowd.movable);
  near.update(crowd.boxes);
  CHECK(near.pairs() == Pairs{{0, 1}});
  const Aabb<double> good = crowd.boxes[1];
  crowd.boxes[1].lower.x() = std::numeric_limits<double>::quiet_NaN();
  CHECK(near.update(crowd.boxes));
  CHECK(near.pairs().empty());
  crowd.boxes[1] = good;
  CHECK(near.update(crowd.boxes));
  CHECK(near.pairs() == Pairs{{0, 1}});
}

TEST_CASE("too many near pairs are refused, and forgotten once boxes have gone apart") {
  const int count = 1500;  // in one place: above a million pairs
  List<Aabb<double>> boxes(count, {{0, 0}, {1, 1}});
  NearPairs<double> near(BroadphaseKind::grid, List<char>(count, 1));
  CHECK_THROWS_AS(near.update(boxes), std::length_error);
  CHECK_THROWS_AS(near.update(boxes), std::length_error);
  for (int i = 0; i < count; ++i) boxes[i] = {{3.0 * i, 0}, {3.0 * i + 1, 1}};
  near.update(boxes);
  CHECK(near.pairs().empty());
}

}  // namespace cairn
