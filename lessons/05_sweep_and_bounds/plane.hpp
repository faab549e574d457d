// The plane of the two lambda of the rod.
#pragma once

#include "math/list.hpp"
#include "render/page.hpp"
#include "sweep.hpp"

namespace cairn::sweeps {

/// What the plane shows beside the answers, in N.
struct PlaneView {
  List<FixedList<double, 2>> way = {};    // with the clamp, from (0, 0)
  List<FixedList<double, 2>> other = {};  // without
  FixedList<double, 2> asked = {};        // what the last row would have had without it
  bool levels = false;                    // ellipses of equal ½ λ·A λ − b·λ
};

void draw_plane(render::Page& page, const render::Rect& rect, const SweepRun& run, const PlaneView& view);

}  // namespace cairn::sweeps
