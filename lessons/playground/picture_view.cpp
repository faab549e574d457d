// What part of the scenes is seen.
#include <algorithm>
#include <cmath>

#include <cairn/math/check.hpp>
#include "lessons/playground/picture.hpp"

namespace cairn::playground {

namespace {

constexpr double least_zoom = 1.0 / 32, most_zoom = 64;
constexpr double border = 0.015;  // of the picture's width and height

}  // namespace

void Picture::zoom(double factor, const render::Point& place) {
  require(factor > 0 && std::isfinite(factor), "picture", "factor", "> 0 and finite", factor);
  require_finite(place, "picture", "place", "px");
  if (cameras_.empty()) return;
  const double by = std::clamp(zoom_ * factor, least_zoom, most_zoom) / zoom_;
  const auto is_within = [&](const render::Camera& camera) {
    const render::Rect& view = camera.viewport;
    return place.x() >= view.x && place.x() <= view.x + view.width && place.y() >= view.y &&
           place.y() <= view.y + view.height;
  };
  const auto found = std::find_if(cameras_.begin(), cameras_.end(), is_within);
  const render::Camera& camera = found == cameras_.end() ? cameras_[0] : *found;
  const Vec2<double> way = (1 - 1 / by) * (camera.unproject(place) - camera.center);  // [m]
  zoom_ *= by;
  shift_ += way;
  for (render::Camera& each : cameras_) {
    each.scale *= by;
    each.center += way;
  }
}

void Picture::pan(const render::Point& by) {
  require_finite(by, "picture", "way", "px");
  if (cameras_.empty()) return;
  const Vec2<double> way = Vec2<double>(-by.x(), by.y()) / cameras_[0].scale;  // [m]
  shift_ += way;
  for (render::Camera& each : cameras_) each.center += way;
}

Aabb<double> Picture::room() const {
  if (cameras_.empty()) return {};
  const render::Rect& view = cameras_[0].viewport;
  const Vec2<double> half = (0.5 - border) * Vec2<double>(view.width, view.height) / cameras_[0].scale;
  return {cameras_[0].center - half, cameras_[0].center + half};
}

void Picture::show_all() {
  zoom_ = 1;
  shift_ = {0, 0};
}

}  // namespace cairn::playground
