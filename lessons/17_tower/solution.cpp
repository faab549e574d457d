// Exercise 17, answered.
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise17 {

int sweeps_needed(int boxes, double share) {
  const double pi = std::acos(-1.0);
  const double rate = std::pow(std::cos(pi / (2.0 * boxes)), 2);
  return static_cast<int>(std::ceil(std::log(share) / std::log(rate)));  // rate^k <= share
}

}  // namespace cairn::exercise17
