// Floor 4. The warm start of a batch of contacts, and a sweep over them as they are: compiled once for each
// instruction set, as lane_sweep.hpp is. Both do, number for number, what apply_impulse() and
// SequentialImpulse do for one row after the other.
#pragma once

#include <cairn/solvers/wide/lane_bodies.hpp>
#include <cairn/solvers/wide/lane_contact_data.hpp>

namespace cairn {

namespace {

/// A direction of each contact, in which it has a row at every point: the normal, or that of friction.
template <typename Numbers>
struct LaneDirection {
  Numbers x, y;            // from the first body to the second
  Numbers a_x, a_y;        // [1/kg] what an impulse of 1 N s does to the first bodies
  Numbers b_x, b_y;        // [1/kg] and to the second bodies
  Numbers a_turn, b_turn;  // [1/(kg m^2)] inverse inertias
};

template <bool is_friction, typename Numbers, typename Real>
[[gnu::always_inline]] inline void take_direction(const LaneContactBatch<Real>& batch, int lane,
                                                  LaneDirection<Numbers>& to) {
  const Numbers n_x = load<Numbers>(batch.normal[0] + lane), n_y = load<Numbers>(batch.normal[1] + lane);
  to.x = is_friction ? n_y : n_x;
  to.y = is_friction ? -n_x : n_y;
  to.a_x = load<Numbers>(batch.inverse_a[0] + lane) * -to.x;
  to.a_y = load<Numbers>(batch.inverse_a[1] + lane) * -to.y;
  to.b_x = load<Numbers>(batch.inverse_b[0] + lane) * to.x;
  to.b_y = load<Numbers>(batch.inverse_b[1] + lane) * to.y;
  to.a_turn = load<Numbers>(batch.inverse_a[2] + lane);
  to.b_turn = load<Numbers>(batch.inverse_b[2] + lane);
}

/// Velocities of the bodies of so many contacts.
template <typename Numbers>
struct LaneVelocities {
  Numbers a[4], b[4];  // x, y, rotation, 0
};

/// Gives the bodies the impulse p [N s] of one row.
template <typename Numbers>
[[gnu::always_inline]] inline void push_lanes(const LaneDirection<Numbers>& n, const Numbers& turn_a,
                                              const Numbers& turn_b, const Numbers& p,
                                              LaneVelocities<Numbers>& v) {
  v.a[0] = v.a[0] + n.a_x * p;
  v.a[1] = v.a[1] + n.a_y * p;
  v.a[2] = v.a[2] + n.a_turn * turn_a * p;
  v.b[0] = v.b[0] + n.b_x * p;
  v.b[1] = v.b[1] + n.b_y * p;
  v.b[2] = v.b[2] + n.b_turn * turn_b * p;
}

/// What is done to one row of each contact: its warm start.
struct LaneWarmStart {
  template <bool is_friction, typename Numbers, typename Real>
  [[gnu::always_inline]] void at(LaneContactBatch<Real>& batch, int row, int lane,
                                 const LaneDirection<Numbers>& n, LaneVelocities<Numbers>& v) {
    const Numbers turn_a = -load<Numbers>(batch.turn_a[row] + lane);
    const Numbers turn_b = load<Numbers>(batch.turn_b[row] + lane);
    push_lanes(n, turn_a, turn_b, load<Numbers>(batch.answer[row] + lane), v);
  }
};

/// Algorithm 1.
template <typename Real>
struct LaneUpdate {
  Real relaxation;  // omega
  Real* largest;    // [N s] step of an impulse in each lane

  template <bool is_friction, typename Numbers>
  [[gnu::always_inline]] void at(LaneContactBatch<Real>& batch, int row, int lane,
                                 const LaneDirection<Numbers>& n, LaneVelocities<Numbers>& v) {
    const Numbers turn_a = -load<Numbers>(batch.turn_a[row] + lane);
    const Numbers turn_b = load<Numbers>(batch.turn_b[row] + lane);
    const Numbers jv = sum_in_order<Real>(-n.x * v.a[0], -n.y * v.a[1], turn_a * v.a[2]) +
                       sum_in_order<Real>(n.x * v.b[0], n.y * v.b[1], turn_b * v.b[2]);
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
    push_lanes(n, turn_a, turn_b, step, v);
  }
};

/// Something for all rows of a batch, as many lanes at a time as fit into a register.
template <int bytes, typename Real, typename Work>
inline void work_on_contacts(LaneContactBatch<Real>& batch, const LaneBatch& at, LaneBody<Real>* bodies,
                             Work& work) {
  constexpr int width = body_bytes<Real, bytes>;
  typedef typename Register<Real, width>::Numbers Numbers;
  for (int lane = 0; lane < at.used; lane += Register<Real, width>::count) {
    LaneVelocities<Numbers> v;
    read_bodies<width>(bodies, at.body_a + lane, v.a);
    read_bodies<width>(bodies, at.body_b + lane, v.b);
    LaneDirection<Numbers> normal, friction;
    take_direction<false>(batch, lane, normal);
    take_direction<true>(batch, lane, friction);
    for (int point = 0; point < batch.points; ++point) {
      const int row = batch.has_friction ? 2 * point : point;
      work.template at<false>(batch, row, lane, normal, v);
      if (batch.has_friction) work.template at<true>(batch, row + 1, lane, friction, v);
    }
    write_moving_bodies<width>(v.a, bodies, at.body_a + lane, at.moves_a >> lane);
    write_moving_bodies<width>(v.b, bodies, at.body_b + lane, at.moves_b >> lane);
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
