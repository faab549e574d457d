// Floor 4. Scales the rows of a batch: compiled once for each instruction set, as lane_sweep.hpp is.
#pragma once

#include <limits>

#include <cairn/constraints/row_rule.hpp>
#include <cairn/solvers/wide/lane_data.hpp>

namespace cairn {

namespace {

/// [1/kg] Weaker springs are taken for one of this softness, 1e15 times A_ii of the lightest bodies: neither
/// does anything, and lanes have numbers for this one.
constexpr float most_lane_softness = 1e30f;

/// A row that lacks less is done. This is 2^7 times the step whose square is the smallest normal number:
/// sweeps over what comes to rest would otherwise come to smaller numbers, which take processors many times
/// as long.
constexpr float smallest_step = [] {
  float step = 128;
  for (int e = std::numeric_limits<float>::min_exponent; e < 1; e += 2) step /= 2;
  return step;
}();

/// The numbers of a row in one lane.
template <typename Real>
struct LaneNumbers {
  Real a[3];      // its Jacobian of the first body
  Real b[3];      // of the second body
  Real bias;      // zeta (7)
  Real softness;  // gamma [1/kg]
  Real impulse;   // [N s]
  Real lower;     // [N s]
  Real upper;     // [N s]
  Real friction;  // mu
};

/// What a row is in one lane, before it is scaled.
template <typename Real>
[[gnu::always_inline]] inline void fill_lane(const LaneBodyInput<Real>& __restrict bodies,
                                             const LaneNumbers<Real>& from, int lane,
                                             LaneRow& __restrict to) {
  const Real most = static_cast<Real>(most_lane_softness);
  const Real softness = from.softness < most ? from.softness : most;
  const Real lacking = from.bias -
                       ((from.a[0] * bodies.velocity_a[0][lane] + from.a[1] * bodies.velocity_a[1][lane] +
                         from.a[2] * bodies.velocity_a[2][lane]) +
                        (from.b[0] * bodies.velocity_b[0][lane] + from.b[1] * bodies.velocity_b[1][lane] +
                         from.b[2] * bodies.velocity_b[2][lane])) -
                       softness * from.impulse;
  to.jacobian_a[0][lane] = static_cast<float>(from.a[0]);
  to.jacobian_a[1][lane] = static_cast<float>(from.a[1]);
  to.jacobian_a[2][lane] = static_cast<float>(from.a[2]);
  to.jacobian_b[0][lane] = static_cast<float>(from.b[0]);
  to.jacobian_b[1][lane] = static_cast<float>(from.b[1]);
  to.jacobian_b[2][lane] = static_cast<float>(from.b[2]);
  to.lacking[lane] = static_cast<float>(lacking);
  to.impulse[lane] = 0;
  to.lower[lane] = static_cast<float>(from.lower - from.impulse);
  to.upper[lane] = static_cast<float>(from.upper - from.impulse);
  to.friction[lane] = static_cast<float>(from.friction);
  to.softness[lane] = static_cast<float>(softness);
}

/// Scales a row to A_ii = 1, in the precision of lanes: all that it holds are changes. Between bodies that
/// nothing moves it has nothing to do but to keep its bounds.
inline void scale_row(const LaneRoots& __restrict roots, LaneRow& __restrict row) {
  for (int lane = 0; lane < lane_count; ++lane) {
    const float of_a0 = row.jacobian_a[0][lane] * roots.a[0][lane];
    const float of_a1 = row.jacobian_a[1][lane] * roots.a[1][lane];
    const float of_a2 = row.jacobian_a[2][lane] * roots.a[2][lane];
    const float of_b0 = row.jacobian_b[0][lane] * roots.b[0][lane];
    const float of_b1 = row.jacobian_b[1][lane] * roots.b[1][lane];
    const float of_b2 = row.jacobian_b[2][lane] * roots.b[2][lane];
    const float inverse = (of_a0 * of_a0 + of_a1 * of_a1 + of_a2 * of_a2) +
                          (of_b0 * of_b0 + of_b1 * of_b1 + of_b2 * of_b2) + row.softness[lane];
    const float root = square_root(inverse > 0 ? inverse : 1.0f);
    const float scale = 1 / root;
    row.jacobian_a[0][lane] = of_a0 * scale;
    row.jacobian_a[1][lane] = of_a1 * scale;
    row.jacobian_a[2][lane] = of_a2 * scale;
    row.jacobian_b[0][lane] = of_b0 * scale;
    row.jacobian_b[1][lane] = of_b1 * scale;
    row.jacobian_b[2][lane] = of_b2 * scale;
    const float lacking = row.lacking[lane] * (inverse > 0 ? scale : 0.0f);
    const float size = lacking < 0 ? -lacking : lacking;
    row.lacking[lane] = size < smallest_step ? 0.0f : lacking;
    row.lower[lane] *= root;
    row.upper[lane] *= root;
    row.friction[lane] *= root;
    row.softness[lane] = row.softness[lane] * scale * scale;
    row.scale[lane] = scale;
  }
}

/// What row `from` is in lanes.
template <typename Real>
inline void fill_row(const LaneBodyInput<Real>& __restrict bodies, const LaneRoots& __restrict roots,
                     const LaneInput<Real>& __restrict from, LaneRow& __restrict to) {
  for (int lane = 0; lane < lane_count; ++lane) {
    const LaneNumbers<Real> row = {
        .a = {from.jacobian_a[0][lane], from.jacobian_a[1][lane], from.jacobian_a[2][lane]},
        .b = {from.jacobian_b[0][lane], from.jacobian_b[1][lane], from.jacobian_b[2][lane]},
        .bias = from.bias[lane],
        .softness = from.softness[lane],
        .impulse = from.impulse[lane],
        .lower = from.lower[lane],
        .upper = from.upper[lane],
        .friction = from.friction[lane]};
    fill_lane(bodies, row, lane, to);
  }
  scale_row(roots, to);
}

inline void couple_rows(const LaneRow& row, const LaneRow& other, float relaxation, LaneCoupling& coupling) {
  for (int lane = 0; lane < lane_count; ++lane) {
    const float of_a = row.jacobian_a[0][lane] * other.jacobian_a[0][lane] +
                       row.jacobian_a[1][lane] * other.jacobian_a[1][lane] +
                       row.jacobian_a[2][lane] * other.jacobian_a[2][lane];
    const float of_b = row.jacobian_b[0][lane] * other.jacobian_b[0][lane] +
                       row.jacobian_b[1][lane] * other.jacobian_b[1][lane] +
                       row.jacobian_b[2][lane] * other.jacobian_b[2][lane];
    coupling.entry[lane] = relaxation * (of_a + of_b);
  }
}

template <typename Real>
inline void fill_lanes(const LaneFilling<Real>& from, LaneRow* rows, LaneCoupling* couplings) {
  for (int i = 0; i < from.row_count; ++i) {
    fill_row(from.bodies, from.roots, from.rows[i], rows[i]);
    for (int k = 0; k < i; ++k) {
      couple_rows(rows[i], rows[k], static_cast<float>(from.relaxation), *couplings++);
    }
  }
}

}  // namespace

}  // namespace cairn
