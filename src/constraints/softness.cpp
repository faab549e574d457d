// Floor 3. From a spring to gamma and bias.
#include "constraints/softness.hpp"

#include <algorithm>

#include "math/check.hpp"

namespace cairn {

namespace {

template <Scalar Real>
Real angular_frequency(const SwingSoftness& swing) {
  return 2 * std::numbers::pi_v<Real> * static_cast<Real>(swing.frequency);
}

/// (c + h k) / (m w): what damper and spring resist together.
template <Scalar Real>
Real resistance(const SwingSoftness& swing, Real dt) {
  return 2 * static_cast<Real>(swing.damping_ratio) + dt * angular_frequency<Real>(swing);
}

/// c + h k.
template <Scalar Real>
Real resistance(const SpringSoftness& spring, Real dt) {
  return static_cast<Real>(spring.damping) + dt * static_cast<Real>(spring.stiffness);
}

}  // namespace

template <Scalar Real>
Real return_rate(const Softness& softness, Real dt) {
  if (const auto* swing = std::get_if<SwingSoftness>(&softness))
    return angular_frequency<Real>(*swing) / resistance(*swing, dt);
  const SpringSoftness& spring = std::get<SpringSoftness>(softness);
  const Real resisting = resistance(spring, dt);  // 0 where Real cannot tell the spring from none
  return resisting > 0 ? static_cast<Real>(spring.stiffness) / resisting : Real(0);
}

template <Scalar Real>
Real softness_divisor(const SwingSoftness& swing, Real dt) {
  return dt * angular_frequency<Real>(swing) * resistance(swing, dt);
}

template <Scalar Real>
Real row_softness(const Softness& softness, Real inverse_mass, Real dt) {
  Real gamma = 0;
  if (const auto* swing = std::get_if<SwingSoftness>(&softness)) {
    gamma = inverse_mass / softness_divisor(*swing, dt);
  } else {
    gamma = 1 / (dt * resistance(std::get<SpringSoftness>(softness), dt));
  }
  return std::min(gamma, most_softness<Real>());
}

void require_softness(const Softness& softness, const std::string& place) {
  const auto require_range = [&place](double value, const char* field, const char* rule) {
    require(value >= 0 && value <= 1e30, place, field, rule, value);  // times dt^2 within a float
  };
  if (const auto* swing = std::get_if<SwingSoftness>(&softness)) {
    require(swing->frequency >= 1e-6 && swing->frequency <= 1e6, place, "softness frequency",
            "from 1e-6 to 1e6 Hz", swing->frequency);
    require_range(swing->damping_ratio, "softness damping_ratio", "from 0 to 1e30");
    return;
  }
  const SpringSoftness& spring = std::get<SpringSoftness>(softness);
  require_range(spring.stiffness, "softness stiffness", "from 0 to 1e30 N/m");
  require_range(spring.damping, "softness damping", "from 0 to 1e30 N s/m");
  require(spring.stiffness > 0 || spring.damping > 0, place, "softness stiffness",
          "> 0 N/m where damping is 0 N s/m", spring.stiffness);
}

template float return_rate(const Softness&, float);
template double return_rate(const Softness&, double);
template long double return_rate(const Softness&, long double);
template float softness_divisor(const SwingSoftness&, float);
template double softness_divisor(const SwingSoftness&, double);
template long double softness_divisor(const SwingSoftness&, long double);

template float row_softness(const Softness&, float, float);
template double row_softness(const Softness&, double, double);
template long double row_softness(const Softness&, long double, long double);

}  // namespace cairn
