// Exercise 07. Write the update in between, (29). Then: bash lessons/run check 7
#include <algorithm>
#include <cmath>

#include "lessons/kit/exercise.hpp"

namespace cairn::exercise07 {

/// Rows and bodies before the first push. A velocity is a list of numbers; so is every row.
struct Problem {
  List<List<double>> J = {};         // [1] row by row
  List<double> inverse_mass = {};    // [1/kg] of each number of a velocity
  List<double> start_velocity = {};  // [m/s] v̄
  List<double> zeta = {};            // [m/s] of each row
  double dt = 0;                     // [s]
};

// The new η_i [N] of row i, before any clamp. There is no A, and nobody has kept the velocities up to date:
// get them from all η [N] by (26), then use (27).
double updated(int i, const Problem& problem, const List<double>& eta) {
  const int rows = eta.size(), numbers = problem.start_velocity.size();
  double new_eta = std::nan("");
  // Your code begins here: about ten lines.

  // Your code ends here.
  return new_eta;
}

}  // namespace cairn::exercise07
