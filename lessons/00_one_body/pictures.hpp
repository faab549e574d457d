// Lesson 00. The pictures of the flight.
#pragma once

#include <vector>

#include "lessons/lesson.hpp"
#include "flight.hpp"

namespace cairn::one_body {

/// What halving the time step does to the error, at one and the same instant.
struct Convergence {
  std::vector<double> dt = {};              // [s]
  std::vector<double> semi_implicit = {};   // [m] below the parabola
  std::vector<double> explicit_euler = {};  // [m] above it
};

/// All frames, from the question to the answer.
std::vector<Shot> pictures(const Flight& flight, const Convergence& convergence, const std::string& question);

}  // namespace cairn::one_body
