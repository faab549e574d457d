// Cuts rectangles, and what they are cut into.
#include "lessons/kit/layout.hpp"

namespace cairn {

using render::Rect;

List<Rect> in_columns(const render::Page& page, const Rect& rect, const List<Cut>& cuts) {
  List<double> shares;
  for (const Cut& cut : cuts) shares.push_back(cut.share);
  const List<Rect> strips = render::columns(rect, shares, page.sizes().gap);
  List<Rect> parts;
  for (int i = 0; i < cuts.size(); ++i) {
    const List<Rect> inside =
        cuts[i].parts.empty() ? List<Rect>{strips[i]} : in_rows(page, strips[i], cuts[i].parts);
    parts.insert(parts.end(), inside.begin(), inside.end());
  }
  return parts;
}

List<Rect> in_rows(const render::Page& page, const Rect& rect, const List<Cut>& cuts) {
  List<Rect> parts;  // a row is a column whose two directions have changed places
  for (const Rect& part : in_columns(page, {rect.y, rect.x, rect.height, rect.width}, cuts)) {
    parts.push_back({part.y, part.x, part.height, part.width});
  }
  return parts;
}

}  // namespace cairn
