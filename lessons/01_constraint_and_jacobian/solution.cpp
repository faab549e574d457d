// Exercise 01, answered.
#include <cmath>

#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise01 {

FixedList<double, 3> jacobian(const Rail& rail) {
  // c = n p with n across the rail; p moves with the centre, and by omega x r as the body turns.
  const double n_x = -std::sin(rail.slope), n_y = std::cos(rail.slope);
  return {n_x, n_y, rail.arm_x * n_y - rail.arm_y * n_x};
}

}  // namespace cairn::exercise01
