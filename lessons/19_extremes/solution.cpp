// Exercise 19, answered.
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise19 {

int sweeps_needed(double above, double below, double share) {
  const double rate = above / (above + below);  // R / (1 + R)
  return static_cast<int>(std::ceil(std::log(share) / std::log(rate)));
}

}  // namespace cairn::exercise19
