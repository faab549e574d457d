// Floor 4. Scales the rows of a batch: compiled once for each instruction set, as lane_sweep.hpp is.
#pragma once

#include "solvers/wide/lane_data.hpp"

namespace cairn {

namespace {

inline float square_root(float x) { return __builtin_sqrtf(x); }
inline double square_root(double x) { return __builtin_sqrt(x); }
inline long double square_root(long double x) { return __builtin_sqrtl(x); }

/// What row `from` is in lanes. Between bodies that nothing moves it has nothing to do but to keep its
/// bounds.
template <typename Real, typename Number>
inline void fill_row(const LaneBodyInput<Real>& bodies, const LaneInput<Real>& from, LaneRow<Number>& to) {
  for (int lane = 0; lane < lane_count; ++lane) {
    const Real a0 = from.jacobian_a[0][lane], a1 = from.jacobian_a[1][lane], a2 = from.jacobian_a[2][lane];
    const Real b0 = from.jacobian_b[0][lane], b1 = from.jacobian_b[1][lane], b2 = from.jacobian_b[2][lane];
    const Real impulse = from.impulse[lane], softness = from.softness[lane];
    const Real lacking = from.bias[lane] -
                         ((a0 * bodies.velocity_a[0][lane] + a1 * bodies.velocity_a[1][lane] +
                           a2 * bodies.velocity_a[2][lane]) +
                          (b0 * bodies.velocity_b[0][lane] + b1 * bodies.velocity_b[1][lane] +
                           b2 * bodies.velocity_b[2][lane])) -
                         softness * impulse;
    const Real of_a0 = a0 * bodies.root_a[0][lane], of_b0 = b0 * bodies.root_b[0][lane];
    const Real of_a1 = a1 * bodies.root_a[1][lane], of_b1 = b1 * bodies.root_b[1][lane];
    const Real of_a2 = a2 * bodies.root_a[2][lane], of_b2 = b2 * bodies.root_b[2][lane];
    const Real inverse = (of_a0 * of_a0 + of_a1 * of_a1 + of_a2 * of_a2) +
                         (of_b0 * of_b0 + of_b1 * of_b1 + of_b2 * of_b2) + softness;
    const Real root = square_root(inverse > 0 ? inverse : Real(1));
    const Real scale = 1 / root;
    to.jacobian_a[0][lane] = static_cast<Number>(of_a0 * scale);
    to.jacobian_a[1][lane] = static_cast<Number>(of_a1 * scale);
    to.jacobian_a[2][lane] = static_cast<Number>(of_a2 * scale);
    to.jacobian_b[0][lane] = static_cast<Number>(of_b0 * scale);
    to.jacobian_b[1][lane] = static_cast<Number>(of_b1 * scale);
    to.jacobian_b[2][lane] = static_cast<Number>(of_b2 * scale);
    to.lacking[lane] = static_cast<Number>(lacking * (inverse > 0 ? scale : Real(0)));
    to.impulse[lane] = 0;
    to.lower[lane] = static_cast<Number>((from.lower[lane] - impulse) * root);
    to.upper[lane] = static_cast<Number>((from.upper[lane] - impulse) * root);
    to.friction[lane] = static_cast<Number>(from.friction[lane] * root);
    to.softness[lane] = static_cast<Number>(softness * scale * scale);
    to.scale[lane] = static_cast<Number>(scale);
  }
}

template <typename Number>
inline void couple_rows(const LaneRow<Number>& row, const LaneRow<Number>& other, Number relaxation,
                        LaneCoupling<Number>& coupling) {
  for (int lane = 0; lane < lane_count; ++lane) {
    const Number of_a = row.jacobian_a[0][lane] * other.jacobian_a[0][lane] +
                        row.jacobian_a[1][lane] * other.jacobian_a[1][lane] +
                        row.jacobian_a[2][lane] * other.jacobian_a[2][lane];
    const Number of_b = row.jacobian_b[0][lane] * other.jacobian_b[0][lane] +
                        row.jacobian_b[1][lane] * other.jacobian_b[1][lane] +
                        row.jacobian_b[2][lane] * other.jacobian_b[2][lane];
    coupling.entry[lane] = relaxation * (of_a + of_b);
  }
}

template <typename Real, typename Number>
inline void fill_lanes(const LaneFilling<Real>& from, LaneRow<Number>* rows,
                       LaneCoupling<Number>* couplings) {
  for (int i = 0; i < from.row_count; ++i) {
    fill_row(from.bodies, from.rows[i], rows[i]);
    for (int k = 0; k < i; ++k) {
      couple_rows(rows[i], rows[k], static_cast<Number>(from.relaxation), *couplings++);
    }
  }
}

}  // namespace

}  // namespace cairn
