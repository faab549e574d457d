// Floor 4. A batch of manifolds that move with their bodies: compiled once for each instruction set, as
// lane_sweep.hpp is. All of it does, number for number, what KeptManifold::at() does for one that lies on a
// face.
#pragma once

#include "solvers/wide/lane_bodies.hpp"
#include "solvers/wide/lane_contact_data.hpp"

namespace cairn {

namespace {

/// Separations of one point, and where it is beside the first body. Adds up in `height` how far the points
/// are along the normal. False if a separation is not below the margin, or an overlap too deep.
template <bool is_first, typename Real>
inline bool move_point(const LaneKeptBatch<Real>& __restrict kept, const LaneFrames<Real>& __restrict at,
                       int point, Real margin, LaneContactInput<Real>& __restrict to,
                       Real* __restrict height) {
  int lost = 0;
  for (int lane = 0; lane < lane_count; ++lane) {
    const Real x = to.normal[0][lane], y = to.normal[1][lane];
    const Real of_a_x = kept.core_a[point][0][lane], of_a_y = kept.core_a[point][1][lane];
    const Real of_b_x = kept.core_b[point][0][lane], of_b_y = kept.core_b[point][1][lane];
    const Real a_x = at.a[2][lane] * of_a_x - at.a[3][lane] * of_a_y;
    const Real a_y = at.a[3][lane] * of_a_x + at.a[2][lane] * of_a_y;
    const Real b_x = (at.b[0][lane] - at.a[0][lane]) + (at.b[2][lane] * of_b_x - at.b[3][lane] * of_b_y);
    const Real b_y = (at.b[1][lane] - at.a[1][lane]) + (at.b[3][lane] * of_b_x + at.b[2][lane] * of_b_y);
    const Real distance = x * (b_x - a_x) + y * (b_y - a_y);
    const Real separation = distance - (kept.radius_a[lane] + kept.radius_b[lane]);
    const bool on_b = kept.on_b[lane] > 0;
    const Real radius = on_b ? kept.radius_a[lane] : kept.radius_b[lane];
    const Real way = on_b ? radius + separation / 2 : -(radius + separation / 2);
    const Real p_x = (on_b ? a_x : b_x) + x * way, p_y = (on_b ? a_y : b_y) + y * way;
    to.point[point][0][lane] = p_x;
    to.point[point][1][lane] = p_y;
    to.separation[point][lane] = separation;
    height[lane] = (is_first ? Real(0) : height[lane]) + (x * p_x + y * p_y);
    lost |= separation < margin ? 0 : 1;
    lost |= separation < -kept.deepest[lane] ? 1 : 0;
  }
  return lost == 0;
}

/// All points of a manifold at one height, and in the world.
template <typename Real>
inline void level_point(const LaneFrames<Real>& __restrict at, int point, const Real* __restrict height,
                        Real points, LaneContactInput<Real>& __restrict to) {
  for (int lane = 0; lane < lane_count; ++lane) {
    const Real x = to.normal[0][lane], y = to.normal[1][lane];
    const Real p_x = to.point[point][0][lane], p_y = to.point[point][1][lane];
    const Real up = height[lane] / points - (x * p_x + y * p_y);
    to.point[point][0][lane] = p_x + (x * up + at.a[0][lane]);
    to.point[point][1][lane] = p_y + (y * up + at.a[1][lane]);
  }
}

/// Manifolds of so many points where the bodies are now. False if a separation is not below `margin` [m],
/// or an overlap too deep.
template <int bytes, typename Real>
inline bool move_contacts(const LaneKeptBatch<Real>& __restrict kept, const LaneBatch& batch,
                          const LaneBody<Real>* frames, int points, Real margin,
                          LaneContactInput<Real>& __restrict to) {
  LaneFrames<Real> at;
  gather_numbers<bytes>(batch.body_a, frames, at.a);
  gather_numbers<bytes>(batch.body_b, frames, at.b);
  Real height[lane_count];
  for (int lane = 0; lane < lane_count; ++lane) {
    const bool on_b = kept.on_b[lane] > 0;
    const Real cosine = on_b ? at.b[2][lane] : at.a[2][lane];
    const Real sine = on_b ? at.b[3][lane] : at.a[3][lane];
    to.normal[0][lane] = cosine * kept.normal[0][lane] - sine * kept.normal[1][lane];
    to.normal[1][lane] = sine * kept.normal[0][lane] + cosine * kept.normal[1][lane];
    for (int axis = 0; axis < 2; ++axis) {
      to.position_a[axis][lane] = at.a[axis][lane];
      to.position_b[axis][lane] = at.b[axis][lane];
    }
  }
  bool is_near = move_point<true>(kept, at, 0, margin, to, height);
  if (points > 1) is_near = move_point<false>(kept, at, 1, margin, to, height) && is_near;
  for (int i = 0; i < points; ++i) level_point(at, i, height, static_cast<Real>(points), to);
  return is_near;
}

}  // namespace

}  // namespace cairn
