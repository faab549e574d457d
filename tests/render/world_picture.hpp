// What the tests of drawn worlds share: a small page, simple worlds, and what colour is where.
#pragma once

#include "render/draw.hpp"
#include "render/pictures.hpp"

namespace cairn::test {

using namespace cairn::render;

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// 40 px a metre, the world's origin in the middle of the page.
inline const Camera world_camera = {.viewport = {10, 30, 620, 310}, .center = {0, 0}, .scale = 40};

struct WorldPage : Page {
  explicit WorldPage(const Theme& theme = light_theme()) : Page(640, 360, theme) {
    begin({.title = "World"});
  }
};

inline SnapshotBody dynamic_body(const Shape<double>& shape, const Vec2<double>& position, double angle = 0) {
  SnapshotBody body{.type = BodyType::dynamic, .pose = {.position = position, .angle = angle}, .mass = 1};
  body.shapes.push_back(shape);
  return body;
}

/// These bodies are numbered from 1 on.
inline Snapshot with_ground(const List<SnapshotBody>& bodies = {}) {
  Snapshot world{.dt = 0.02};
  SnapshotBody floor;
  floor.shapes.push_back(moved(box(100, 1), {0, -2.5}));  // its surface at y = -2
  world.bodies.push_back(floor);
  for (const SnapshotBody& body : bodies) world.bodies.push_back(body);
  return world;
}

/// How far a pixel's colour is from another, 0..255, the worst of the three channels.
inline int distance_at(const Image& image, const Point& at, const Color& color) {
  return static_cast<int>(worst_off(image, static_cast<int>(at.x()), static_cast<int>(at.y()), color));
}

inline int distance_at(const Image& image, const Vec2<double>& world, const Color& color, double right,
                       double down) {
  return distance_at(image, world_camera.project(world) + Point(right, down), color);
}

inline int count_of_color(const Image& image, const Color& color) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += distance_at(image, Point(x, y), color) < 24 ? 1 : 0;
  }
  return count;
}

/// How often a row of pixels turns from the colour to another one.
inline int strokes_in_row(const Image& image, double y, const Color& color, int tolerance) {
  int strokes = 0;
  bool was_on = false;
  for (int x = 0; x < image.width; ++x) {
    const bool is_on = distance_at(image, Point(x, y), color) > tolerance;
    strokes += is_on && !was_on ? 1 : 0;
    was_on = is_on;
  }
  return strokes;
}

inline Image picture_of_world(const Snapshot& world, const WorldLook& look = {}) {
  WorldPage page;
  draw_world(page, world_camera, world, look);
  return page.canvas().read();
}

}  // namespace cairn::test
