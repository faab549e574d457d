// Floor 3. From a spring to gamma and bias.
#include "constraints/softness.hpp"

#include <type_traits>

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

/// k [N/m] and c [N s/m].
template <typename Wide>
struct SpringConstants {
  Wide stiffness = 0;
  Wide damping = 0;
};

template <typename Wide>
SpringConstants<Wide> constants_of(const Softness& softness, Wide of_masses) {
  if (const auto* swing = std::get_if<SwingSoftness>(&softness)) {
    const Wide w = angular_frequency<Wide>(*swing);
    return {w * w / of_masses, 2 * static_cast<Wide>(swing->damping_ratio) * w / of_masses};
  }
  const SpringSoftness& spring = std::get<SpringSoftness>(softness);
  return {static_cast<Wide>(spring.stiffness), static_cast<Wide>(spring.damping)};
}

}  // namespace

double stiffness_of(const Softness& softness, double of_masses) {
  return constants_of(softness, of_masses).stiffness;
}

/// In double at least: the square of w h is beyond a float where w h is 1e20.
template <Scalar Real>
SpringRow<Real> spring_row(const Softness& softness, const SpringState<Real>& begin, Real dt) {
  using Wide = std::conditional_t<std::is_same_v<Real, float>, double, Real>;
  const Wide h = dt, error = begin.error, speed = begin.speed, inverse_mass = begin.inverse_mass;
  const auto [k, c] = constants_of<Wide>(softness, begin.of_masses);
  const bool has_room = begin.only_pushes && error > 0;
  const Wide square = h * h * k * inverse_mass, q = h * c * inverse_mass;
  const Wide conserving = 1 / (1 + square * square), b = conserving / 4, a = 1 - 3 * b;
  const Wide p = has_room ? Wide(1) : (1 + q) / (2 + q);
  const Wide resisting = h * k * a + c * p;
  if (!(resisting > 0)) return {.bias = 0, .softness = most_softness<Real>()};
  const Wide damped = has_room ? error / h : (1 - p) * speed;  // beside j v'
  const Wide softness_of_row = 1 / (h * resisting);
  return {.bias = static_cast<Real>(-(k * (error - b * h * speed) + c * damped) / resisting),
          .softness = softness_of_row < static_cast<Wide>(most_softness<Real>())
                          ? static_cast<Real>(softness_of_row)
                          : most_softness<Real>()};
}

template <Scalar Real>
Real return_rate(const SwingSoftness& swing, Real dt) {
  return angular_frequency<Real>(swing) / resistance(swing, dt);
}

template <Scalar Real>
Real softness_divisor(const SwingSoftness& swing, Real dt) {
  return dt * angular_frequency<Real>(swing) * resistance(swing, dt);
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

template float return_rate(const SwingSoftness&, float);
template double return_rate(const SwingSoftness&, double);
template long double return_rate(const SwingSoftness&, long double);
template float softness_divisor(const SwingSoftness&, float);
template double softness_divisor(const SwingSoftness&, double);
template long double softness_divisor(const SwingSoftness&, long double);
template SpringRow<float> spring_row(const Softness&, const SpringState<float>&, float);
template SpringRow<double> spring_row(const Softness&, const SpringState<double>&, double);
template SpringRow<long double> spring_row(const Softness&, const SpringState<long double>&, long double);

}  // namespace cairn
