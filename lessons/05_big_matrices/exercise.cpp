// Exercise 05. Write the entries of A of a stack. Then: bash lessons/run check 5
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"
#include <cairn/math/list.hpp>

namespace cairn::exercise05 {

// A_ij [1/kg] of a stack with one contact under each box: contact 0 is between the ground and box 0, contact
// i between the boxes i - 1 and i. `masses` [kg] are those of the boxes, from the ground up. A = J M^-1 J^T
// (15).
double entry(int i, int j, const List<double>& masses) {
  double a = std::nan("");
  // Your code begins here: about five lines.

  // Your code ends here.
  return a;
}

}  // namespace cairn::exercise05
