// Floor 4. One sweep over batches: compiled once for each instruction set, in a file of its own.
#pragma once

#include "solvers/wide/lane_bodies.hpp"

namespace cairn {

namespace {

/// The impulse inside its bounds: a NaN stays a NaN, as in Bounds::clamp.
template <int bytes, typename Number, typename Numbers>
inline Numbers clamped(Numbers impulse, const LaneRow<Number>& row, LaneKind kind,
                       const LaneRow<Number>* block, int lane) {
  if (kind.bounds == LaneBounds::none) return impulse;
  Numbers lower = load<Numbers>(row.lower + lane);
  if (kind.bounds == LaneBounds::lower) return impulse < lower ? lower : impulse;
  Numbers upper = load<Numbers>(row.upper + lane);
  if (kind.bounds != LaneBounds::both) {
    const LaneRow<Number>& normal = block[kind.normal];
    Numbers load_change = load<Numbers>(normal.scale + lane) * load<Numbers>(normal.impulse + lane);
    if (kind.bounds == LaneBounds::friction_of_two) {
      const LaneRow<Number>& second = block[kind.second_normal];
      load_change = load_change + load<Numbers>(second.scale + lane) * load<Numbers>(second.impulse + lane);
    }
    const Numbers change = load<Numbers>(row.friction + lane) * load_change;
    lower = lower - change;
    upper = upper + change;
  }
  const Numbers below = upper < impulse ? upper : impulse;
  return below < lower ? lower : below;
}

/// j v of a row at the bodies' changes.
template <typename Number, typename Numbers>
inline Numbers lane_velocity(const LaneRow<Number>& row, int lane, const Numbers* a, const Numbers* b) {
  const Numbers of_a = load<Numbers>(row.jacobian_a[0] + lane) * a[0] +
                       load<Numbers>(row.jacobian_a[1] + lane) * a[1] +
                       load<Numbers>(row.jacobian_a[2] + lane) * a[2];
  const Numbers of_b = load<Numbers>(row.jacobian_b[0] + lane) * b[0] +
                       load<Numbers>(row.jacobian_b[1] + lane) * b[1] +
                       load<Numbers>(row.jacobian_b[2] + lane) * b[2];
  return of_a + of_b;
}

/// Algorithm 1, the momentum before it, or what R_E sums up, for one batch, from `lane` on, as many lanes as
/// fit into a register. A row does not wait for velocities: what rows of its block before it have done to
/// them comes by way of A.
template <int bytes, int rows, LanePass pass, typename Number>
inline void update_lanes(LaneProblem<Number>& problem, const LaneBatch& batch, int lane) {
  typedef typename Register<Number, bytes>::Numbers Numbers;
  Numbers a[4], b[4], corrective[rows], change[rows];
  read_bodies<bytes>(problem.bodies, batch.body_a + lane, a);
  read_bodies<bytes>(problem.bodies, batch.body_b + lane, b);
  LaneRow<Number>* const block = problem.rows + batch.first_row;
  const LaneKind* const kinds = problem.kinds + batch.first_kind;
  for (int i = 0; i < rows; ++i) {
    const Numbers old = load<Numbers>(block[i].impulse + lane);
    const Numbers lacking = load<Numbers>(block[i].lacking + lane) - lane_velocity(block[i], lane, a, b) -
                            load<Numbers>(block[i].softness + lane) * old;
    corrective[i] = pass == LanePass::weigh ? lacking : problem.relaxation * lacking;
  }
  Numbers squares = load<Numbers>(problem.squares + lane);
  if constexpr (pass == LanePass::weigh) {
    for (int i = 0; i < rows; ++i) {
      const Numbers old = load<Numbers>(block[i].impulse + lane);
      const Numbers error = clamped<bytes>(old + corrective[i], block[i], kinds[i], block, lane) - old;
      squares = squares + error * error;
    }
    store(squares, problem.squares + lane);
    return;
  }
  Numbers largest = load<Numbers>(problem.largest_change + lane), work = load<Numbers>(problem.work + lane);
  const LaneCoupling<Number>* coupling = problem.couplings + batch.first_coupling;
  for (int i = 0; i < rows; ++i) {
    LaneRow<Number>& row = block[i];
    for (int k = 0; k < i; ++k, ++coupling) {
      corrective[i] = corrective[i] - load<Numbers>(coupling->entry + lane) * change[k];
    }
    const Numbers old = load<Numbers>(row.impulse + lane);
    Numbers step = corrective[i];
    if constexpr (pass == LanePass::momentum) {
      Number* const before = problem.before[batch.first_row + i].impulse + lane;
      step = problem.momentum * (old - load<Numbers>(before));
      store(old, before);
    }
    const Numbers impulse = clamped<bytes>(old + step, row, kinds[i], block, lane);
    change[i] = impulse - old;
    store(impulse, row.impulse + lane);
    squares = squares + change[i] * change[i];
    work = work + corrective[i] * change[i];
    const Numbers size = load<Numbers>(row.scale + lane) * (change[i] < 0 ? -change[i] : change[i]);
    largest = largest < size ? size : largest;
  }
  store(largest, problem.largest_change + lane);
  store(squares, problem.squares + lane);
  store(work, problem.work + lane);
  for (int i = 0; i < rows; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      a[axis] = a[axis] + load<Numbers>(block[i].jacobian_a[axis] + lane) * change[i];
      b[axis] = b[axis] + load<Numbers>(block[i].jacobian_b[axis] + lane) * change[i];
    }
  }
  write_moving_bodies<bytes>(a, problem.bodies, batch.body_a + lane, batch.moves_a >> lane);
  write_moving_bodies<bytes>(b, problem.bodies, batch.body_b + lane, batch.moves_b >> lane);
}

template <int bytes, int rows, LanePass pass, typename Number>
inline void update_batch(LaneProblem<Number>& problem, const LaneBatch& batch) {
  for (int lane = 0; lane < batch.used; lane += Register<Number, bytes>::count) {
    update_lanes<bytes, rows, pass>(problem, batch, lane);
  }
}

template <int bytes, LanePass pass, typename Number>
inline void pass_batches(LaneProblem<Number>& problem, int first, int last) {
  static_assert(most_lane_rows == 6);
  for (int i = first; i < last; ++i) {
    const LaneBatch& batch = problem.batches[i];
    if (batch.rows == 4) update_batch<bytes, 4, pass>(problem, batch);
    if (batch.rows == 2) update_batch<bytes, 2, pass>(problem, batch);
    if (batch.rows == 1) update_batch<bytes, 1, pass>(problem, batch);
    if (batch.rows == 3) update_batch<bytes, 3, pass>(problem, batch);
    if (batch.rows == 5) update_batch<bytes, 5, pass>(problem, batch);
    if (batch.rows == 6) update_batch<bytes, 6, pass>(problem, batch);
  }
}

/// Batches from first to last - 1.
template <int bytes, typename Number>
inline void pass_batches(LaneProblem<Number>& problem, LanePass pass, int first, int last) {
  if (pass == LanePass::momentum) {
    pass_batches<bytes, LanePass::momentum>(problem, first, last);
  } else if (pass == LanePass::weigh) {
    pass_batches<bytes, LanePass::weigh>(problem, first, last);
  } else {
    pass_batches<bytes, LanePass::sweep>(problem, first, last);
  }
}

}  // namespace

}  // namespace cairn
