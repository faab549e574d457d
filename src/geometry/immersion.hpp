// Floor 1. The part of a shape that lies below a level: what it displaces, and where.
#pragma once

#include <cairn/geometry/shape.hpp>

namespace cairn {

/// Moments of an area about the centre of mass of a body, along the axes of the world.
struct AreaMoments {
  double area = 0;              // [m^2]
  Vec2<double> first = {0, 0};  // [m^3] integral of x and of y
  double polar = 0;             // [m^4] integral of x^2 + y^2
};

/// Of what a shape has below a level: all points x with up . x < level, in the frame of the shape's body,
/// turned into the world. `up` is of length 1, `level` [m] counts from the centre of mass. Exact but for
/// rounding: each moment is an integral around the outline by Green's theorem, of lines and arcs, of which
/// what lies along the level gives nothing. Segments and chains have no area.
AreaMoments immersed(const Shape<double>& shape, double angle, const Vec2<double>& up, double level);

/// Of all shapes of a body that stands so, below a level of the world [m]: up . x < level. Shapes that
/// overlap count twice, as they do for its mass.
AreaMoments immersed(Span<const Shape<double>> shapes, const Pose<double>& pose, const Vec2<double>& up,
                     double level);

}  // namespace cairn
