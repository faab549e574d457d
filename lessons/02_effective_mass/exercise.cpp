// Exercise 02. Write equation (22), times dt. Then: bash lessons/run check 2
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise02 {

double impulse_of(const Meeting& meeting) {
  (void)meeting;
  return std::nan("");  // <- your code
}

}  // namespace cairn::exercise02
