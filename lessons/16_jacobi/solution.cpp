// Exercise 16, answered.
#include "exercise.hpp"

namespace cairn::exercise16 {

double damping(int contacts) {
  return 1.0 / contacts;  // the sum of all corrections is then their mean
}

}  // namespace cairn::exercise16
