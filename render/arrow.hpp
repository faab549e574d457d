// Arrows for forces and velocities: one scale for a whole sequence, one look for each quantity.
#pragma once

#include <string>

#include "render/camera.hpp"
#include "render/page.hpp"

namespace cairn::render {

enum class ArrowKind { normal, negative_correction, friction, joint, velocity, external, inactive };

/// How long a quantity is drawn. Below 8 px an arrow becomes a dot; above `longest` it is cut and marked.
struct ArrowScale {
  double pixels_per_unit = 1;  // [px per N or m/s]
  double longest = 200;        // [px]
  std::string unit = {};       // "N"
};

/// The scale at which `largest` fills 35 % of the viewport's height. Take the largest of the whole sequence.
ArrowScale arrow_scale(double largest, const std::string& unit, const Camera& camera);

struct Arrow {
  ArrowKind kind = ArrowKind::normal;
  Vec2<double> tail = {0, 0};   // [m]
  Vec2<double> value = {0, 0};  // in the scale's unit
  std::string label = {};       // beside the middle, 6 px away, where it meets no other text
  bool active = true;           // inactive ones are thinner and grey
};

void draw_arrow(Page& page, const Camera& camera, const ArrowScale& scale, const Arrow& arrow);

/// The bracket [ ] at +limit and -limit along `direction`: how far friction may go. At the arrow's tail.
void draw_friction_limit(Page& page, const Camera& camera, const ArrowScale& scale, const Vec2<double>& tail,
                         const Vec2<double>& direction, double limit);

/// A bar as long as an arrow of a round value, with that value: "10 N". Its bottom left corner at `corner`.
void draw_scale_key(Page& page, const ArrowScale& scale, const Point& corner);

/// A dimension line: from one point to another [px], with a short stroke across each end.
void draw_length(Page& page, const Point& from, const Point& to, const Stroke& stroke);

}  // namespace cairn::render
