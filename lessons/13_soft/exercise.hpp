// Exercise 13: γ and β of a spring.
#pragma once

#include "lessons/exercise.hpp"

namespace cairn::exercise13 {

/// What makes a row soft.
struct Soft {
  double gamma = 0;  // [1/kg] added to j M^-1 j^T
  double beta = 0;   // the share of an error that is taken back in a step
};

/// The gamma and beta of a spring that lets `mass` [kg] swing with `frequency` [Hz] and the damping ratio, in
/// steps of dt [s] of implicit Euler: k = m omega^2, d = 2 m (damping ratio) omega.
Soft soften(double mass, double frequency, double damping_ratio, double dt);

using Answer = Soft (*)(double, double, double, double);
void grade(Grade& grade, Answer answer);
/// With the answer of exercise.cpp.
Exercise exercise();

}  // namespace cairn::exercise13
