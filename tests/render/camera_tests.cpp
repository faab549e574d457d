// From metres to pixels and back.
#include "render/camera.hpp"
#include "render/pictures.hpp"

namespace cairn::render {

namespace {

constexpr double camera_ulp = std::numeric_limits<double>::epsilon();

Camera camera_test_camera() {
  return {.viewport = {20, 64, 600, 400}, .center = {1.5, -0.25}, .scale = 37.5};
}

}  // namespace

TEST_CASE("the camera's centre is seen in the middle of the viewport, and up is up") {
  const Camera camera = camera_test_camera();
  const Point middle = camera.project({1.5, -0.25});
  CHECK(middle.x() == 20 + 600 / 2);
  CHECK(middle.y() == 64 + 400 / 2);
  CHECK(camera.project({1.5 + 2, -0.25}).x() == middle.x() + 2 * 37.5);
  CHECK(camera.project({1.5, -0.25 + 2}).y() == middle.y() - 2 * 37.5);
}

TEST_CASE("what is projected and brought back is where it was, to a few ulp") {
  const Camera camera = camera_test_camera();
  for (const double x : {-7.0, 0.1, 3.3}) {
    for (const double y : {-2.2, 0.0, 5.7}) {
      const Vec2<double> world(x, y);
      const Vec2<double> back = camera.unproject(camera.project(world));
      // Rounded at the size of a pixel coordinate below 1024 px, then divided by the scale.
      const double tolerance = 4 * camera_ulp * 1024 / camera.scale;
      CHECK((back - world).cwiseAbs().maxCoeff() <= tolerance);
    }
  }
}

TEST_CASE("a fitted camera shows the whole box and touches two opposite edges of its viewport") {
  const Rect viewport = {10, 30, 620, 300};
  for (const Aabb<double>& world : {Aabb<double>{{-1, -2}, {3, 5}}, Aabb<double>{{-40, 0}, {70, 2}}}) {
    const Camera camera = fit(viewport, world);
    const Point low = camera.project(world.lower);
    const Point high = camera.project(world.upper);
    const double rim = 8 * camera_ulp * 1024;
    CHECK(low.x() >= viewport.x - rim);
    CHECK(high.x() <= viewport.x + viewport.width + rim);
    CHECK(low.y() <= viewport.y + viewport.height + rim);
    CHECK(high.y() >= viewport.y - rim);
    const double horizontal = (high.x() - low.x()) / viewport.width;
    const double vertical = (low.y() - high.y()) / viewport.height;
    CHECK(std::max(horizontal, vertical) == doctest::Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("a box without width is fitted by its height, and a point keeps the usual scale") {
  const Rect viewport = {0, 0, 600, 300};
  CHECK(fit(viewport, {{2, -1}, {2, 4}}).scale == 300.0 / 5.0);
  CHECK(fit(viewport, {{-3, 1}, {3, 1}}).scale == 600.0 / 6.0);
  CHECK(fit(viewport, {{2, 2}, {2, 2}}).scale == Camera().scale);
  CHECK(fit(viewport, {{2, 2}, {2, 2}}).center == Vec2<double>(2, 2));
}

TEST_CASE("a box that is not finite leaves a camera that can still draw") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Camera camera = fit({0, 0, 600, 300}, {{nan, 0}, {1, 1}});
  CHECK(camera.center == Vec2<double>(0, 0));
  CHECK(camera.scale == Camera().scale);
}

}  // namespace cairn::render
