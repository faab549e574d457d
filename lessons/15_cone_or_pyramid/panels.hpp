// The parts of the frames of lesson 15.
#pragma once

#include <string>

#include "math/list.hpp"
#include "render/camera.hpp"
#include "render/page.hpp"
#include "slide.hpp"

namespace cairn::top_view {

/// What of the plane of the friction forces is shown beside its limits.
struct Forces {
  List<Vec2<double>> grey = {};    // [N]
  List<Vec2<double>> active = {};  // [N]
  Vec2<double> velocity = {0, 0};  // [m/s] with a dashed line against it; 0: none
};

/// The pucks where they are after step k, their paths, what moves them and what holds them.
render::Camera draw_table(render::Page& page, const render::Rect& rect, const Slides& all, int k);

/// The names of both limits, in their colours.
render::TextStyle name_style(const render::Page& page, double size, const render::Color& color);

/// From the start to where a puck stops: a line `aside` px beside its way, with its length.
void draw_dimension(render::Page& page, const render::Camera& camera, const Vec2<double>& end, double aside,
                    const std::string& text, const render::Color& color);

/// The plane of the friction forces with the square, the circle, and some forces.
render::Camera draw_limits(render::Page& page, const render::Rect& rect, const Slides& all,
                           const Forces& forces);

/// Where the pucks stop in the first `count` directions, and how far and where to over the direction.
void draw_directions(render::Page& page, const Slides& all, int count);

}  // namespace cairn::top_view
