// All that the files of a lesson are written with: the library, claims and frames, and what frames are drawn
// with.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <type_traits>
#include <utility>

#include <cairn/cairn.hpp>
#include "lessons/kit/layout.hpp"
#include "lessons/kit/lesson.hpp"
#include "lessons/kit/numbers.hpp"
#include "lessons/kit/question.hpp"
#include "lessons/kit/stack_panel.hpp"
#include "lessons/kit/tower_panel.hpp"
#include <cairn/math/list.hpp>
#include <cairn/world/scene_snapshot.hpp>
#include "render/bars.hpp"
#include "render/draw.hpp"
#include "render/matrix.hpp"
#include "render/plot.hpp"
#include "render/solver_style.hpp"

namespace cairn {

using render::Align;
using render::ArrowKind;
using render::ArrowScale;
using render::AxisScale;
using render::BarChart;
using render::Camera;
using render::Canvas;
using render::Color;
using render::Equation;
using render::faded;
using render::fit;
using render::fixed;
using render::Marker;
using render::MatrixColors;
using render::MatrixView;
using render::over_steps;
using render::Page;
using render::Plot;
using render::Point;
using render::Rect;
using render::Series;
using render::SeriesStyle;
using render::Sign;
using render::significant;
using render::Stroke;
using render::TableView;
using render::TextStyle;
using render::Theme;
using render::WorldLook;

/// The spacing of numbers near 1.
inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A key frame that shows something of `run`, which has to last as long as the shot.
template <typename Run>
Shot key_shot(const Run& run, const std::string& state, const std::string& alt,
              const std::function<void(Page&, const std::type_identity_t<Run>&)>& draw) {
  return {.state = state, .alt = alt, .draw = [&run, draw](Page& page) { draw(page, run); }, .key = true};
}

/// The same type, with the point where it is written at its left end, its right end or its middle.
inline TextStyle aligned(TextStyle style, Align align) {
  style.align = align;
  return style;
}

}  // namespace cairn
