// Exercise 13, graded: the spring of the lesson, and a mass on a soft row beside one on a spring in plain
// loops.
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise13 {
namespace {

constexpr double dt = 0.02, mass = 1, frequency = 2, ratio = 0.5;  // [s], [kg], [Hz]
constexpr double soft_rounding = 1e-13;                            // a dozen operations on numbers up to 200

struct Spring {
  double stiffness = 0;  // [N/m]
  double damping = 0;    // [N s/m]
};

Spring spring_of(double omega) { return {mass * omega * omega, 2 * mass * ratio * omega}; }

Soft softness_of(const Spring& s) {
  return {1 / (dt * (s.damping + dt * s.stiffness)), dt * s.stiffness / (s.damping + dt * s.stiffness)};
}

/// Where the mass is after 50 steps with gravity, by a soft row.
double by_row(const Soft& soft) {
  double y = 0.1, v = 0;
  for (int step = 0; step < 50; ++step) {
    v -= 10 * dt;
    // j v + gamma impulse = -beta c / dt, with c = y.
    const double impulse = (-soft.beta * y / dt - v) / (1 / mass + soft.gamma);
    v += impulse / mass;
    y += dt * v;
  }
  return y;
}

/// The same by implicit Euler: v' = v + dt (-g - k y'/m - d v'/m), y' = y + dt v'.
double by_spring(const Spring& s) {
  double y = 0.1, v = 0;
  for (int step = 0; step < 50; ++step) {
    v = (v - 10 * dt - dt * s.stiffness * y / mass) /
        (1 + dt * s.damping / mass + dt * dt * s.stiffness / mass);
    y += dt * v;
  }
  return y;
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const double omega = 2 * std::acos(-1.0) * frequency;
  const Spring spring = spring_of(omega), in_hertz = spring_of(frequency);
  const Soft right = softness_of(spring), hertz = softness_of(in_hertz),
             got = answer(mass, frequency, ratio, dt);
  const Soft half_damped = softness_of({spring.stiffness, spring.damping / 2});
  grade.number({.what = "2 Hz, half damped, 1 kg, dt 0.02 s: gamma (1/kg)",
                .value = right.gamma,
                .tolerance = soft_rounding,
                .misconceptions = {{hertz.gamma, "omega is 2 pi times the frequency."},
                                   {half_damped.gamma, "The damping is 2 m (ratio) omega: where is the 2?"},
                                   {right.gamma * dt, "An impulse is a force times dt: 1 / (dt (d + dt k))."},
                                   {1 / right.gamma, "gamma is large for soft springs: the inverse."}}},
               got.gamma);
  grade.number(
      {.what = "2 Hz, half damped, 1 kg, dt 0.02 s: beta",
       .value = right.beta,
       .tolerance = soft_rounding,
       .misconceptions = {{hertz.beta, "omega is 2 pi times the frequency."},
                          {half_damped.beta, "The damping is 2 m (ratio) omega: where is the 2?"},
                          {1 - right.beta, "That is what is left of the error, not what is taken back."},
                          {right.beta / dt, "beta is a share, without a unit."}}},
      got.beta);
  grade.number({.what = "50 steps on the soft row: height (m)",
                .value = by_spring(spring),
                .tolerance = soft_rounding},
               by_row(got));
}

Exercise exercise() {
  return {.lesson = 13,
          .task = "gamma and beta of a spring: what makes a row soft.",
          .file = "lessons/13_soft/exercise.cpp",
          .hints = {"Implicit Euler: the force is -k (c + dt v') - d v' with the new v'. Write that as j v' "
                    "+ gamma impulse = -beta c / dt.",
                    "Divide impulse = -dt k c - dt (d + dt k) v' by dt (d + dt k).",
                    "gamma = 1 / (dt (d + dt k)), beta = dt k / (d + dt k)."},
          .grade = [](Grade& marks) { grade(marks, soften); }};
}

}  // namespace cairn::exercise13
