// Exercise 14, answered.
#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise14 {

FixedList<double, 2> gear_row(double teeth_a, double teeth_b) {
  // At the mesh a wheel's teeth move at omega times its radius, which is as its teeth: one up, the other
  // down.
  return {teeth_a, teeth_b};
}

}  // namespace cairn::exercise14
