// Exercise 16. Find a damping that always settles. Then: bash lessons/run check 16
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise16 {

// A box stands on so many contacts, and all of them correct at the same time. Return the factor omega by
// which each correction is multiplied, so that the sum of all impulses settles wherever the contacts are, in
// as few sweeps as that allows. One contact alone needs no damping.
double damping(int contacts) {
  (void)contacts;
  return std::nan("");  // <- your code
}

}  // namespace cairn::exercise16
