// Floor 4. Bodies of a batch in registers: compiled once for each instruction set, in a file of its own.
#pragma once

#include <cairn/solvers/wide/lane_data.hpp>

namespace cairn {

// All names here are those of the file that includes this one. The linker would keep one of several functions
// of the same name, perhaps one with instructions that this processor lacks: so nothing is called that is not
// here, neither of the standard library nor of Eigen.
namespace {

/// Three products in the order of dot().
template <typename Real, typename Numbers>
[[gnu::always_inline]] inline Numbers sum_in_order(const Numbers& x, const Numbers& y, const Numbers& z) {
  return sizeof(Real) == sizeof(double) ? (x + y) + z : x + (y + z);
}

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
      return load<Floats>(bodies[body[0]].numbers);
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
      store(numbers, bodies[body[0]].numbers);
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

/// The four numbers of so many bodies, a register each.
template <int bytes, typename Numbers>
[[gnu::always_inline]] inline void read_bodies(const LaneBody<float>* bodies, const std::int32_t* body,
                                               Numbers* numbers) {
  using Of = Shuffle<bytes>;
  const Numbers body0 = Of::joined(bodies, body), body1 = Of::joined(bodies, body + 1);
  const Numbers body2 = Of::joined(bodies, body + 2), body3 = Of::joined(bodies, body + 3);
  const Numbers low01 = Of::low(body0, body1), low23 = Of::low(body2, body3);
  numbers[0] = Of::front(low01, low23);
  numbers[1] = Of::back(low01, low23);
  const Numbers high01 = Of::high(body0, body1), high23 = Of::high(body2, body3);
  numbers[2] = Of::front(high01, high23);
  numbers[3] = Of::back(high01, high23);
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

/// The same of double precision, four bodies at a time.
template <int bytes, typename Numbers>
requires(bytes == 32)
    [[gnu::always_inline]] inline void read_bodies(const LaneBody<double>* bodies, const std::int32_t* body,
                                                   Numbers* numbers) {
  const Numbers body0 = load<Numbers>(bodies[body[0]].numbers),
                body1 = load<Numbers>(bodies[body[1]].numbers);
  const Numbers body2 = load<Numbers>(bodies[body[2]].numbers),
                body3 = load<Numbers>(bodies[body[3]].numbers);
  const Numbers xz01 = __builtin_shufflevector(body0, body1, 0, 4, 2, 6);
  const Numbers xz23 = __builtin_shufflevector(body2, body3, 0, 4, 2, 6);
  const Numbers yw01 = __builtin_shufflevector(body0, body1, 1, 5, 3, 7);
  const Numbers yw23 = __builtin_shufflevector(body2, body3, 1, 5, 3, 7);
  numbers[0] = __builtin_shufflevector(xz01, xz23, 0, 1, 4, 5);
  numbers[1] = __builtin_shufflevector(yw01, yw23, 0, 1, 4, 5);
  numbers[2] = __builtin_shufflevector(xz01, xz23, 2, 3, 6, 7);
  numbers[3] = __builtin_shufflevector(yw01, yw23, 2, 3, 6, 7);
}

/// Any other numbers, one by one.
template <int bytes, typename Number, typename Numbers>
[[gnu::always_inline]] inline void read_bodies(const LaneBody<Number>* bodies, const std::int32_t* body,
                                               Numbers* numbers) {
  for (int axis = 0; axis < 4; ++axis) {
    Number of_axis[Register<Number, bytes>::count];
    for (int lane = 0; lane < Register<Number, bytes>::count; ++lane) {
      of_axis[lane] = bodies[body[lane]].numbers[axis];
    }
    numbers[axis] = load<Numbers>(of_axis);
  }
}

template <int bytes, typename Number, typename Numbers>
[[gnu::always_inline]] inline void write_bodies(const Numbers* velocity, LaneBody<Number>* bodies,
                                                const std::int32_t* body) {
  for (int axis = 0; axis < 3; ++axis) {
    Number of_axis[Register<Number, bytes>::count];
    store(velocity[axis], of_axis);
    for (int lane = 0; lane < Register<Number, bytes>::count; ++lane) {
      bodies[body[lane]].numbers[axis] = of_axis[lane];
    }
  }
}

/// Those that can move: nobody writes one that cannot.
template <int bytes, typename Number, typename Numbers>
[[gnu::always_inline]] inline void write_moving_bodies(const Numbers* velocity, LaneBody<Number>* bodies,
                                                       const std::int32_t* body, unsigned moves) {
  constexpr int count = Register<Number, bytes>::count;
  constexpr unsigned all = (1u << count) - 1;
  if ((moves & all) == all) {
    write_bodies<bytes>(velocity, bodies, body);
    return;
  }
  for (int axis = 0; axis < 3; ++axis) {
    Number of_axis[count];
    store(velocity[axis], of_axis);
    for (int lane = 0; lane < count; ++lane) {
      if ((moves >> lane & 1u) != 0) bodies[body[lane]].numbers[axis] = of_axis[lane];
    }
  }
}

/// The same of double precision, four bodies at a time.
template <int bytes, typename Numbers>
requires(bytes == 32)
    [[gnu::always_inline]] inline void write_moving_bodies(const Numbers* velocity, LaneBody<double>* bodies,
                                                           const std::int32_t* body, unsigned moves) {
  const Numbers zero = {};
  const Numbers xy02 = __builtin_shufflevector(velocity[0], velocity[1], 0, 4, 2, 6);
  const Numbers xy13 = __builtin_shufflevector(velocity[0], velocity[1], 1, 5, 3, 7);
  const Numbers z02 = __builtin_shufflevector(velocity[2], zero, 0, 4, 2, 6);
  const Numbers z13 = __builtin_shufflevector(velocity[2], zero, 1, 5, 3, 7);
  const Numbers of_body[] = {
      __builtin_shufflevector(xy02, z02, 0, 1, 4, 5), __builtin_shufflevector(xy13, z13, 0, 1, 4, 5),
      __builtin_shufflevector(xy02, z02, 2, 3, 6, 7), __builtin_shufflevector(xy13, z13, 2, 3, 6, 7)};
  for (int lane = 0; lane < 4; ++lane) {
    if ((moves >> lane & 1u) != 0) store(of_body[lane], bodies[body[lane]].numbers);
  }
}

/// As many bytes of a register as are used for numbers of the problem: there are shuffles for four bodies in
/// double precision, and for no more.
template <typename Real, int bytes>
constexpr int body_bytes = sizeof(Real) == 8 && bytes > 32 ? 32 : bytes;

/// The first so many numbers of the bodies of a batch.
template <int bytes, int count, typename Real>
[[gnu::always_inline]] inline void gather_numbers(const std::int32_t* body, const LaneBody<Real>* bodies,
                                                  Real (&to)[count][lane_count]) {
  constexpr int width = body_bytes<Real, bytes>;
  typedef typename Register<Real, width>::Numbers Numbers;
  for (int lane = 0; lane < lane_count; lane += Register<Real, width>::count) {
    Numbers of_bodies[4];
    read_bodies<width>(bodies, body + lane, of_bodies);
    for (int i = 0; i < 3; ++i) store(of_bodies[i], to[i] + lane);
    if constexpr (count > 3) store(of_bodies[3], to[3] + lane);
  }
}

/// The velocities of the bodies of a batch.
template <int bytes, typename Real>
inline void gather_bodies(const LaneBatch& batch, const LaneBody<Real>* bodies, LaneBodyInput<Real>& to) {
  gather_numbers<bytes>(batch.body_a, bodies, to.velocity_a);
  gather_numbers<bytes>(batch.body_b, bodies, to.velocity_b);
}

/// The reverse, for those that can move.
template <int bytes, typename Real>
inline void scatter_bodies(const LaneBatch& batch, const LaneBodyInput<Real>& from, LaneBody<Real>* bodies) {
  constexpr int width = body_bytes<Real, bytes>;
  typedef typename Register<Real, width>::Numbers Numbers;
  for (int lane = 0; lane < batch.used; lane += Register<Real, width>::count) {
    Numbers a[3], b[3];
    for (int axis = 0; axis < 3; ++axis) {
      a[axis] = load<Numbers>(from.velocity_a[axis] + lane);
      b[axis] = load<Numbers>(from.velocity_b[axis] + lane);
    }
    write_moving_bodies<width>(a, bodies, batch.body_a + lane, batch.moves_a >> lane);
    write_moving_bodies<width>(b, bodies, batch.body_b + lane, batch.moves_b >> lane);
  }
}

}  // namespace

}  // namespace cairn
