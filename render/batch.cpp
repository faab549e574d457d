// Cuts shapes to the frame and writes their vertices.
#include "render/batch.hpp"

#include <algorithm>
#include <cmath>

namespace cairn::render {
namespace {

constexpr double farthest_pixel =
    1e7;                      // [px]; beyond it a double no longer places an edge to a small part of a pixel
constexpr double border = 4;  // [px] around the frame, so that the cut itself is never seen

std::uint8_t to_byte(float value) {
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
}

FixedList<std::uint8_t, 4> bytes_of(const Color& color) {
  return {to_byte(color.r), to_byte(color.g), to_byte(color.b), to_byte(color.a)};
}

/// Where the edge a b meets x or y = limit. Computed from the lesser end, so that two shapes that share the
/// edge are cut at the same bits and leave no gap.
Point crossing(const Point& a, const Point& b, int axis, double limit) {
  const Point& low = a[axis] < b[axis] ? a : b;
  const Point& high = a[axis] < b[axis] ? b : a;
  const double t = (limit - low[axis]) / (high[axis] - low[axis]);
  Point point = low + t * (high - low);
  point[axis] = limit;
  return point;
}

Vertex constant_part(const Measure& measure) {
  Vertex vertex = {};
  vertex.shape = measure.shape;
  vertex.first_and_kind = {measure.first[0], measure.first[1], measure.first[2],
                           static_cast<float>(measure.kind)};
  vertex.second_and_half_outline = {measure.second[0], measure.second[1], measure.second[2],
                                    static_cast<float>(measure.half_outline)};
  vertex.fill = bytes_of(measure.fill);
  vertex.outline = bytes_of(measure.outline);
  return vertex;
}

int edge_pixel(double at, int end) {
  return static_cast<int>(std::lround(std::clamp(at, 0.0, double{1} * end)));
}

}  // namespace

bool usable(double value) { return std::abs(value) <= farthest_pixel; }
bool usable(const Point& point) { return usable(point.x()) && usable(point.y()); }

PixelRect pixels_of(const Rect& rect, int width, int height) {
  const double right = rect.x + rect.width;
  const double bottom = rect.y + rect.height;
  if (!(rect.width > 0) || !(rect.height > 0) || std::isnan(right) || std::isnan(bottom)) {
    return {};
  }
  return {edge_pixel(rect.x, width), edge_pixel(rect.y, height), edge_pixel(right, width),
          edge_pixel(bottom, height)};
}

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right),
          std::min(a.bottom, b.bottom)};
}

Batch::Batch(int width, int height)
    : bounds_{-border, -border, width + 2 * border, height + 2 * border}, clip_{0, 0, width, height} {}

void Batch::clear() {
  vertices_.clear();
  indices_.clear();
  draws_.clear();
}

void Batch::cut(int axis, double limit, double sign) {
  scratch_.clear();
  for (int i = 0; i < hull_.size(); ++i) {
    const Point& here = hull_[i];
    const Point& next = hull_[(i + 1) % hull_.size()];
    const bool here_inside = sign * (here[axis] - limit) <= 0;
    const bool next_inside = sign * (next[axis] - limit) <= 0;
    if (here_inside) {
      scratch_.push_back(here);
    }
    if (here_inside != next_inside) {
      scratch_.push_back(crossing(here, next, axis, limit));
    }
  }
  hull_.swap(scratch_);
}

bool Batch::cut_to_bounds(Span<const Point> hull) {
  hull_.assign(hull.begin(), hull.end());
  const double right = bounds_.x + bounds_.width;
  const double bottom = bounds_.y + bounds_.height;
  Point least = hull_.front();
  Point greatest = hull_.front();
  for (const Point& point : hull_) {
    least = least.cwiseMin(point);
    greatest = greatest.cwiseMax(point);
  }
  if (least.x() < bounds_.x) {
    cut(0, bounds_.x, -1);
  }
  if (greatest.x() > right) {
    cut(0, right, 1);
  }
  if (least.y() < bounds_.y) {
    cut(1, bounds_.y, -1);
  }
  if (greatest.y() > bottom) {
    cut(1, bottom, 1);
  }
  return hull_.size() >= 3;
}

void Batch::add(Span<const Point> hull, const Measure& measure) {
  if (clip_.empty() || hull.size() < 3 || !cut_to_bounds(hull)) {
    return;
  }
  const std::uint32_t base = static_cast<std::uint32_t>(vertices_.size());
  Vertex vertex = constant_part(measure);
  for (const Point& point : hull_) {
    vertex.position = {static_cast<float>(point.x()), static_cast<float>(point.y())};
    for (int k = 0; k < 4; ++k) {
      const Affine& local = measure.local[k];
      vertex.local[k] = static_cast<float>(local.a * point.x() + local.b * point.y() + local.c);
    }
    vertices_.push_back(vertex);
  }
  if (draws_.empty() || draws_.back().clip != clip_) {
    draws_.push_back({.clip = clip_, .first = indices_.size(), .count = 0});
  }
  const std::uint32_t corners = static_cast<std::uint32_t>(hull_.size());
  for (std::uint32_t i = 2; i < corners; ++i) {
    indices_.insert(indices_.end(), {base, base + i - 1, base + i});
  }
  draws_.back().count = indices_.size() - draws_.back().first;
}

}  // namespace cairn::render
