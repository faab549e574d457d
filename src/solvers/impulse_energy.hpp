// Floor 4. How good impulses are to begin a solve from: the energy that they lead to, and how large they may
// be.
#pragma once

#include "constraints/row.hpp"

namespace cairn {

/// With A and gamma of the rows, and the velocities v that the problem begins with,
///   D(impulse) = impulse^T (A + gamma) impulse / 2 + impulse^T (J v - bias)   [J]
/// which is what solving makes least within the bounds, and 0 without impulses. Above 0, the impulses are a
/// worse start than none. `scratch` is memory for the velocities that they lead to. O(m). MuJoCo compares its
/// warm start with none in the same way (E. Todorov, 2014).
template <Scalar Real>
Real impulse_energy(const VelocityProblem<Real>& problem, std::vector<Vec3<Real>>& scratch);

/// Limits the impulses that a solve begins from, by 100 times all there is to stop or to move:
///   sum of m |v| + sum of |bias| / A_ii + sum of the impulses of springs and motors   [N s]
/// Levers and wedges make impulses larger than that sum, though hardly by so much. Rows that contradict each
/// other do, step by step and without end: with (12) their impulses cancel, so that no velocity tells.
/// O(m); two passes over the impulses and nothing else where all of them are small.
template <Scalar Real>
void limit_impulses(VelocityProblem<Real>& problem);

}  // namespace cairn
