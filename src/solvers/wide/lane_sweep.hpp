// Floor 4. One sweep over batches: compiled once for each instruction set, in a file of its own.
#pragma once

#include "solvers/wide/lane_data.hpp"

namespace cairn {

// All names here are those of the file that includes this one. The linker would keep one of several functions
// of the same name, perhaps one with instructions that this processor lacks: so nothing is called that is not
// here, neither of the standard library nor of Eigen.
namespace {

/// So many numbers as a register of `bytes` holds.
template <typename Number, int bytes>
struct Register {
  typedef Number Numbers __attribute__((vector_size(bytes)));
  static constexpr int count = bytes / static_cast<int>(sizeof(Number));
};

template <typename Numbers, typename Number>
inline Numbers load(const Number* from) {
  Numbers numbers;
  __builtin_memcpy(&numbers, from, sizeof(numbers));
  return numbers;
}

template <typename Numbers, typename Number>
inline void store(const Numbers& numbers, Number* to) {
  __builtin_memcpy(to, &numbers, sizeof(numbers));
}

/// Rows of 4 x 4 numbers become columns, in two rounds. In wider registers, several such groups lie side by
/// side.
template <int bytes>
struct Shuffle {
  typedef typename Register<float, bytes>::Numbers Floats;

  static Floats low(Floats a, Floats b) {
    if constexpr (bytes == 16) {
      return __builtin_shufflevector(a, b, 0, 4, 1, 5);
    } else if constexpr (bytes == 32) {
      return __builtin_shufflevector(a, b, 0, 8, 1, 9, 4, 12, 5, 13);
    } else {
      return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
    }
  }
  static Floats high(Floats a, Floats b) {
    if constexpr (bytes == 16) {
      return __builtin_shufflevector(a, b, 2, 6, 3, 7);
    } else if constexpr (bytes == 32) {
      return __builtin_shufflevector(a, b, 2, 10, 3, 11, 6, 14, 7, 15);
    } else {
      return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
    }
  }
  static Floats front(Floats a, Floats b) {
    if constexpr (bytes == 16) {
      return __builtin_shufflevector(a, b, 0, 1, 4, 5);
    } else if constexpr (bytes == 32) {
      return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
    } else {
      return __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
    }
  }
  static Floats back(Floats a, Floats b) {
    if constexpr (bytes == 16) {
      return __builtin_shufflevector(a, b, 2, 3, 6, 7);
    } else if constexpr (bytes == 32) {
      return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
    } else {
      return __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
    }
  }
  /// Every fourth body of a list, side by side.
  static Floats joined(const LaneBody<float>* bodies, const std::int32_t* body) {
    if constexpr (bytes == 16) {
      return load<Floats>(bodies[body[0]].velocity);
    } else {
      using Half = Shuffle<bytes / 2>;
      const auto first = Half::joined(bodies, body), second = Half::joined(bodies, body + bytes / 8);
      if constexpr (bytes == 32) {
        return __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7);
      } else {
        return __builtin_shufflevector(first, second, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
      }
    }
  }
  /// The reverse of joined().
  static void part(Floats numbers, LaneBody<float>* bodies, const std::int32_t* body) {
    if constexpr (bytes == 16) {
      store(numbers, bodies[body[0]].velocity);
    } else if constexpr (bytes == 32) {
      Shuffle<16>::part(__builtin_shufflevector(numbers, numbers, 0, 1, 2, 3), bodies, body);
      Shuffle<16>::part(__builtin_shufflevector(numbers, numbers, 4, 5, 6, 7), bodies, body + 4);
    } else {
      Shuffle<32>::part(__builtin_shufflevector(numbers, numbers, 0, 1, 2, 3, 4, 5, 6, 7), bodies, body);
      Shuffle<32>::part(__builtin_shufflevector(numbers, numbers, 8, 9, 10, 11, 12, 13, 14, 15), bodies,
                        body + 8);
    }
  }
};

/// x, y and turning of so many bodies, a register each: four lists of four numbers become three registers.
template <int bytes, typename Numbers>
[[gnu::always_inline]] inline void read_bodies(const LaneBody<float>* bodies, const std::int32_t* body,
                                               Numbers* velocity) {
  using Of = Shuffle<bytes>;
  const Numbers body0 = Of::joined(bodies, body), body1 = Of::joined(bodies, body + 1);
  const Numbers body2 = Of::joined(bodies, body + 2), body3 = Of::joined(bodies, body + 3);
  const Numbers low01 = Of::low(body0, body1), low23 = Of::low(body2, body3);
  velocity[0] = Of::front(low01, low23);
  velocity[1] = Of::back(low01, low23);
  velocity[2] = Of::front(Of::high(body0, body1), Of::high(body2, body3));
}

/// All of them can move.
template <int bytes, typename Numbers>
[[gnu::always_inline]] inline void write_bodies(const Numbers* velocity, LaneBody<float>* bodies,
                                                const std::int32_t* body) {
  using Of = Shuffle<bytes>;
  const Numbers zero = {};
  const Numbers low_xy = Of::low(velocity[0], velocity[1]), low_z = Of::low(velocity[2], zero);
  const Numbers high_xy = Of::high(velocity[0], velocity[1]), high_z = Of::high(velocity[2], zero);
  Of::part(Of::front(low_xy, low_z), bodies, body);
  Of::part(Of::back(low_xy, low_z), bodies, body + 1);
  Of::part(Of::front(high_xy, high_z), bodies, body + 2);
  Of::part(Of::back(high_xy, high_z), bodies, body + 3);
}

/// Any other numbers, one by one.
template <int bytes, typename Number, typename Numbers>
[[gnu::always_inline]] inline void read_bodies(const LaneBody<Number>* bodies, const std::int32_t* body,
                                               Numbers* velocity) {
  for (int axis = 0; axis < 3; ++axis) {
    Number of_axis[Register<Number, bytes>::count];
    for (int lane = 0; lane < Register<Number, bytes>::count; ++lane) {
      of_axis[lane] = bodies[body[lane]].velocity[axis];
    }
    velocity[axis] = load<Numbers>(of_axis);
  }
}

template <int bytes, typename Number, typename Numbers>
[[gnu::always_inline]] inline void write_bodies(const Numbers* velocity, LaneBody<Number>* bodies,
                                                const std::int32_t* body) {
  for (int axis = 0; axis < 3; ++axis) {
    for (int lane = 0; lane < Register<Number, bytes>::count; ++lane) {
      bodies[body[lane]].velocity[axis] = velocity[axis][lane];
    }
  }
}

/// Those that can move: several threads may read one that cannot, and nobody writes it.
template <int bytes, typename Number, typename Numbers>
[[gnu::always_inline]] inline void write_moving_bodies(const Numbers* velocity, LaneBody<Number>* bodies,
                                                       const std::int32_t* body, unsigned moves) {
  constexpr int count = Register<Number, bytes>::count;
  constexpr unsigned all = (1u << count) - 1;
  if ((moves & all) == all) {
    write_bodies<bytes>(velocity, bodies, body);
    return;
  }
  for (int lane = 0; lane < count; ++lane) {
    if ((moves >> lane & 1u) == 0) continue;
    for (int axis = 0; axis < 3; ++axis) bodies[body[lane]].velocity[axis] = velocity[axis][lane];
  }
}

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

/// Algorithm 1, or the momentum before it, for one batch, from `lane` on, as many lanes as fit into a
/// register. A row does not wait for velocities: what rows of its block before it have done to them comes by
/// way of A.
template <int bytes, int rows, LanePass pass, typename Number>
inline void update_lanes(LaneProblem<Number>& problem, const LaneBatch& batch, int lane) {
  typedef typename Register<Number, bytes>::Numbers Numbers;
  Numbers a[3], b[3], corrective[rows], change[rows];
  read_bodies<bytes>(problem.bodies, batch.body_a + lane, a);
  read_bodies<bytes>(problem.bodies, batch.body_b + lane, b);
  LaneRow<Number>* const block = problem.rows + batch.first_row;
  const LaneKind* const kinds = problem.kinds + batch.first_kind;
  for (int i = 0; i < rows; ++i) {
    const Numbers old = load<Numbers>(block[i].impulse + lane);
    const Numbers lacking = load<Numbers>(block[i].lacking + lane) - lane_velocity(block[i], lane, a, b) -
                            load<Numbers>(block[i].softness + lane) * old;
    corrective[i] = problem.relaxation * lacking;
  }
  Numbers largest = load<Numbers>(problem.largest_change + lane);
  Numbers squares = load<Numbers>(problem.squares + lane), work = load<Numbers>(problem.work + lane);
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
  } else {
    pass_batches<bytes, LanePass::sweep>(problem, first, last);
  }
}

}  // namespace

}  // namespace cairn
