// Floor 4. Whether a problem has another answer: what searches for one.
#pragma once

#include <cairn/constraints/row.hpp>
#include <cairn/solvers/system_matrix.hpp>

namespace cairn {

// Contacts in one line with slightly different heights make condition numbers of 1e9: other velocities count
// as another answer only if both are exact and far apart.
inline constexpr long double exact_residual = 1e-15L;    // R_E
inline constexpr long double distinct_velocity = 1e-6L;  // beside the largest speed of a row, in sqrt(J)

/// Numbers from 1/2 to 3/2 that look random: the fractional parts of multiples of the golden ratio.
Vector<long double> other_cover(Eigen::Index size, int number);

/// How many velocities Newton's method finds from impulses that press all rows, `starts` times in other
/// shares, counting the one that is known. `problem` has the velocities before any impulse.
int count_newton_answers(const VelocityProblem<long double>& problem, const PerBody<Vec3<long double>>& known,
                         int starts);

}  // namespace cairn
