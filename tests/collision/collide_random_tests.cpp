// Properties that every manifold must have, over random pairs of all shapes, against brute force.
#include "../geometry/random_shapes.hpp"
#include <cairn/collision/collide.hpp>
#include "testing.hpp"

namespace cairn {
namespace {

constexpr double bias = 5e-4;  // of the smaller core: by so much the first shape's face is preferred

template <Scalar Real>
struct Encounter {
  Shape<Real> a;
  Shape<Real> b;
  Pose<Real> pose_a;
  Pose<Real> pose_b;
};

constexpr long double reach = 5;  // [m], no coordinate and no arm of these encounters is longer

/// Two shapes of the given kinds, from deep overlap to 2 m apart.
template <Scalar Real>
Encounter<Real> random_encounter(int kind_a, int kind_b, test::Random& random) {
  const Vec2<double> place = random.point(1);
  Encounter<Real> encounter;
  encounter.a = shape_cast<Real>(test::random_shape(kind_a, random));
  encounter.b = shape_cast<Real>(test::random_shape(kind_b, random));
  encounter.pose_a = {place.cast<Real>(), static_cast<Real>(random.uniform(-3, 3))};
  encounter.pose_b = {(place + random.point(2)).cast<Real>(), static_cast<Real>(random.uniform(-3, 3))};
  return encounter;
}

/// Calls `check` with encounters of every ordered pair of shapes.
template <Scalar Real, typename Check>
void for_random_encounters(std::uint64_t seed, const Check& check) {
  test::Random random(seed);
  for (int kind_a = 0; kind_a < test::shape_kinds; ++kind_a) {
    for (int kind_b = 0; kind_b < test::shape_kinds; ++kind_b) {
      for (int round = 0; round < 40; ++round) {
        CAPTURE(kind_a);
        CAPTURE(kind_b);
        CAPTURE(round);
        check(random_encounter<Real>(kind_a, kind_b, random));
      }
    }
  }
}

template <Scalar Real>
Manifold<Real> touch(const Encounter<Real>& encounter) {
  return collide(encounter.a, encounter.pose_a, encounter.b, encounter.pose_b, Real(10));
}

template <Scalar Real>
Manifold<Real> touch_swapped(const Encounter<Real>& encounter) {
  return collide(encounter.b, encounter.pose_b, encounter.a, encounter.pose_a, Real(10));
}

/// Positions below `reach` that went through a rotation, a difference and a projection.
template <Scalar Real>
constexpr long double rounding() {
  return 16 * reach * std::numeric_limits<Real>::epsilon();
}

template <Scalar Real>
const ManifoldPoint<Real>& deepest(const Manifold<Real>& manifold) {
  const bool second = manifold.count == 2 && manifold.points[1].separation < manifold.points[0].separation;
  return manifold.points[second ? 1 : 0];
}

template <Scalar Real>
long double bias_of(const Encounter<Real>& encounter) {
  const auto size = [](const test::Core& core) {
    long double result = 0;
    for (const Vec2<long double>& corner : core.corners)
      result = std::max(result, (corner - core.corners[0]).norm());
    return result;
  };
  return bias * std::min(size(test::core(encounter.a, encounter.pose_a)),
                         size(test::core(encounter.b, encounter.pose_b)));
}

long double distance(const Vec2<long double>& point, const Vec2<long double>& p, const Vec2<long double>& q) {
  const Vec2<long double> edge = q - p;
  const long double squared = edge.squaredNorm();
  const long double fraction = squared > 0 ? std::clamp(edge.dot(point - p) / squared, 0.0L, 1.0L) : 0.0L;
  return (p + fraction * edge - point).norm();
}

/// The least distance from a corner of one core to an edge of the other.
long double corner_distance(const test::Core& a, const test::Core& b) {
  long double nearest = std::numeric_limits<long double>::infinity();
  for (const Vec2<long double>& corner : a.corners) {
    for (int i = 0; i < b.corners.size(); ++i) {
      nearest = std::min(nearest, distance(corner, b.corners[i], b.corners[(i + 1) % b.corners.size()]));
    }
  }
  return nearest;
}

/// How far apart the cores are along a direction.
long double gap_along(const test::Core& a, const test::Core& b, const Vec2<long double>& direction) {
  return direction.dot(test::farthest_corner(b, -direction)) -
         direction.dot(test::farthest_corner(a, direction));
}

/// The largest gap over all directions: the distance, or minus the depth. Samples directions, then, when the
/// cores are apart, takes the distance of corners and edges, which is exact.
struct BruteForce {
  static constexpr int directions = 1440;
  long double separation = -std::numeric_limits<long double>::infinity();  // [m]
  bool exact = false;

  BruteForce(const test::Core& a, const test::Core& b) {
    for (int i = 0; i < directions; ++i) {
      const Rotation<long double> turn =
          test::exact_rotation(2 * std::numbers::pi_v<long double> * i / directions);
      separation = std::max(separation, gap_along(a, b, {turn.c, turn.s}));
    }
    exact = separation > 0;
    if (exact) separation = std::min(corner_distance(a, b), corner_distance(b, a));
    separation -= a.radius + b.radius;
  }
  /// The gap changes by at most the distance of the corners times the angle between two directions.
  long double tolerance() const { return exact ? 0 : reach * std::numbers::pi_v<long double> / directions; }
};

TEST_CASE_TEMPLATE("every manifold has a unit normal, one height and distinct features", Real, float,
                   double) {
  for_random_encounters<Real>(20, [](const Encounter<Real>& encounter) {
    const Manifold<Real> manifold = touch(encounter);
    REQUIRE(manifold.count >= 1);
    CHECK(std::abs(manifold.normal.norm() - 1) <= 4 * std::numeric_limits<Real>::epsilon());
    if (manifold.count < 2) return;
    CHECK(manifold.points[0].feature != manifold.points[1].feature);
    const Vec2<Real> between = manifold.points[1].position - manifold.points[0].position;
    CHECK(std::abs(between.dot(manifold.normal)) <= rounding<Real>());
  });
}

TEST_CASE_TEMPLATE("the separation is the distance of the shapes, or minus their depth", Real, float,
                   double) {
  for_random_encounters<Real>(21, [](const Encounter<Real>& encounter) {
    const BruteForce expected(test::core(encounter.a, encounter.pose_a),
                              test::core(encounter.b, encounter.pose_b));
    const long double tolerance = rounding<Real>() + expected.tolerance();
    const long double error = deepest(touch(encounter)).separation - expected.separation;
    const long double swapped_error = deepest(touch_swapped(encounter)).separation - expected.separation;
    // Where the first shape is preferred, the exact answer is the one with the other shape first.
    CHECK(std::min(std::abs(error), std::abs(swapped_error)) <= tolerance);
    CHECK(std::abs(error) <= tolerance + bias_of(encounter));
    // Along the normal that was found, the shapes are exactly that far apart.
    const Vec2<long double> normal = touch(encounter).normal.template cast<long double>();
    const test::Core a = test::core(encounter.a, encounter.pose_a);
    const test::Core b = test::core(encounter.b, encounter.pose_b);
    const long double along = gap_along(a, b, normal) - a.radius - b.radius;
    CHECK(std::abs(deepest(touch(encounter)).separation - along) <= rounding<Real>() + bias_of(encounter));
  });
}

TEST_CASE_TEMPLATE("moved along the normal by their separation, two shapes just touch", Real, float, double) {
  for_random_encounters<Real>(22, [](const Encounter<Real>& encounter) {
    const Manifold<Real> before = touch(encounter);
    Encounter<Real> later = encounter;
    later.pose_b.position -= before.normal * deepest(before).separation;
    const long double left = deepest(touch(later)).separation;
    CHECK(std::abs(left) <= 4 * rounding<Real>() + 2 * bias_of(encounter));
  });
}

TEST_CASE_TEMPLATE("with the two shapes swapped, the manifold is mirrored", Real, float, double) {
  int encounters = 0;
  int ties = 0;
  for_random_encounters<Real>(23, [&](const Encounter<Real>& encounter) {
    const Manifold<Real> one = touch(encounter);
    Manifold<Real> other = touch_swapped(encounter);
    ++encounters;
    if ((one.normal + other.normal).norm() > 8 * rounding<Real>()) {  // the bias chose the first shape twice
      ++ties;
      const long double change = deepest(one).separation - deepest(other).separation;
      CHECK(std::abs(change) <= 2 * bias_of(encounter) + rounding<Real>());
      return;
    }
    REQUIRE(one.count == other.count);
    if ((one.points[0].position - other.points[0].position).norm() > Real(0.01)) {
      std::swap(other.points[0], other.points[1]);
    }
    for (int i = 0; i < one.count; ++i) {
      // A cut at a small angle between the edges multiplies the rounding of the height.
      CHECK((one.points[i].position - other.points[i].position).norm() <= 64 * rounding<Real>());
      CHECK(std::abs(one.points[i].separation - other.points[i].separation) <= 64 * rounding<Real>());
    }
  });
  // The bias matters where two separations agree to 1 part in 2000: far fewer than 1 encounter in 50.
  CHECK(ties * 50 < encounters);
}

TEST_CASE_TEMPLATE("features keep their names while the shapes move a little", Real, float, double) {
  int encounters = 0;
  int changes = 0;
  for_random_encounters<Real>(24, [&](const Encounter<Real>& encounter) {
    const Manifold<Real> before = touch(encounter);
    const Real little = 16 * std::numeric_limits<Real>::epsilon();
    Encounter<Real> later = encounter;
    later.pose_b.position += Vec2<Real>(little, -little);
    later.pose_b.angle += little;
    const Manifold<Real> after = touch(later);
    ++encounters;
    bool same = before.count == after.count;
    for (int i = 0; i < 2; ++i) same = same && before.points[i].feature == after.points[i].feature;
    if (!same) ++changes;
  });
  CHECK(encounters == 1000);
  // By chance a boundary between two features lies within the move: 2e-6 in float, to features of some 0.1 m.
  CHECK(changes <= 1);
}

/// One of the six coordinates of a pair's configuration: 0 to 2 of a, 3 to 5 of b.
template <Scalar Real>
Real& coordinate(Encounter<Real>& encounter, int i) {
  Pose<Real>& pose = i < 3 ? encounter.pose_a : encounter.pose_b;
  return i % 3 == 2 ? pose.angle : pose.position[i % 3];
}

/// The separation of the point with this feature, after coordinate i has moved by `step`. NaN when it is
/// gone.
template <Scalar Real>
Real moved_separation(Encounter<Real> encounter, int i, Real step, std::uint32_t feature) {
  coordinate(encounter, i) += step;
  const Manifold<Real> manifold = touch(encounter);
  for (const ManifoldPoint<Real>& point : manifold.points) {
    if (&point < manifold.points.data() + manifold.count && point.feature == feature) return point.separation;
  }
  return std::numeric_limits<Real>::quiet_NaN();
}

/// The row of the contact: (-n, -r_a x n) for a, (n, r_b x n) for b.
template <Scalar Real>
Real row(const Encounter<Real>& encounter, const Manifold<Real>& manifold, const ManifoldPoint<Real>& point,
         int i) {
  const Real sign = i < 3 ? Real(-1) : Real(1);
  const Pose<Real>& pose = i < 3 ? encounter.pose_a : encounter.pose_b;
  if (i % 3 == 2) return sign * cross<Real>(point.position - pose.position, manifold.normal);
  return sign * manifold.normal[i % 3];
}

TEST_CASE_TEMPLATE("the separation changes with the poses as the contact's row says", Real, float, double) {
  int compared = 0;
  int lost = 0;
  for_random_encounters<Real>(25, [&](const Encounter<Real>& encounter) {
    const Manifold<Real> manifold = touch(encounter);
    const ManifoldPoint<Real>& point = deepest(manifold);
    const test::Core a = test::core(encounter.a, encounter.pose_a);
    const test::Core b = test::core(encounter.b, encounter.pose_b);
    const long double core_distance = point.separation + a.radius + b.radius;
    // Central differences err by step^2 / 6 times the third derivative. That of a coordinate along a turning
    // normal is at most the arm; that of a distance d of corners at most 3 arm^3 / d^2. Rounding adds its
    // own.
    const Real step = std::cbrt(std::numeric_limits<Real>::epsilon());
    // Where the bias prefers a face that cuts off the deepest corner, the cut end slides along the other
    // face, and the row leaves that out.
    const Vec2<long double> normal = manifold.normal.template cast<long double>();
    if (std::abs(gap_along(a, b, normal) - core_distance) > rounding<Real>()) return;
    const bool corners = point.feature >> 16 == 2;
    if (corners && core_distance < 0.1) return;  // so that the step is short against d
    const long double second = corners ? 2 * reach * reach / core_distance : reach;
    const long double third = corners ? 3 * reach * reach * reach / (core_distance * core_distance) : reach;
    const long double tolerance = step * step * third / 6 + rounding<Real>() / step;
    for (int i = 0; i < 6; ++i) {
      const Real ahead = moved_separation(encounter, i, step, point.feature);
      const Real behind = moved_separation(encounter, i, -step, point.feature);
      ++compared;
      // A boundary between two features within one step: the point is gone, or the separation has a kink.
      const Real bend = std::abs(ahead + behind - 2 * point.separation);
      if (!(bend <= step * step * second + 4 * rounding<Real>())) {
        ++lost;
        continue;
      }
      const Real slope = (ahead - behind) / (2 * step);
      CHECK(std::abs(slope - row(encounter, manifold, point, i)) <= tolerance);
    }
  });
  CHECK(compared > 5000);
  // Features are about 0.5 m long, so that a step of s meets a boundary in about 2 s / 0.5 of all cases.
  CHECK(lost <= compared * std::max(0.001, 4.0 * std::cbrt(static_cast<double>(
                                                     std::numeric_limits<Real>::epsilon()))));
}

}  // namespace
}  // namespace cairn
