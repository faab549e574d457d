// Floor 4. What impulses do to the energy that a solve makes small.
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

}  // namespace cairn
