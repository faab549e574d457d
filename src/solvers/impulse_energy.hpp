// Floor 4. How good impulses are to begin a solve from: the energy that they lead to, and how large they may
// be.
#pragma once

#include "constraints/row.hpp"

namespace cairn {

// With A and gamma of the rows, and the velocities v that a step begins with, impulses p have the energy
//   D(p) = p^T (A + gamma) p / 2 + p^T (J v - bias)   [J]
// which is what solving makes least within the bounds. Of all shares of p, which are within the bounds as p
// is, this one has the least D:
//   share = 1 - p^T (J (v + M^-1 J^T p) + gamma p - bias) / p^T (A + gamma) p,   between 0 and 1
// There, what the rows lack of what they ask for does no work in sum: with bias 0 kinetic energy does not
// grow, and what rebounds keeps what restitution leaves it. MuJoCo compares its warm start with none by D
// (E. Todorov, 2014); this is the exact line search between the two.

// Each island has a share of its own: the bodies that rows join through bodies that can be moved. What fails
// in one changes no bit of another.

/// D along the impulses of an island, at all of them.
template <Scalar Real>
struct EnergySlope {
  Real slope = 0;      // [J] D'(1)
  Real curvature = 0;  // [J] D''
  Real share = 1;      // that has the least D
};

/// Rows that follow each other and act on the same two bodies, as those of a pin or a contact do; or one row
/// by itself.
struct RowRun {
  int first = 0;               // its first row
  int last = 0;                // its last row
  bool has_two_bodies = true;  // and no other
  BodyId island = {};          // of its bodies that can be moved; one that cannot where none can
};

/// Memory for the two functions below.
template <Scalar Real>
struct EnergyMemory {
  PerBody<Vec3<Real>> solved = {};         // M^-1 J^T p
  PerBody<BodyId> island = {};             // of each body: the first one of its island
  List<RowRun> runs = {};                  // all rows
  PerBody<EnergySlope<Real>> energy = {};  // of each island, at its first body
};

/// Leaves of the impulses that a solve is to begin from, which `problem.velocity` does not hold yet, the
/// shares above, and returns the least. Pushing out of overlap does not count: what was pushed out in the
/// last step needs no push in this one. O(m).
template <Scalar Real>
Real limit_warm_start(VelocityProblem<Real>& problem, EnergyMemory<Real>& memory);

/// The same after a solve, for its impulses and the velocities that they led to, by all that the rows ask
/// for. With the memory of the warm start, if there was one: rows hold the same bodies still.
template <Scalar Real>
Real limit_solved(VelocityProblem<Real>& problem, EnergyMemory<Real>& memory);

/// All that there is to stop or to move:
///   sum of m |v| + sum of |bias| / A_ii + sum of the impulses of springs and motors   [N s]
template <Scalar Real>
Real impulse_there_is(const VelocityProblem<Real>& problem);

/// How many times impulse_there_is() the impulse of another row may be. What is more is leverage: a lever of
/// arms 100 to 1, a wedge of 1 in 100, the weld that holds a beam of 200 m at one end (its moment is
/// m g dt L / 2). Steps of the scenes that come with Cairn reach 2.5, the weld-beam's first.
inline constexpr double most_leverage = 100;

/// Limits the impulses that a solve begins from by most_leverage. Rows that contradict each other exceed it,
/// step by step and without end: with (12) their impulses cancel, so that no velocity tells. O(m); two passes
/// over the impulses and nothing else where all of them are small.
template <Scalar Real>
void limit_impulses(VelocityProblem<Real>& problem);

}  // namespace cairn
