// Floor 3. From a spring to gamma and bias.
#include <cairn/constraints/softness.hpp>

#include <cairn/math/check.hpp>

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
struct SpringConstants {
  double stiffness = 0;
  double damping = 0;
};

SpringConstants constants_of(const Softness& softness, double of_masses) {
  if (const auto* swing = std::get_if<SwingSoftness>(&softness)) {
    const double w = angular_frequency<double>(*swing);
    return {w * w / of_masses, 2 * swing->damping_ratio * w / of_masses};
  }
  const SpringSoftness& spring = std::get<SpringSoftness>(softness);
  return {spring.stiffness, spring.damping};
}

}  // namespace

double stiffness_of(const Softness& softness, double of_masses) {
  return constants_of(softness, of_masses).stiffness;
}

/// In double: the square of w h is beyond a float where w h is 1e20.
template <Scalar Real>
SpringRow<Real> spring_row(const Softness& softness, const SpringState<Real>& begin, Real dt) {
  const double h = dt, error = begin.error, speed = begin.speed, inverse_mass = begin.inverse_mass;
  const auto [k, c] = constants_of(softness, begin.of_masses);
  const bool has_room = begin.only_pushes && error > 0;
  const double square = h * h * k * inverse_mass, q = h * c * inverse_mass;
  const double conserving = 1 / (1 + square * square), b = conserving / 4, a = 1 - 3 * b;
  const double p = has_room ? 1 : (1 + q) / (2 + q);
  const double resisting = h * k * a + c * p;
  if (!(resisting > 0)) return {.bias = 0, .softness = most_softness<Real>()};
  const double damped = has_room ? error / h : (1 - p) * speed;  // beside j v'
  const double softness_of_row = 1 / (h * resisting);
  return {.bias = static_cast<Real>(-(k * (error - b * h * speed) + c * damped) / resisting),
          .softness = softness_of_row < most_softness<Real>() ? static_cast<Real>(softness_of_row)
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
template float softness_divisor(const SwingSoftness&, float);
template double softness_divisor(const SwingSoftness&, double);
template SpringRow<float> spring_row(const Softness&, const SpringState<float>&, float);
template SpringRow<double> spring_row(const Softness&, const SpringState<double>&, double);

}  // namespace cairn
