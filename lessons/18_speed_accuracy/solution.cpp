// Exercise 18, answered.
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise18 {

double best_relaxation(int boxes) {
  const double jacobi = std::cos(std::acos(-1.0) / (2.0 * boxes));
  return 2 / (1 + std::sqrt(1 - jacobi * jacobi));  // D. M. Young, 1954
}

}  // namespace cairn::exercise18
