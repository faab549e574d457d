// Exercise 13. Find gamma and beta. Then: bash lessons/run check 13
#include <algorithm>
#include <cmath>

#include "exercise.hpp"

namespace cairn::exercise13 {

// k = m omega^2 and d = 2 m (damping ratio) omega, with omega = 2 pi frequency: returns {gamma, beta} for
// steps of dt.
Soft soften(double mass, double frequency, double damping_ratio, double dt) {
  (void)mass, (void)frequency, (void)damping_ratio, (void)dt;
  return {std::nan(""), std::nan("")};  // <- your code
}

}  // namespace cairn::exercise13
