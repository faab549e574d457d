// Exercise 04. Write the entries of A of a stack. Then: bash lessons/run check 4
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise04 {

double entry(int i, int j, const List<double>& masses) {
  (void)i, (void)j, (void)masses;
  return std::nan("");  // <- your code
}

}  // namespace cairn::exercise04
