// A tower and what its boxes carry: the picture that lessons 08, 17 and 18 share.
#pragma once

#include <string>

#include <cairn/math/list.hpp>
#include "render/camera.hpp"
#include "render/page.hpp"
#include <cairn/world/snapshot.hpp>

namespace cairn {

/// How loads become bars.
struct LoadBars {
  double box_weight = 0;     // [N] of one box: a tick shows the weight above each place
  double largest = 0;        // [N] that fills the width
  render::Color color = {};  // of the bars
  List<double> least = {};   // [N] of each load lately, drawn as a pale band up to `most`; empty: no bands
  List<double> most = {};
};

/// The tower at the left of `view`, and a bar beside each box, which follows it when it sinks. loads[i] [N]
/// is what is under box i, counted from the ground: body i + 1.
/// @returns how metres of the tower become pixels.
render::Camera draw_tower_loads(render::Page& page, const render::Rect& view, const Snapshot& tower,
                                const List<double>& loads, const LoadBars& bars);

/// A panel with a solver's colour on top, its marker and name, and a number at the right.
/// @returns the room below.
render::Rect draw_solver_panel(render::Page& page, const render::Rect& rect, const render::SeriesStyle& style,
                               const std::string& name, const std::string& number);

}  // namespace cairn
