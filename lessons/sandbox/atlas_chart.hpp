// A map of the stability atlas as a picture: a small heat map for each solver, and one legend.
#pragma once

#include <string>

#include "extremes/atlas.hpp"
#include "math/list.hpp"
#include "render/page.hpp"

namespace cairn::sandbox {

struct AtlasPicture {
  render::Image image = {};
  List<std::string> findings = {};  // what is wrong with its layout: see render/lint.hpp
};

/// 1280 x 720 px. Classes differ in brightness and in a sign in the cell, not in hue alone.
/// @throws render::RenderError when nothing can be drawn.
AtlasPicture draw_atlas(const AtlasSheet& sheet, const render::Theme& theme);

}  // namespace cairn::sandbox
