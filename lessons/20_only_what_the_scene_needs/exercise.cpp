// Exercise 20. What does a step cost? Then: bash lessons/run check 20
#include <algorithm>

#include "exercise.hpp"

namespace cairn::exercise20 {

int row_updates(const std::vector<Island>& islands) {
  (void)islands;
  return -1;  // <- your code
}

}  // namespace cairn::exercise20
