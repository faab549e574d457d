// Exercise 13. Make a row soft: γ and β of a spring. Then: bash lessons/run check 13
#include <cmath>

#include "lessons/exercise.hpp"

namespace cairn::exercise13 {

/// What makes a row soft.
struct Soft {
  double gamma = 0;  // [1/kg] beside j M⁻¹ jᵀ
  double beta = 0;   // the share of an error that a step takes back
};

constexpr double pi = 3.14159265358979323846;

// The γ and β of a spring that lets `mass` [kg] swing with `frequency` [Hz] and the damping ratio, in steps
// of dt [s] of implicit Euler: force = −k c − d v at the end of the step, where k = m ω², d = 2 m (damping
// ratio) ω and ω = 2 pi frequency.
Soft soften(double mass, double frequency, double damping_ratio, double dt) {
  Soft soft;
  // Your code begins here: about five lines.

  // Your code ends here.
  return soft;
}

}  // namespace cairn::exercise13
