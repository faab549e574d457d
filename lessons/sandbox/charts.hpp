// The charts of the program: an atlas of cells, a map of settings, work against error, profiles, tracks.
#pragma once

#include <optional>
#include <string>

#include <cairn/study/extremes/atlas.hpp>
#include <cairn/math/list.hpp>
#include <cairn/measure/tracks.hpp>
#include "render/image.hpp"
#include "render/page.hpp"
#include "render/svg.hpp"
#include "render/theme.hpp"
#include <cairn/study/work_precision.hpp>
#include <cairn/study/tuning/map_study.hpp>

namespace cairn::sandbox {

/// A page of panels.
struct PanelPicture {
  render::Image image = {};
  List<std::string> findings = {};  // what is wrong with its layout: see render/lint.hpp
};

/// A map of the stability atlas: a small heat map for each solver, and one legend; 1280 px wide. Classes
/// differ in brightness and in a sign in the cell, not in hue alone.
/// @throws render::RenderError when nothing can be drawn, as do all of these.
PanelPicture draw_atlas(const AtlasSheet& sheet, const render::Theme& theme);

/// The map of settings: a panel for each family of scenes, a cell for each member and error; 1280 px wide.
PanelPicture draw_map(const MapTable& table, const render::Theme& theme);

struct TradeChart {
  std::string title = {};  // "stack10: 10 boxes, frozen in its 1st step"
  std::string work = {};   // of the axes, with units
  std::string error = {};
  std::string note = {};  // one sentence below the chart
  List<TradePoint> points = {};
  List<std::string> curves = {};  // at most 4 solvers, by name, that get a curve; the others are dots
  bool is_of_sweeps = false;      // a curve for each scene, through all of its points
  bool labels_all = false;        // every point of the front with its setting, where there is room
};
/// Work against error: every setting a dot, the best of each solver a curve.
render::Image draw_trade_chart(const TradeChart& chart, const render::Theme& theme);

struct ProfileChart {
  std::string title = {};
  std::string note = {};                   // below it
  List<PerformanceProfile> profiles = {};  // at most 4
};
/// Performance profiles, as steps.
render::Image draw_profile_chart(const ProfileChart& chart, const render::Theme& theme);

struct TrackChart {
  std::string title = {};
  std::string state = {};  // beside it
  List<Track> tracks = {};
  List<double> times = {};  // [s] of their values
};
/// Quantities over time, those of one unit in one panel: the bytes of a PNG, or of an SVG where `svg` says
/// what becomes of its letters.
/// @throws render::RenderError for no tracks, and for more than 4 panels of 4.
std::string draw_tracks(const TrackChart& chart, const render::Theme& theme,
                        const std::optional<render::Letters>& svg);

// What several of them are made of.

/// The looks of solvers' curves.
List<render::SeriesStyle> solver_styles(const List<std::string>& solvers, const render::Theme& theme);
/// The name beside a curve.
std::string solver_label(const std::string& solver);
/// The text for pictures, where _ alone would begin a subscript.
std::string unmarked(const std::string& text);
/// A paragraph at the bottom of an area; what is left above it.
render::Rect place_note(render::Page& page, const std::string& note);
/// Small type: what stands at axes, and in legends.
render::TextStyle small_style(const render::Page& page, render::Align align = render::Align::left);
/// The name of a panel, or of what a legend shows.
render::TextStyle name_style(const render::Page& page, double size = 16);
/// The frame of a panel, its lines on whole pixels.
void frame_panel(render::Page& page, const render::Rect& rect);

}  // namespace cairn::sandbox
