// From metres, y up, to pixels, y down.
#pragma once

#include <cairn/geometry/aabb.hpp>
#include "render/canvas.hpp"

namespace cairn::render {

/// What of the world is seen where on the page.
struct Camera {
  Rect viewport = {};            // [px]
  Vec2<double> center = {0, 0};  // [m] shown in the middle of the viewport
  double scale = 100;            // [px/m]

  Point project(const Vec2<double>& world) const;
  Vec2<double> unproject(const Point& pixel) const;
};

/// The camera that shows all of `world`, as large as it fits. A box without size keeps the scale of 100 px/m;
/// one that is not finite (a simulation that blew up) keeps the centre too, so that the frame is still drawn.
Camera fit(const Rect& viewport, const Aabb<double>& world);

}  // namespace cairn::render
