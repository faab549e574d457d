// Floor 4. The warm start of a batch of contacts, and a sweep over them as they are: compiled once for each
// instruction set, as lane_sweep.hpp is. Both do, number for number, what apply_impulse() and
// SequentialImpulse do for one row after the other.
#pragma once

#include "solvers/wide/lane_bodies.hpp"
#include "solvers/wide/lane_contact_data.hpp"

namespace cairn {

namespace {

/// The Jacobian of one row of each contact.
template <typename Numbers>
struct LaneJacobian {
  Numbers x, y, turn_a, turn_b;
};

template <typename Numbers, bool is_friction, typename Real>
inline LaneJacobian<Numbers> jacobian_of(const LaneContactBatch<Real>& batch, int row, int lane) {
  const Numbers n_x = load<Numbers>(batch.normal[0] + lane), n_y = load<Numbers>(batch.normal[1] + lane);
  const Numbers turn_a = -load<Numbers>(batch.turn_a[row] + lane);
  const Numbers turn_b = load<Numbers>(batch.turn_b[row] + lane);
  if constexpr (is_friction) return {n_y, -n_x, turn_a, turn_b};
  return {n_x, n_y, turn_a, turn_b};
}

/// Gives the bodies the impulse p [N s] of one row.
template <typename Numbers, typename Real>
[[gnu::always_inline]] inline void push_lanes(const LaneContactBatch<Real>& batch, int lane,
                                              const LaneJacobian<Numbers>& j, const Numbers& p, Numbers* a,
                                              Numbers* b) {
  a[0] = a[0] + load<Numbers>(batch.inverse_a[0] + lane) * -j.x * p;
  a[1] = a[1] + load<Numbers>(batch.inverse_a[1] + lane) * -j.y * p;
  a[2] = a[2] + load<Numbers>(batch.inverse_a[2] + lane) * j.turn_a * p;
  b[0] = b[0] + load<Numbers>(batch.inverse_b[0] + lane) * j.x * p;
  b[1] = b[1] + load<Numbers>(batch.inverse_b[1] + lane) * j.y * p;
  b[2] = b[2] + load<Numbers>(batch.inverse_b[2] + lane) * j.turn_b * p;
}

/// What is done to one row of each contact: its warm start.
struct LaneWarmStart {
  template <bool is_friction, typename Numbers, typename Real>
  [[gnu::always_inline]] void at(LaneContactBatch<Real>& batch, int row, int lane, Numbers* a, Numbers* b) {
    const LaneJacobian<Numbers> j = jacobian_of<Numbers, is_friction>(batch, row, lane);
    push_lanes(batch, lane, j, load<Numbers>(batch.answer[row] + lane), a, b);
  }
};

/// Algorithm 1.
template <typename Real>
struct LaneUpdate {
  Real relaxation;  // omega
  Real* largest;    // [N s] step of an impulse in each lane

  template <bool is_friction, typename Numbers>
  [[gnu::always_inline]] void at(LaneContactBatch<Real>& batch, int row, int lane, Numbers* a, Numbers* b) {
    const LaneJacobian<Numbers> j = jacobian_of<Numbers, is_friction>(batch, row, lane);
    const Numbers jv =
        (-j.x * a[0] + (-j.y * a[1] + j.turn_a * a[2])) + (j.x * b[0] + (j.y * b[1] + j.turn_b * b[2]));
    const Numbers zero = {}, one = zero + Real(1), old = load<Numbers>(batch.answer[row] + lane);
    Numbers inverse = load<Numbers>(batch.inverse[row] + lane), lacking = zero - jv;
    if constexpr (!is_friction) {
      const int point = batch.has_friction ? row / 2 : row;
      const Numbers softness = load<Numbers>(batch.softness[point] + lane);
      inverse = inverse + softness;
      lacking = load<Numbers>(batch.bias[point] + lane) - jv - softness * old;
    }
    const Numbers mass = inverse > 0 ? one / inverse : zero;
    const Numbers wish = old + relaxation * (lacking * mass);
    Numbers now = wish < 0 ? zero : wish;
    if constexpr (is_friction) {
      const Numbers limit =
          load<Numbers>(batch.friction + lane) * load<Numbers>(batch.answer[row - 1] + lane);
      const Numbers below = limit < wish ? limit : wish;
      now = below < -limit ? -limit : below;
    }
    store(now, batch.answer[row] + lane);
    const Numbers step = now - old, size = step < 0 ? -step : step;
    const Numbers most = load<Numbers>(largest + lane);
    store(Numbers(most < size ? size : most), largest + lane);
    push_lanes(batch, lane, j, step, a, b);
  }
};

/// Something for all rows of a batch, as many lanes at a time as fit into two registers: what is done to one
/// of them need not wait for the other.
template <int bytes, typename Real, typename Work>
inline void work_on_contacts(LaneContactBatch<Real>& batch, const LaneBatch& at, LaneBody<Real>* bodies,
                             Work& work) {
  constexpr int width = body_bytes<Real, bytes>;
  typedef typename Register<Real, width>::Numbers Numbers;
  constexpr int count = Register<Real, width>::count, side_by_side = 2;
  for (int first = 0; first < at.used; first += side_by_side * count) {
    Numbers a[side_by_side][4], b[side_by_side][4];
    for (int i = 0; i < side_by_side; ++i) {
      read_bodies<width>(bodies, at.body_a + first + i * count, a[i]);
      read_bodies<width>(bodies, at.body_b + first + i * count, b[i]);
    }
    for (int point = 0; point < batch.points; ++point) {
      const int row = batch.has_friction ? 2 * point : point;
      for (int i = 0; i < side_by_side; ++i) {
        work.template at<false>(batch, row, first + i * count, a[i], b[i]);
      }
      for (int i = 0; i < side_by_side && batch.has_friction; ++i) {
        work.template at<true>(batch, row + 1, first + i * count, a[i], b[i]);
      }
    }
    for (int i = 0; i < side_by_side; ++i) {
      const int lane = first + i * count;
      write_moving_bodies<width>(a[i], bodies, at.body_a + lane, at.moves_a >> lane);
      write_moving_bodies<width>(b[i], bodies, at.body_b + lane, at.moves_b >> lane);
    }
  }
}

/// The warm start.
template <int bytes, typename Real>
inline void push_contacts(LaneContactBatch<Real>& batch, const LaneBatch& at, LaneBody<Real>* bodies) {
  LaneWarmStart warm_start;
  work_on_contacts<bytes>(batch, at, bodies, warm_start);
}

/// One sweep, in the problem's own precision.
template <int bytes, typename Real>
inline void sweep_contacts(LaneContactBatch<Real>& batch, const LaneBatch& at, Real relaxation,
                           LaneBody<Real>* bodies, Real* largest) {
  LaneUpdate<Real> update = {relaxation, largest};
  work_on_contacts<bytes>(batch, at, bodies, update);
}

}  // namespace

}  // namespace cairn
