// Floor 4. Whether impulses are the only ones with their effect.
#pragma once

#include <cairn/solvers/exact/exact_rows.hpp>

namespace cairn {

/// y with H y >= h, if there are any: then `y` is the shortest.
struct FeasiblePoint {
  bool exists = false;    // there is such a y
  Vector<long double> y;  // empty where there is none
};

/// min |y|^2 / 2 has its answer at y = H^T z with H H^T z - h >= 0, z >= 0, complementary: Lemke's method
/// finds it, and ends in a ray if and only if there is none, H H^T being positive semidefinite.
FeasiblePoint feasible_point(const Matrix<long double>& H, const Vector<long double>& h);

/// Whether no other solution of the rows has the velocities that x has. With the velocities w is the same for
/// all of them; so rows with w_i not 0 stay at their bounds, and the others may change as long as S dx = 0
/// and no bound is passed. Small numbers are judged beside rows.size.
bool has_unique_impulse(const ExactRows& rows, const Vector<long double>& x);

}  // namespace cairn
