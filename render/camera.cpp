// From metres to pixels and back.
#include "render/camera.hpp"

#include <algorithm>
#include <cmath>

namespace cairn::render {

Point Camera::project(const Vec2<double>& world) const {
  return {viewport.x + viewport.width / 2 + (world.x() - center.x()) * scale,
          viewport.y + viewport.height / 2 - (world.y() - center.y()) * scale};
}

Vec2<double> Camera::unproject(const Point& pixel) const {
  return {center.x() + (pixel.x() - viewport.x - viewport.width / 2) / scale,
          center.y() - (pixel.y() - viewport.y - viewport.height / 2) / scale};
}

Camera fit(const Rect& viewport, const Aabb<double>& world) {
  Camera camera;
  camera.viewport = viewport;
  if (!world.lower.allFinite() || !world.upper.allFinite()) return camera;
  camera.center = 0.5 * world.lower + 0.5 * world.upper;
  const Vec2<double> size = world.upper - world.lower;
  const double horizontal = viewport.width / size.x();
  const double vertical = viewport.height / size.y();
  // A box without width leaves the choice to its height, and the other way round.
  double scale = size.x() > 0 ? horizontal : vertical;
  if (size.x() > 0 && size.y() > 0) scale = std::min(horizontal, vertical);
  if (std::isfinite(scale) && scale > 0) camera.scale = scale;
  return camera;
}

}  // namespace cairn::render
