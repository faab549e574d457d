// Exercise 13: every misconception is told from the answer.
#include "lessons/13_soft/exercise.hpp"

#include <cmath>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise13 {
namespace {

Soft of_spring(double stiffness, double damping, double dt) {
  return {1 / (dt * (damping + dt * stiffness)), dt * stiffness / (damping + dt * stiffness)};
}

double turning(double frequency) { return 2 * std::acos(-1.0) * frequency; }

Soft in_hertz(double m, double f, double ratio, double dt) {
  return of_spring(m * f * f, 2 * m * ratio * f, dt);
}

Soft half_damping(double m, double f, double ratio, double dt) {
  return of_spring(m * turning(f) * turning(f), m * ratio * turning(f), dt);
}

Soft one_dt_missing(double m, double f, double ratio, double dt) {
  const Soft right = soften(m, f, ratio, dt);
  return {right.gamma * dt, right.beta / dt};
}

Soft turned_over(double m, double f, double ratio, double dt) {
  const Soft right = soften(m, f, ratio, dt);
  return {1 / right.gamma, 1 - right.beta};
}

}  // namespace

TEST_CASE("exercise 13 tells Hz for rad/s, half of the damping, a missing dt and inverses") {
  CHECK(testing::tells<grade>(in_hertz, "2 pi times"));
  CHECK(testing::tells<grade>(half_damping, "where is the 2"));
  CHECK(testing::tells<grade>(one_dt_missing, "force times dt"));
  CHECK(testing::tells<grade>(one_dt_missing, "without a unit"));
  CHECK(testing::tells<grade>(turned_over, "the inverse"));
  CHECK(testing::tells<grade>(turned_over, "what is left of the error"));
}

}  // namespace cairn::exercise13
