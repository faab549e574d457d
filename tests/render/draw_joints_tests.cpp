// Drawn joints: a rope over rollers, and joints that have no line of their own.
#include <doctest/doctest.h>

#include "render/world_picture.hpp"

namespace {

using namespace cairn;
using namespace cairn::test;

/// Two discs on a rope over two rollers.
Snapshot rope_over_rollers() {
  Snapshot world = with_ground({dynamic_body(circle(0.4), {-2, -1}), dynamic_body(circle(0.4), {2, 0})});
  world.joints.push_back({.traits = {.is_line = true},
                          .a = {1},
                          .b = {2},
                          .anchor_a = {-2, -1},
                          .anchor_b = {2, 0},
                          .between = {{-2, 2}, {2, 2}}});
  return world;
}

}  // namespace

TEST_CASE("a pulley's rope goes from roller to roller, and each roller has a ring") {
  const Image image = picture_of_world(rope_over_rollers(), {.numbers = false});
  const Theme theme = light_theme();
  const double edge = WorldPage().sizes().outline;  // [px] of each of the two lines that a rope is drawn as
  for (const Vec2<double>& middle : {Vec2<double>(-2, 1), Vec2<double>(2, 1)}) {
    CHECK(distance_at(image, middle, theme.joint, edge, 0) < 80);  // half of the edge's pixel
    CHECK(distance_at(image, middle, theme.background, 4 * edge, 0) <= 2);
  }
  CHECK(distance_at(image, {0, 2}, theme.joint, 0, edge) < 80);
  CHECK(distance_at(image, {0, 0.5}, theme.background, 0, 0) <= 2);  // the middle of a line from end to end
  CHECK(distance_at(image, {0, -0.5}, theme.background, 0, 0) <= 2);
  for (const Vec2<double>& roller : {Vec2<double>(-2, 2), Vec2<double>(2, 2)}) {
    CHECK(distance_at(image, roller, theme.background, 0, 0) <= 2);
    const double rim = WorldPage().sizes().joint;
    CHECK(distance_at(image, roller, theme.joint, -rim / std::sqrt(2), -rim / std::sqrt(2)) < 120);
  }
}

TEST_CASE("joints of angles and velocities leave no line in the picture") {
  Snapshot world = rope_over_rollers();
  const Image without = picture_of_world(world);
  world.joints.push_back(
      {.traits = {.holds_points = false}, .a = {1}, .b = {2}, .anchor_a = {-2, -1}, .anchor_b = {2, 0}});
  CHECK(picture_of_world(world).pixels == without.pixels);
}

TEST_CASE("a rope with a roller that is nowhere is left out") {
  Snapshot world = rope_over_rollers();
  world.joints[0].between[1].x() = no_number;
  const Image image = picture_of_world(world);
  world.joints.clear();
  CHECK(picture_of_world(world).pixels == image.pixels);
}

TEST_CASE("of a rod that has broken two ends are left, of a pin a crossed ring, and nothing between") {
  Snapshot world = rope_over_rollers();
  SnapshotJoint rod = world.joints[0];
  rod.between.clear();
  world.joints.clear();
  world.broken = {{.joint = rod}};
  const Theme theme = light_theme();
  const Image image = picture_of_world(world, {.numbers = false});
  const Vec2<double> along = (rod.anchor_b - rod.anchor_a).normalized();
  // 8 px along the rod, which goes up in the picture.
  CHECK(distance_at(image, rod.anchor_a, theme.joint, 8 * along.x(), -8 * along.y()) < 120);
  CHECK(distance_at(image, rod.anchor_b, theme.joint, -8 * along.x(), 8 * along.y()) < 120);
  CHECK(distance_at(image, (rod.anchor_a + rod.anchor_b) / 2, theme.background, 0, 0) <= 2);
  world.broken[0].joint.traits.is_line = false;
  const Image pin = picture_of_world(world, {.numbers = false});
  CHECK(distance_at(pin, rod.anchor_a, theme.joint, 0, 0) < 120);
  world.bodies[BodyId{1}].removed = world.bodies[BodyId{2}].removed = true;
  const Image gone = picture_of_world(world, {.numbers = false});
  world.broken.clear();
  CHECK(picture_of_world(world, {.numbers = false}).pixels == gone.pixels);
}

TEST_CASE("what is one-way has marks, and a sensor is a dashed line around nothing") {
  SnapshotBody shelf = dynamic_body(box(4, 1), {0, 1});
  shelf.type = BodyType::static_body;
  const Image usual = picture_of_world(with_ground({shelf}));
  shelf.filter.one_way = {0, 1};
  CHECK(picture_of_world(with_ground({shelf})).pixels != usual.pixels);
  shelf.filter.one_way = {0, 0};
  shelf.sensor = true;
  const Image sensor = picture_of_world(with_ground({shelf}));
  CHECK(distance_at(sensor, {0, 1}, light_theme().background, 0, 0) <= 2);
}
