// The map of settings as a picture: a panel for each family of scenes, a cell for each member and error.
#pragma once

#include <string>

#include "math/list.hpp"
#include "render/page.hpp"
#include "tuning/map_table.hpp"

namespace cairn::sandbox {

struct MapPicture {
  render::Image image = {};
  List<std::string> findings = {};  // what is wrong with its layout: see render/lint.hpp
};

/// 1280 px wide. @throws render::RenderError when nothing can be drawn.
MapPicture draw_map(const MapTable& table, const render::Theme& theme);

}  // namespace cairn::sandbox
