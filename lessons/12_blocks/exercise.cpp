// Exercise 12. Solve the two rows of a pin in one go. Then: bash lessons/run check 12
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise12 {

std::array<double, 2> solve_block(double k11, double k12, double k22, const std::array<double, 2>& change) {
  (void)k11, (void)k12, (void)k22, (void)change;
  return {std::nan(""), std::nan("")};  // <- your code
}

}  // namespace cairn::exercise12
