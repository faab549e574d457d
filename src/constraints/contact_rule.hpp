// Floor 3. How errors of contacts go, in plain numbers.
#pragma once

namespace cairn {

/// What ContactStabilization computes with, without restitution, for those who do it for many contacts at
/// once. Functions that read it are compiled for several instruction sets: it has none of its own.
template <typename Real>
struct ContactRule {
  Real dt = 0;               // [s]
  Real slop = 0;             // [m] that is left alone; 0 on springs
  Real rigid_rate = 0;       // [1/s] beta / dt of (7)
  bool has_springs = false;  // overlaps are on springs
  Real spring_rate = 0;      // [1/s] of these, what beta / dt is to rigid rows
  Real spring_divisor = 1;   // of A_ii, gives the softness of a spring
  Real most_softness = 0;    // [1/kg]
  Real most_speed = 0;       // [m/s] with which overlap is taken back
  Real gravity = 0;  // [m/s^2] no faster than half of a fall through the overlap under this; 0: no such rule
};

}  // namespace cairn
