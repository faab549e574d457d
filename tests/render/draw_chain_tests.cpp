// Chains in pictures: a line, and strokes on the side of the solid.
#include <doctest/doctest.h>

#include "world_picture.hpp"

namespace cairn::test {
namespace {

/// A chain along y = 0 from x = -4 to 4 m, with its solid below or above, and nothing else.
Snapshot lone_chain(bool solid_below) {
  Snapshot world{.dt = 0.02};
  SnapshotBody body;
  const double start = solid_below ? 4 : -4;
  body.shapes.push_back(chain({{start, 0}, {0, 0}, {-start, 0}}));
  world.bodies.push_back(body);
  return world;
}

}  // namespace

TEST_CASE("a chain has strokes on the side of its solid, one every 9 pixels, and none on the other") {
  for (const bool solid_below : {true, false}) {
    WorldPage page;
    const Image before = page.canvas().read();
    draw_world(page, world_camera, lone_chain(solid_below), {});
    const Image image = page.canvas().read();
    const double line = world_camera.project(Vec2<double>(0, 0)).y();
    const double below = line + 4, above = line - 4;  // strokes are 5.7 px deep
    const Color paper = light_theme().background;
    const int strokes = strokes_in_row(image, solid_below ? below : above, paper, 60);
    CHECK(std::abs(strokes - 320 / 9) <= 1);
    CHECK(strokes_in_row(image, solid_below ? above : below, paper, 60) ==
          strokes_in_row(before, solid_below ? above : below, paper, 60));
    CHECK(distance_at(image, Vec2<double>(1.03, 0), light_theme().outline, 0, 0) < 60);
  }
}

}  // namespace cairn::test
