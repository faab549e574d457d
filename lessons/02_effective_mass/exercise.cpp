// Exercise 02. Write equation (22), times dt. Then: bash lessons/run check 2
#include "exercise.hpp"

namespace cairn::exercise02 {

double impulse_of(const Meeting& meeting) {
  (void)meeting;
  return 0;  // <- your code
}

}  // namespace cairn::exercise02
