// Bodies of pieces in pictures: one outline, and thin seams.
#include <doctest/doctest.h>

#include "world_picture.hpp"

namespace cairn::test {
namespace {

const List<Vec2<double>> ell = {{-2, -2}, {2, -2}, {2, -1}, {-1, -1}, {-1, 2}, {-2, 2}};

Image picture_of_ell(BodyType type) {
  Snapshot world{.dt = 0.02};
  world.bodies.push_back({});
  SnapshotBody body{.type = type, .mass = 1};
  body.shapes = outline(ell);
  world.bodies.push_back(body);
  WorldPage page;
  draw_world(page, world_camera, world, {});
  return page.canvas().read();
}

}  // namespace

TEST_CASE("an L has the outline of an L, a seam from corner to corner, and no line beyond its corners") {
  const Theme theme = light_theme();
  for (const BodyType type : {BodyType::dynamic, BodyType::static_body}) {
    const Image image = picture_of_ell(type);
    for (const Vec2<double>& on_line :
         List<Vec2<double>>{{0, -2}, {2, -1.5}, {0.5, -1}, {-1, 0.5}, {-1.5, 2}, {-2, 0}})
      CHECK(distance_at(image, on_line, theme.outline, 0, 0) < 130);
    // The seam runs from (-2, -2) to (-1, -1): a line of 1 px is dark on the pixels that it meets.
    int darkest = 255;
    for (int k = -2; k <= 2; ++k)
      darkest = std::min(darkest, distance_at(image, Vec2<double>(-1.5, -1.5), theme.outline, k, 0));
    CHECK(darkest < 130);
    // Beyond a corner, along the seam, there is paper.
    CHECK(distance_at(image, Vec2<double>(-2, -2), theme.background, -4, 4) < 24);
    CHECK(distance_at(image, Vec2<double>(-1, -1), theme.background, 4, -4) < 24);
  }
}

}  // namespace cairn::test
