// Floor 4. One sweep over batches: compiled once for each instruction set, in a file of its own.
#pragma once

#include <cairn/solvers/wide/lane_bodies.hpp>

namespace cairn {

namespace {

/// The impulse inside its bounds: a NaN stays a NaN, as in Bounds::clamp.
template <int bytes, typename Numbers>
inline Numbers clamped(Numbers impulse, const LaneRow& row, LaneKind kind, const LaneRow* block, int lane) {
  if (kind.bounds == LaneBounds::none) return impulse;
  Numbers lower = load<Numbers>(row.lower + lane);
  if (kind.bounds == LaneBounds::lower) return impulse < lower ? lower : impulse;
  Numbers upper = load<Numbers>(row.upper + lane);
  if (kind.bounds != LaneBounds::both) {
    const LaneRow& normal = block[kind.normal];
    Numbers load_change = load<Numbers>(normal.scale + lane) * load<Numbers>(normal.impulse + lane);
    if (kind.bounds == LaneBounds::friction_of_two) {
      const LaneRow& second = block[kind.second_normal];
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
template <typename Numbers>
inline Numbers lane_velocity(const LaneRow& row, int lane, const Numbers* a, const Numbers* b) {
  const Numbers of_a = load<Numbers>(row.jacobian_a[0] + lane) * a[0] +
                       load<Numbers>(row.jacobian_a[1] + lane) * a[1] +
                       load<Numbers>(row.jacobian_a[2] + lane) * a[2];
  const Numbers of_b = load<Numbers>(row.jacobian_b[0] + lane) * b[0] +
                       load<Numbers>(row.jacobian_b[1] + lane) * b[1] +
                       load<Numbers>(row.jacobian_b[2] + lane) * b[2];
  return of_a + of_b;
}

/// What a batch is on its way to, in registers.
template <int rows, typename Numbers>
struct LaneWork {
  Numbers a[4], b[4];                      // velocities of the bodies
  Numbers corrective[rows], change[rows];  // of the impulses
  Numbers largest, squares, work;          // as in LaneProblem
};

/// The kind of a row: of contacts with friction, nobody needs to look.
template <bool is_contact>
inline LaneKind kind_of_row(const LaneKind* kinds, int row) {
  if constexpr (!is_contact) return kinds[row];
  return {.bounds = row % 2 == 0 ? LaneBounds::lower : LaneBounds::friction,
          .normal = static_cast<std::uint8_t>(row - row % 2)};
}

/// A row of each block in its turn. It does not wait for velocities: what rows of its block before it have
/// done to them comes by way of A.
template <int bytes, LanePass pass, bool is_contact, int i, int rows, typename Numbers>
[[gnu::always_inline]] inline void update_row(LaneProblem& problem, const LaneBatch& batch, int lane,
                                              LaneWork<rows, Numbers>& at) {
  LaneRow* const block = problem.rows + batch.first_row;
  LaneRow& row = block[i];
  const LaneKind kind = kind_of_row<is_contact>(problem.kinds + batch.first_kind, i);
  const Numbers old = load<Numbers>(row.impulse + lane);
  if constexpr (pass == LanePass::weigh) {
    const Numbers error = clamped<bytes>(old + at.corrective[i], row, kind, block, lane) - old;
    at.squares = at.squares + error * error;
    return;
  }
  const LaneCoupling* const coupling = problem.couplings + batch.first_coupling + i * (i - 1) / 2;
  for (int k = 0; k < i; ++k) {
    at.corrective[i] = at.corrective[i] - load<Numbers>(coupling[k].entry + lane) * at.change[k];
  }
  Numbers step = at.corrective[i];
  if constexpr (pass == LanePass::momentum) {
    float* const before = problem.before[batch.first_row + i].impulse + lane;
    step = problem.momentum * (old - load<Numbers>(before));
    store(old, before);
  }
  const Numbers impulse = clamped<bytes>(old + step, row, kind, block, lane);
  const Numbers change = at.change[i] = impulse - old;
  store(impulse, row.impulse + lane);
  at.squares = at.squares + change * change;
  at.work = at.work + at.corrective[i] * change;
  const Numbers size = load<Numbers>(row.scale + lane) * (change < 0 ? -change : change);
  at.largest = at.largest < size ? size : at.largest;
}

/// Row after row, from i on.
template <int bytes, LanePass pass, bool is_contact, int i, int rows, typename Numbers>
[[gnu::always_inline]] inline void update_rows(LaneProblem& problem, const LaneBatch& batch, int lane,
                                               LaneWork<rows, Numbers>& at) {
  update_row<bytes, pass, is_contact, i>(problem, batch, lane, at);
  if constexpr (i + 1 < rows) update_rows<bytes, pass, is_contact, i + 1>(problem, batch, lane, at);
}

/// Algorithm 1, the momentum before it, or what R_E sums up, for one batch, from `lane` on, as many lanes as
/// fit into a register.
template <int bytes, int rows, LanePass pass, bool is_contact>
inline void update_lanes(LaneProblem& problem, const LaneBatch& batch, int lane) {
  typedef typename Register<float, bytes>::Numbers Numbers;
  LaneWork<rows, Numbers> at;
  read_bodies<bytes>(problem.bodies, batch.body_a + lane, at.a);
  read_bodies<bytes>(problem.bodies, batch.body_b + lane, at.b);
  const LaneRow* const block = problem.rows + batch.first_row;
  for (int i = 0; i < rows; ++i) {
    const Numbers lacking = load<Numbers>(block[i].lacking + lane) -
                            lane_velocity(block[i], lane, at.a, at.b) -
                            load<Numbers>(block[i].softness + lane) * load<Numbers>(block[i].impulse + lane);
    at.corrective[i] = pass == LanePass::weigh ? lacking : problem.relaxation * lacking;
  }
  at.largest = load<Numbers>(problem.largest_change + lane);
  at.squares = load<Numbers>(problem.squares + lane);
  at.work = load<Numbers>(problem.work + lane);
  update_rows<bytes, pass, is_contact, 0>(problem, batch, lane, at);
  store(at.squares, problem.squares + lane);
  if constexpr (pass == LanePass::weigh) return;
  store(at.largest, problem.largest_change + lane);
  store(at.work, problem.work + lane);
  for (int i = 0; i < rows; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      at.a[axis] = at.a[axis] + load<Numbers>(block[i].jacobian_a[axis] + lane) * at.change[i];
      at.b[axis] = at.b[axis] + load<Numbers>(block[i].jacobian_b[axis] + lane) * at.change[i];
    }
  }
  write_moving_bodies<bytes>(at.a, problem.bodies, batch.body_a + lane, batch.moves_a >> lane);
  write_moving_bodies<bytes>(at.b, problem.bodies, batch.body_b + lane, batch.moves_b >> lane);
}

template <int bytes, int rows, LanePass pass, bool is_contact>
inline void update_batch(LaneProblem& problem, const LaneBatch& batch) {
  for (int lane = 0; lane < batch.used; lane += Register<float, bytes>::count) {
    update_lanes<bytes, rows, pass, is_contact>(problem, batch, lane);
  }
}

template <int bytes, LanePass pass>
inline void pass_batches(LaneProblem& problem, int first, int last) {
  static_assert(most_lane_rows == 6);
  for (int i = first; i < last; ++i) {
    const LaneBatch& batch = problem.batches[i];
    if (batch.is_contact && batch.rows == 4) {
      update_batch<bytes, 4, pass, true>(problem, batch);
    } else if (batch.is_contact && batch.rows == 2) {
      update_batch<bytes, 2, pass, true>(problem, batch);
    } else {
      if (batch.rows == 1) update_batch<bytes, 1, pass, false>(problem, batch);
      if (batch.rows == 2) update_batch<bytes, 2, pass, false>(problem, batch);
      if (batch.rows == 3) update_batch<bytes, 3, pass, false>(problem, batch);
      if (batch.rows == 4) update_batch<bytes, 4, pass, false>(problem, batch);
      if (batch.rows == 5) update_batch<bytes, 5, pass, false>(problem, batch);
      if (batch.rows == 6) update_batch<bytes, 6, pass, false>(problem, batch);
    }
  }
}

/// Batches from first to last - 1.
template <int bytes>
inline void pass_batches(LaneProblem& problem, LanePass pass, int first, int last) {
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
