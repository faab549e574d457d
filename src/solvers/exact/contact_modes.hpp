// Floor 4. All answers that a small problem has, by trying every mode of every row.
#pragma once

#include <cairn/solvers/exact/exact_rows.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

/// One velocity that solves the rows, and impulses that cause it.
struct ModeSolution {
  Vector<long double> x;   // as in ExactRows
  bool in_family = false;  // a mode that it is in has further velocities, next to it or farther off
};

/// What the enumeration found.
struct ModeList {
  bool complete = false;              // every mode was tried
  int modes = 0;                      // that were tried
  List<ModeSolution> solutions = {};  // in the order of the modes: first those with open contacts
};

/// A contact without friction is open or closed; with friction it is open, sticks, or slides one way or the
/// other: 4^c modes for c contacts. A row with two bounds is at one of them or between. Each mode makes a
/// linear system of equations, and its solution counts if it keeps the signs that the mode assumes. Where a
/// mode's equations are singular, as for a box on three points, its solutions are a family: then the one
/// nearest to that of the elimination is listed. Solutions with the same velocities are listed once.
/// If all modes are tried, no other velocity solves the problem but those of families. More than `max_modes`
/// are not begun with. Cost: for each mode, n^3.
ModeList enumerate_modes(const ExactRows& rows, int max_modes);

/// The same for a problem: what solves it, all velocities that do.
template <Scalar Real>
struct ContactSolution {
  PerBody<Vec3<Real>> velocity = {};  // of each body [m/s, m/s, rad/s]
  PerRow<Real> impulse = {};          // [N s]
  bool unique_impulse = false;        // no other impulses cause these velocities
  bool in_family = false;             // one of infinitely many velocities of a mode
  Real residual = 0;                  // R_E in long double, with the scale of exact_rows.hpp
};

/// What the enumeration found, as velocities and impulses.
template <Scalar Real>
struct ContactSolutions {
  bool complete = false;                       // every mode was tried
  int modes = 0;                               // that were tried
  List<ContactSolution<Real>> solutions = {};  // in the order of the modes
};

/// Warm starts are ignored.
/// @throws std::invalid_argument where reduce_to_exact_rows() does.
template <Scalar Real>
ContactSolutions<Real> all_contact_solutions(const VelocityProblem<Real>& problem, int max_modes = 4096);

/// Gives the problem, whose velocities are those before any impulse, these impulses and their velocities.
void set_impulses(VelocityProblem<long double>& problem, const PerRow<long double>& impulse);

}  // namespace cairn
