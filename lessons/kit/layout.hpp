// How a frame is divided: columns, which are cut into rows, which are cut into columns again.
#pragma once

#include <utility>

#include <cairn/math/list.hpp>
#include "render/page.hpp"

namespace cairn {

/// A share of what is cut, and into what that is cut in turn: a column into rows, a row into columns.
struct Cut {
  /// Not explicit: `{0.4, {0.6, {0.5, 0.5}}}` is two columns, and the second is cut into two rows.
  Cut(double of_all, List<Cut> inside = {}) : share(of_all), parts(std::move(inside)) {}
  double share;
  List<Cut> parts;
};

/// The pieces of `rect`: from left to right, and those of a column from top to bottom.
List<render::Rect> in_columns(const render::Page& page, const render::Rect& rect, const List<Cut>& cuts);
/// The same from top to bottom.
List<render::Rect> in_rows(const render::Page& page, const render::Rect& rect, const List<Cut>& cuts);

/// Those of the whole frame.
inline List<render::Rect> in_columns(const render::Page& page, const List<Cut>& cuts) {
  return in_columns(page, page.area(), cuts);
}
inline List<render::Rect> in_rows(const render::Page& page, const List<Cut>& cuts) {
  return in_rows(page, page.area(), cuts);
}

}  // namespace cairn
