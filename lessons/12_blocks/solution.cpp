// Exercise 12, answered.
#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise12 {

FixedList<double, 2> solve_block(double k11, double k12, double k22, const FixedList<double, 2>& change) {
  const double determinant = k11 * k22 - k12 * k12;  // above 0, as long as one of the bodies can move
  return {(k22 * change[0] - k12 * change[1]) / determinant,
          (k11 * change[1] - k12 * change[0]) / determinant};
}

}  // namespace cairn::exercise12
