// The plane of the two lambda of the rod.
#pragma once

#include <array>
#include <vector>

#include "render/page.hpp"
#include "sweep.hpp"

namespace cairn::sweeps {

/// What the plane shows beside the answers, in N.
struct PlaneView {
  std::vector<std::array<double, 2>> way = {};    // with the clamp, from (0, 0)
  std::vector<std::array<double, 2>> other = {};  // without
  std::array<double, 2> asked = {};               // what the last row would have had without it
};

void draw_plane(render::Page& page, const render::Rect& rect, const SweepRun& run, const PlaneView& view);

}  // namespace cairn::sweeps
