// Floor 4. The rows of a batch of contacts: compiled once for each instruction set, as lane_sweep.hpp is. All
// of it does, number for number, what write_contact_rows(), apply_impulse() and
// Bounds::clamp() do for one row.
#pragma once

#include <cairn/solvers/wide/lane_bodies.hpp>
#include <cairn/solvers/wide/lane_contact_data.hpp>
#include <cairn/solvers/wide/lane_filling.hpp>

namespace cairn {

namespace {

/// x . (m x), as dot().
template <typename Real>
inline Real inverse_mass_of(Real x, Real y, Real turn, Real mass_x, Real mass_y, Real mass_turn) {
  return sum_in_order<Real, Real>(x * (mass_x * x), y * (mass_y * y), turn * (mass_turn * turn));
}

/// Bias and softness of the normal rows of one point. The rule by value: to a compiler, lanes might lie over
/// it.
template <typename Real>
inline void stabilize_point(const LaneContactInput<Real>& __restrict from, RowRule<Real> rule, int point,
                            LaneContactBatch<Real>& __restrict batch) {
  const int row = batch.has_friction ? 2 * point : point;
  for (int lane = 0; lane < lane_count; ++lane) {
    const bool on_spring =
        rule.has_springs && !(from.separation[point][lane] >= 0) && from.rigid[point][lane] == 0;
    const Real softness = spring_softness(rule, batch.inverse[row][lane]);
    batch.softness[point][lane] = on_spring ? softness : Real(0);
    batch.bias[point][lane] = contact_bias(rule, from.separation[point][lane], from.slop_limit[lane],
                                           batch.rebound[point][lane], on_spring, false);
  }
}

/// A_ii of a row, as inverse_effective_mass() has it.
template <typename Real>
inline void measure_inverse(int row, bool is_friction, LaneContactBatch<Real>& __restrict batch) {
  for (int lane = 0; lane < lane_count; ++lane) {
    const Real n_x = batch.normal[0][lane], n_y = batch.normal[1][lane];
    const Real x = is_friction ? n_y : n_x, y = is_friction ? -n_x : n_y;
    batch.inverse[row][lane] = inverse_mass_of(-x, -y, -batch.turn_a[row][lane], batch.inverse_a[0][lane],
                                               batch.inverse_a[1][lane], batch.inverse_a[2][lane]) +
                               inverse_mass_of(x, y, batch.turn_b[row][lane], batch.inverse_b[0][lane],
                                               batch.inverse_b[1][lane], batch.inverse_b[2][lane]);
  }
}

/// Arms about the centres of mass, from what was gathered.
template <typename Real>
inline void measure_arms(const LaneContactInput<Real>& from, int point, LaneContactBatch<Real>& to) {
  const int row = to.has_friction ? 2 * point : point;
  for (int lane = 0; lane < lane_count; ++lane) {
    const Real x = from.normal[0][lane], y = from.normal[1][lane];
    const Real a_x = from.point[point][0][lane] - from.center_a[0][lane];
    const Real a_y = from.point[point][1][lane] - from.center_a[1][lane];
    const Real b_x = from.point[point][0][lane] - from.center_b[0][lane];
    const Real b_y = from.point[point][1][lane] - from.center_b[1][lane];
    to.turn_a[row][lane] = a_x * y - a_y * x;
    to.turn_b[row][lane] = b_x * y - b_y * x;
    if (to.has_friction) {
      to.turn_a[row + 1][lane] = a_x * -x - a_y * y;
      to.turn_b[row + 1][lane] = b_x * -x - b_y * y;
    }
  }
  measure_inverse(row, false, to);
  if (to.has_friction) measure_inverse(row + 1, true, to);
}

/// Everything but the impulses.
template <typename Real>
inline void measure_contacts(const LaneContactInput<Real>& from, const RowRule<Real>& rule,
                             LaneContactBatch<Real>& to) {
  for (int lane = 0; lane < lane_count; ++lane) {
    to.normal[0][lane] = from.normal[0][lane];
    to.normal[1][lane] = from.normal[1][lane];
  }
  for (int point = 0; point < to.points; ++point) {
    measure_arms(from, point, to);
    stabilize_point(from, rule, point, to);
  }
}

/// Gives the bodies of each contact `impulse` [N s] of one row. The three do not overlap, or no compiler
/// could tell that lanes are apart.
template <typename Real>
inline void push_bodies(const LaneContactBatch<Real>& __restrict batch, int row,
                        const Real* __restrict impulse, LaneBodyInput<Real>& __restrict bodies) {
  const bool is_friction = batch.has_friction && row % 2 == 1;
  const Real* const first = batch.normal[is_friction ? 1 : 0];
  const Real* const second = batch.normal[is_friction ? 0 : 1];
  const Real sign = is_friction ? Real(-1) : Real(1);
  for (int lane = 0; lane < lane_count; ++lane) {
    const Real x = first[lane], y = sign * second[lane], p = impulse[lane];
    bodies.velocity_a[0][lane] += batch.inverse_a[0][lane] * -x * p;
    bodies.velocity_a[1][lane] += batch.inverse_a[1][lane] * -y * p;
    bodies.velocity_a[2][lane] += batch.inverse_a[2][lane] * -batch.turn_a[row][lane] * p;
    bodies.velocity_b[0][lane] += batch.inverse_b[0][lane] * x * p;
    bodies.velocity_b[1][lane] += batch.inverse_b[1][lane] * y * p;
    bodies.velocity_b[2][lane] += batch.inverse_b[2][lane] * batch.turn_b[row][lane] * p;
  }
}

/// Leaves out what takes overlap back.
template <typename Real>
inline void begin_second_solve(LaneContactBatch<Real>& batch) {
  for (int i = 0; i < batch.points; ++i) {
    for (int lane = 0; lane < lane_count; ++lane) {
      const Real rebound = batch.rebound[i][lane], bias = batch.bias[i][lane];
      const Real only_room = bias > 0 ? Real(0) : bias;
      batch.bias[i][lane] = rebound > 0 ? rebound : only_room;
      batch.softness[i][lane] = Real(0);
    }
  }
}

/// The normal row of a point as sweeps read it, or that of friction.
template <bool is_friction, typename Real>
inline void fill_contact_row(const LaneContactBatch<Real>& __restrict batch, int row,
                             const LaneBodyInput<Real>& __restrict bodies, const LaneRoots& __restrict roots,
                             LaneRow& __restrict to) {
  const int point = batch.has_friction ? row / 2 : row;
  for (int lane = 0; lane < lane_count; ++lane) {
    const Real n_x = batch.normal[0][lane], n_y = batch.normal[1][lane];
    const Real x = is_friction ? n_y : n_x, y = is_friction ? -n_x : n_y;
    const Real limit = is_friction ? batch.friction[lane] * batch.impulse[row - 1][lane] : Real(0);
    fill_lane(bodies,
              LaneNumbers<Real>{.a = {-x, -y, -batch.turn_a[row][lane]},
                                .b = {x, y, batch.turn_b[row][lane]},
                                .bias = is_friction ? Real(0) : batch.bias[point][lane],
                                .softness = is_friction ? Real(0) : batch.softness[point][lane],
                                .impulse = batch.impulse[row][lane],
                                .lower = is_friction ? -limit : Real(0),
                                .upper = is_friction ? limit : static_cast<Real>(__builtin_inf()),
                                .friction = is_friction ? batch.friction[lane] : Real(0)},
              lane, to);
  }
  scale_row(roots, to);
}

/// The rows of a batch as sweeps read them.
template <int bytes, typename Real>
inline void fill_contacts(LaneContactBatch<Real>& batch, const LaneBatch& at, const LaneBody<Real>* velocity,
                          const LaneRoots& roots, Real relaxation, LaneRow* rows, LaneCoupling* couplings) {
  LaneBodyInput<Real> bodies;
  gather_bodies<bytes>(at, velocity, bodies);
  for (int i = 0; i < batch.rows(); ++i) {
    for (int lane = 0; lane < lane_count; ++lane) batch.impulse[i][lane] = batch.answer[i][lane];
    if (batch.has_friction && i % 2 == 1) {
      fill_contact_row<true>(batch, i, bodies, roots, rows[i]);
    } else {
      fill_contact_row<false>(batch, i, bodies, roots, rows[i]);
    }
    for (int k = 0; k < i; ++k) {
      couple_rows(rows[i], rows[k], static_cast<float>(relaxation), *couplings++);
    }
  }
}

/// Of friction: `wish` [N s], within what the normal impulse beside it gives.
template <typename Real>
inline Real within_friction(Real wish, Real friction, Real other) {
  const Real limit = friction * (other < 0 ? Real(0) : other);
  const Real below = limit < wish ? limit : wish;
  return below < -limit ? -limit : below;
}

/// Impulses with what sweeps have added, inside their bounds, and what that gives to the bodies.
template <int bytes, typename Real>
inline void empty_contacts(const LaneRow* rows, LaneContactBatch<Real>& batch, const LaneBatch& at,
                           LaneBody<Real>* velocity) {
  LaneBodyInput<Real> bodies;
  gather_bodies<bytes>(at, velocity, bodies);
  Real change[lane_count];
  for (int i = 0; i < batch.rows(); ++i) {
    const bool is_friction = batch.has_friction && i % 2 == 1;
    for (int lane = 0; lane < lane_count; ++lane) {
      const Real old = batch.impulse[i][lane];
      const Real wish =
          old + static_cast<Real>(rows[i].scale[lane]) * static_cast<Real>(rows[i].impulse[lane]);
      const Real other = is_friction ? batch.answer[i - 1][lane] : Real(0);
      const Real rubbing = within_friction(wish, batch.friction[lane], other);
      const Real pushing = wish < 0 ? Real(0) : wish;
      const Real now = is_friction ? rubbing : pushing;
      batch.answer[i][lane] = now;
      change[lane] = now - old;
    }
    push_bodies(batch, i, change, bodies);
  }
  scatter_bodies<bytes>(at, bodies, velocity);
}

/// One row of each contact, as it is weighed. Lists of its own, or no compiler could tell that lanes are
/// apart.
template <typename Real>
struct LaneWeights {
  Real inverse[lane_count];   // A_ii
  Real speed[lane_count];     // j v
  Real bias[lane_count];      // zeta
  Real softness[lane_count];  // gamma
};

/// A_ii and j v as inverse_effective_mass() and row_velocity() have them.
template <typename Real>
[[gnu::noinline]] inline void weigh_row(const LaneContactBatch<Real>& __restrict batch, int row,
                                        const LaneBodyInput<Real>& __restrict bodies,
                                        LaneWeights<Real>& __restrict to) {
  const bool is_friction = batch.has_friction && row % 2 == 1;
  const int point = batch.has_friction ? row / 2 : row;
  const Real* const first = batch.normal[is_friction ? 1 : 0];
  const Real* const second = batch.normal[is_friction ? 0 : 1];
  const Real sign = is_friction ? Real(-1) : Real(1);
  const Real zeros[lane_count] = {};
  const Real* const bias = is_friction ? zeros : batch.bias[point];
  const Real* const softness = is_friction ? zeros : batch.softness[point];
  for (int lane = 0; lane < lane_count; ++lane) {
    const Real x = first[lane], y = sign * second[lane];
    const Real turn_a = -batch.turn_a[row][lane], turn_b = batch.turn_b[row][lane];
    const Real speed_a = -x * bodies.velocity_a[0][lane] +
                         (-y * bodies.velocity_a[1][lane] + turn_a * bodies.velocity_a[2][lane]);
    const Real speed_b = x * bodies.velocity_b[0][lane] +
                         (y * bodies.velocity_b[1][lane] + turn_b * bodies.velocity_b[2][lane]);
    to.speed[lane] = speed_a + speed_b;
    to.bias[lane] = bias[lane];
    to.softness[lane] = softness[lane];
    to.inverse[lane] = batch.inverse[row][lane] + to.softness[lane];
  }
}

/// Adds to `squares` what starting_energy() is of all rows in each lane.
template <typename Real>
inline void weigh_start(const LaneContactBatch<Real>& batch, const LaneBodyInput<Real>& bodies,
                        Real* __restrict squares) {
  LaneWeights<Real> row;
  for (int point = 0; point < batch.points; ++point) {
    weigh_row(batch, batch.has_friction ? 2 * point : point, bodies, row);
    for (int lane = 0; lane < lane_count; ++lane) {
      const Real inverse = row.inverse[lane];
      const Real wish = (row.bias[lane] - row.speed[lane]) / (inverse > 0 ? inverse : Real(1));
      const Real pushing = wish < 0 ? Real(0) : wish;
      const Real energy = inverse * pushing * pushing;
      squares[lane] += inverse > 0 ? energy : Real(0);
    }
  }
}

/// Adds to `squares` what correction_energy() is of all rows in each lane.
template <typename Real>
inline void weigh_answer(const LaneContactBatch<Real>& __restrict batch, const LaneBodyInput<Real>& bodies,
                         Real* __restrict squares) {
  LaneWeights<Real> row;
  for (int i = 0; i < batch.rows(); ++i) {
    weigh_row(batch, i, bodies, row);
    const bool is_friction = batch.has_friction && i % 2 == 1;
    const Real* const other = batch.answer[is_friction ? i - 1 : i];
    for (int lane = 0; lane < lane_count; ++lane) {
      const Real inverse = row.inverse[lane], impulse = batch.answer[i][lane];
      const Real error = row.speed[lane] + row.softness[lane] * impulse - row.bias[lane];
      const Real wish = impulse - error / (inverse > 0 ? inverse : Real(1));
      const Real pushing = wish < 0 ? Real(0) : wish;
      const Real rubbing = within_friction(wish, batch.friction[lane], other[lane]);
      const Real e = impulse - (is_friction ? rubbing : pushing);
      const Real energy = inverse * e * e;
      squares[lane] += inverse > 0 ? energy : Real(0);
    }
  }
}

/// One of the two.
template <int bytes, typename Real>
inline void weigh_contacts(const LaneContactBatch<Real>& batch, const LaneBatch& at,
                           const LaneBody<Real>* velocity, LaneEnergy kind, Real* squares) {
  LaneBodyInput<Real> bodies;
  gather_bodies<bytes>(at, velocity, bodies);
  if (kind == LaneEnergy::at_start) {
    weigh_start(batch, bodies, squares);
  } else {
    weigh_answer(batch, bodies, squares);
  }
}

}  // namespace

}  // namespace cairn
