// Floor 1. Area, centroid and moment of inertia of shapes, exact.
#pragma once

#include <cairn/geometry/shape.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// Of a set of shapes of density 1 kg/m^2 (shapes that overlap count twice).
struct MassProperties {
  double area = 0;                 // [m^2], the mass at density 1
  Vec2<double> centroid = {0, 0};  // [m]
  double inertia = 0;              // [m^4], about the centroid, at density 1
};

/// A segment and a chain have area 0. A rounded polygon counts its core, the strips along its edges and its
/// corner sectors.
MassProperties mass_properties(const Shape<double>& shape);

/// Of all shapes together (parallel axis theorem). All zero when there is no area.
MassProperties mass_properties(Span<const Shape<double>> shapes);

}  // namespace cairn
