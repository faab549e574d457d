// Exercise 18. Over-relax a sweep. Then: bash lessons/run check 18
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise18 {

// One sweep of SOR over A λ = b for a tower, from the ground up. Row i is the contact of box i with what is
// below it: A_ii = 1/m_i + 1/m_{i−1}, A_{i,i−1} = −1/m_{i−1}, A_{i,i+1} = −1/m_i; the ground has 1/m = 0. b
// is gravity in row 0, and 0 in all others. Multiply each correction by ω, and let no load become negative.
void sweep(List<double>& load, const List<double>& mass, double gravity, double omega) {
  const int boxes = load.size();
  // Your code begins here: about eight lines.

  // Your code ends here.
}

}  // namespace cairn::exercise18
