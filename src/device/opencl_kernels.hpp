// Floor 7. What a device does in a sweep of Jacobi, in OpenCL C 1.2. REAL is float or double.
#pragma once

namespace cairn {

/// Row and Term are those of opencl_jacobi.cpp, field for field. A product and a sum are never fused: Jacobi
/// rounds both. DOT adds in the order of dot() (math/math.hpp).
inline constexpr const char* jacobi_kernels = R"(
#pragma OPENCL FP_CONTRACT OFF

typedef struct {
  REAL jacobian_a[3], jacobian_b[3];
  REAL bias, softness, step, lower, upper, friction, disc;
  int a, b, normal_row, second_normal_row, first_extra, extra_count;
} Row;

typedef struct {
  REAL jacobian[3];
  int body;
} Term;

REAL dot_of(const __global REAL* j, const __global REAL* v) {
  const REAL x = j[0] * v[0], y = j[1] * v[1], z = j[2] * v[2];
  return DOT;
}

REAL larger(const REAL x, const REAL y) { return x < y ? y : x; }
REAL smaller(const REAL x, const REAL y) { return y < x ? y : x; }

REAL clamped(const REAL x, const __global Row* row, const __global REAL* impulse) {
  if (row->normal_row < 0) return larger(smaller(x, row->upper), row->lower);
  const REAL other = impulse[row->normal_row];
  REAL limit;
  if (row->disc > 0) {
    const REAL used = smaller(fabs(other), row->disc);
    limit = sqrt((row->disc - used) * (row->disc + used));
  } else {
    REAL load = larger(other, 0);
    if (row->second_normal_row >= 0) load += larger(impulse[row->second_normal_row], 0);
    limit = row->friction * load;
  }
  return larger(smaller(x, limit), -limit);
}

__kernel void update_rows(__global const Row* rows, __global const Term* terms, __global const REAL* velocity,
                          __global const REAL* impulse, __global REAL* next, __global REAL* change) {
  const int i = get_global_id(0);
  __global const Row* row = rows + i;
  REAL jv = dot_of(row->jacobian_a, velocity + 3 * row->a) + dot_of(row->jacobian_b, velocity + 3 * row->b);
  for (int k = row->first_extra; k < row->first_extra + row->extra_count; ++k) {
    jv += dot_of(terms[k].jacobian, velocity + 3 * terms[k].body);
  }
  const REAL old = impulse[i];
  const REAL corrective = (row->bias - jv - row->softness * old) * row->step;
  const REAL updated = clamped(old + corrective, row, impulse);
  change[i] = updated - old;
  next[i] = updated;
}

// What acts on one body, in the order of the rows: M^-1 j^T of each, times the change of its impulse.
__kernel void move_bodies(__global const int* first, __global const int* row_of, __global const REAL* share,
                          __global const REAL* change, __global REAL* velocity) {
  const int body = get_global_id(0);
  REAL x = velocity[3 * body], y = velocity[3 * body + 1], z = velocity[3 * body + 2];
  for (int k = first[body]; k < first[body + 1]; ++k) {
    const REAL p = change[row_of[k]];
    x += share[3 * k] * p;
    y += share[3 * k + 1] * p;
    z += share[3 * k + 2] * p;
  }
  velocity[3 * body] = x;
  velocity[3 * body + 1] = y;
  velocity[3 * body + 2] = z;
}
)";

}  // namespace cairn
