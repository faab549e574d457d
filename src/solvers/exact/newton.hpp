// Floor 4. Newton's method for all rows at once.
#pragma once

#include <cairn/constraints/row.hpp>

namespace cairn {

/// When to stop, and what to do where steps do not help.
struct NewtonSettings {
  int iterations = 6000;     // linear systems, at most
  int restarts = 3;          // once no softness helps: by more sweeps of accelerated PGS
  int sweeps = 200;          // before the first system; four times as many at each restart
  double tolerance = 1e-15;  // on R_E
};

/// What the iteration came to.
struct NewtonResult {
  int iterations = 0;        // linear systems that were solved
  int restarts = 0;          // after steps that did not help
  long double residual = 0;  // R_E, with the scale of exact_rows.hpp
  bool converged = false;    // R_E is at most the tolerance: never assumed, always computed
};

/// Rows that depend on each other make A singular, so they are not solved as they stand, but a little softer
/// around the impulses of the moment (proximal_map.hpp); then around the impulses so found, and so on: the
/// proximal point method (R. T. Rockafellar, Augmented Lagrangians and applications of the proximal point
/// algorithm in convex programming, 1976). What softness changes goes to 0 with the change of impulses. It
/// starts at a hundredth of A_ii, becomes ten times less with every success, and more after a failure, whose
/// impulses are thrown away.
///
/// Each of these problems is a piecewise linear equation in the velocities, friction and its limits included
/// (P. Alart, A. Curnier, A mixed formulation for frictional contact problems prone to Newton like solution
/// methods, 1991), for Newton's method on a semismooth function (L. Qi, J. Sun, A nonsmooth version of
/// Newton's method, 1993), with steps halved until the equation's error falls. Its 3 n by 3 n matrix is never
/// singular without friction: symmetric, with all eigenvalues at 1 or above. It is factorized in double; all
/// else is computed in long double, so that further steps repair what factors lost.
///
/// For fixed bounds that rows can keep, this finds the answer, whatever the masses and however many rows
/// depend on each other. For friction nothing is guaranteed; in the tests it finds an answer for piles of up
/// to 1600 rows. Then converged tells.
/// Also for two rows that share a disc. `problem` as a Solver gets it, with the impulses to start from; the
/// best found are left in it. Cost: a sparse factorization for each iteration, 3 ms for 1600 rows; a
/// few hundred of them for a pile that moves, three thousand at worst, ten for one that rests. Memory linear
/// in the entries of factors.
NewtonResult newton(VelocityProblem<long double>& problem, const NewtonSettings& settings = {});

}  // namespace cairn
