// The cells of a map of the atlas: colours, signs, and the line around what holds.
#pragma once

#include "extremes/atlas.hpp"
#include "render/page.hpp"

namespace cairn::sandbox {

/// One panel of a sheet on its page; y grows upwards.
struct AtlasGrid {
  const AtlasSheet& sheet;
  int panel = 0;
  render::Rect box = {};  // [px] of all cells

  int columns() const { return sheet.map.x.values.size(); }
  int rows() const { return sheet.map.y.values.size(); }
  bool one_row() const { return sheet.map.panels[panel].ignores_y; }
  AtlasClass ending(int x, int y) const { return sheet.cell(panel, x, y).ending; }
  double left(int x) const;
  double top(int y) const;
};

render::Color class_color(const render::Theme& theme, AtlasClass ending);

/// A cell in the colour of its class, and its sign: none, one stroke, a cross, a star, a hatch.
void draw_class(render::Page& page, const render::Rect& rect, AtlasClass ending);
void draw_atlas_cells(render::Page& page, const AtlasGrid& grid);
/// A step line between what holds and what does not, with the class's name on the side that holds.
void draw_atlas_boundary(render::Page& page, const AtlasGrid& grid);

}  // namespace cairn::sandbox
