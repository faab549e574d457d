// The tower for PGS with elimination, and for a loop that knows it beforehand.
#include "lesson.hpp"

#include <Eigen/LU>

namespace cairn::cost {

void check_tower(Lesson& lesson, int n) {
  constexpr int sweeps = 10;
  const SystemMatrices<double> pgs = system_matrices(tower_problem(n));
  const Vector<double> eliminated = pgs.A.partialPivLu().solve(pgs.b);
  const List<double> exact = exact_lambda(n);
  double gap = 0;
  for (int i = 0; i < n; ++i) gap = std::max(gap, std::abs(eliminated(i) - exact[i]));
  // The condition of A is below 2 n², and elimination rounds some n times at the size of n g.
  lesson.check_small("A and b of PGS, eliminated: the exact loads (N)", gap,
                     epsilon * 2 * n * n * n * n * gravity);
  VelocityProblem<double> problem = tower_problem(n);
  SequentialImpulse<double>({.iterations = sweeps}).solve(problem);
  const List<double> special = tower_only(n, sweeps);
  double apart = 0;
  for (int i = 0; i < n; ++i) apart = std::max(apart, std::abs(special[i] - problem.impulse[i]));
  lesson.check_small("a loop for this tower only repeats SI: the same impulses (N s)", apart, 0);
}

}  // namespace cairn::cost
