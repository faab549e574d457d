// A manifold that moves with its bodies, against one that is found where they are then.
#include "../geometry/random_shapes.hpp"
#include <cairn/collision/collide.hpp>
#include "testing.hpp"

namespace cairn {
namespace {

constexpr double far_away = 10;  // [m] margin: all points count

double radius_of_rounding(const Shape<double>& shape) {
  return std::visit(
      [](const auto& held) {
        if constexpr (requires { held.radius; }) return held.radius;
        return 0.0;
      },
      shape);
}

struct Meeting {
  Shape<double> a;
  Shape<double> b;
  Pose<double> pose_a;
  Pose<double> pose_b;

  Manifold<double> found() const { return collide(a, pose_a, b, pose_b, far_away); }
  KeptManifold<double> kept() const {
    return keep<double>(found(), pose_a, radius_of_rounding(a), pose_b, radius_of_rounding(b));
  }
};

Meeting random_meeting(test::Random& random) {
  const Vec2<double> place = random.point(1);
  return {test::random_shape(random.below(test::shape_kinds), random),
          test::random_shape(random.below(test::shape_kinds), random),
          {place, random.uniform(-3, 3)},
          {place + random.point(2), random.uniform(-3, 3)}};
}

/// Of points, normal and separations, the largest difference.
double difference(const Manifold<double>& one, const Manifold<double>& other) {
  if (one.count != other.count) return std::numeric_limits<double>::infinity();
  double most = (one.normal - other.normal).cwiseAbs().maxCoeff();
  for (int i = 0; i < one.count; ++i) {
    most = std::max({most, std::abs(one.points[i].separation - other.points[i].separation),
                     (one.points[i].position - other.points[i].position).cwiseAbs().maxCoeff()});
  }
  return most;
}

// Coordinates and arms below 8 m through some forty operations; a normal between two corners that are 1e-3 m
// apart and more has a thousand times the rounding of their places.
constexpr double kept_rounding = 40 * 8 * 1e3 * std::numeric_limits<double>::epsilon();

/// Whether the contact is between corners so near each other that their direction is all rounding.
bool is_between_close_corners(const Meeting& meeting) {
  const Manifold<double> manifold = meeting.found();
  if (manifold.count == 0 || feature_kind(manifold.points[0].feature) != FeatureKind::corners) return false;
  return manifold.points[0].separation + radius_of_rounding(meeting.a) + radius_of_rounding(meeting.b) < 1e-3;
}

}  // namespace

TEST_CASE("a kept manifold is what was found, and turns and goes along with both bodies") {
  test::Random random(5);
  for (int round = 0; round < 2000; ++round) {
    CAPTURE(round);
    Meeting meeting = random_meeting(random);
    if (is_between_close_corners(meeting)) continue;
    const KeptManifold<double> kept = meeting.kept();
    const Manifold<double> found = meeting.found();
    const Manifold<double> now = kept.at(meeting.pose_a, meeting.pose_b, far_away);
    CHECK(difference(now, found) < kept_rounding);
    for (int i = 0; i < found.count; ++i) CHECK(now.points[i].feature == found.points[i].feature);

    const Pose<double> carried = {random.point(3), random.uniform(-3, 3)};
    const auto carry = [&](const Pose<double>& pose) {
      return Pose<double>{carried.world(pose.position), pose.angle + carried.angle};
    };
    const Manifold<double> then = kept.at(carry(meeting.pose_a), carry(meeting.pose_b), far_away);
    Manifold<double> expected = found;
    expected.normal = Rotation<double>(carried.angle) * found.normal;
    for (int i = 0; i < found.count; ++i) {
      expected.points[i].position = carried.world(found.points[i].position);
    }
    CHECK(difference(then, expected) < kept_rounding);
  }
}

TEST_CASE("a disc that rolls over a box or around a disc keeps an exact manifold") {
  const Shape<double> disc = circle(0.5), ball = circle(0.3);
  const Shape<double> block = box(20, 2);
  for (const double way : {0.001, 0.01, 0.1, 0.5}) {
    CAPTURE(way);
    const Pose<double> still = {{0, 0}, 0.2};
    // Both discs are moved and turned in one motion; over the box in the directions of its face.
    const Meeting on_box = {block, disc, still, {still.world({0.3, 1.52}), 0}};
    const Pose<double> rolled = {still.world({0.3 + way, 1.51}), -2 * way};
    const Manifold<double> over_box = collide(block, still, disc, rolled, far_away);
    CHECK(difference(on_box.kept().at(still, rolled, far_away), over_box) < kept_rounding);

    const Meeting on_disc = {ball, disc, still, {{0.1, 0.81}, 0}};
    const Pose<double> around = {{0.1 + way, 0.8 - way}, way};
    CHECK(difference(on_disc.kept().at(still, around, far_away),
                     collide(ball, still, disc, around, far_away)) < kept_rounding);
  }
}

TEST_CASE("a box that moves over another has separations of the second order and points of the first") {
  const Shape<double> lower = box(4, 1), upper = box(1, 1);
  const Pose<double> still = {{0, 0}, 0.1};
  const Meeting meeting = {lower, upper, still, {still.world({0.2, 1.001}), 0.1}};
  const KeptManifold<double> kept = meeting.kept();
  for (const double way : {1e-2, 1e-3, 1e-4}) {
    CAPTURE(way);
    const Pose<double> moved = {still.world({0.2 + way, 1.001 + way / 3}), 0.1 + way / 2};
    const Manifold<double> found = collide(lower, still, upper, moved, far_away);
    const Manifold<double> now = kept.at(still, moved, far_away);
    REQUIRE(found.count == 2);
    REQUIRE(now.count == 2);
    // Both corners stay over the face: what is left is rounding, at any distance.
    for (int i = 0; i < 2; ++i) {
      CHECK(now.points[i].separation == doctest::Approx(found.points[i].separation).epsilon(1e-9));
    }
    // Corners of the upper box that are cut by the lower one's end would slide: none is here.
    CHECK(difference(now, found) < kept_rounding);
  }
}

TEST_CASE("points beyond the margin are left out, and come back when they are near") {
  const Shape<double> lower = box(4, 1), upper = box(1, 1);
  const Pose<double> still = {{0, 0}, 0};
  const Meeting meeting = {lower, upper, still, {{0, 1.001}, 0.01}};
  const KeptManifold<double> kept = meeting.kept();
  CHECK(kept.count == 2);
  CHECK(kept.at(still, Pose<double>{{0, 1.001}, 0.05}, 0.02).count == 1);
  CHECK(kept.at(still, Pose<double>{{0, 1.2}, 0.0}, 0.02).count == 0);
  CHECK(kept.at(still, Pose<double>{{0, 1.001}, 0.0}, 0.02).count == 2);
}

}  // namespace cairn
