// Worlds stepped for a while, and the problems written by hand of the validation cases: what the tests share.
#pragma once

#include "solvers/solver_list.hpp"

namespace cairn::testing {

inline constexpr double test_gravity = standard_gravity;  // [m/s^2]
inline constexpr double test_dt = standard_dt;            // [s]

/// Steps the world for about this long [s]: a whole number of steps.
template <Scalar Real>
void run(World<Real>& world, Solver<Real>& solver, double seconds) {
  take_steps(world, solver, static_cast<int>(std::lround(seconds / world.clock().dt)));
}

/// Checks that an error, given the steps per second, shrinks in proportion to dt: order 0.8 to 1.2 over three
/// halvings from 1/60 s.
inline void check_first_order(const std::function<double(double)>& error) {
  double coarse = std::abs(error(60));
  for (const double frequency : {120.0, 240.0, 480.0}) {
    const double fine = std::abs(error(frequency));
    CAPTURE(frequency);
    CHECK(std::log2(coarse / fine) >= 0.8);
    CHECK(std::log2(coarse / fine) <= 1.2);
    coarse = fine;
  }
}

}  // namespace cairn::testing
