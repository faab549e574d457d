// Floor 8. Small modes of hanging chains: B17 and B26.
#include <cmath>
#include <limits>
#include <string>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double chain_link = 0.5;    // [m]
const double chain_angle = 1e-3;  // [rad] about how far links are tilted at the start

/// The Laguerre polynomials L_0(x) to L_n(x). A hanging chain of n equal beads on equal links l swings with
/// w^2 = x g / l where L_n(x) = 0, and bead k, counted from its lower end, goes out by L_k(x).
List<double> laguerre(int n, double x) {
  List<double> value = {1, 1 - x};
  for (int k = 1; k < n; ++k) {
    const double next = ((2 * k + 1 - x) * value.back() - k * value[value.size() - 2]) / (k + 1);
    value.push_back(next);
  }
  return value;
}

/// The slowest mode is the smallest zero of L_n: near j^2 / (4 n + 2), with j = 2.4048 the first zero of J_0.
double slowest_zero(int n) {
  const auto is_past = [n](double x) { return laguerre(n, x)[n] < 0; };
  return bisected({0, 1.2 * 2.4048 * 2.4048 / (4 * n + 2)}, 1e-15, is_past).middle();
}

/// n beads of 1 kg on massless rods under the origin, at rest in the shape of the mode of this zero.
Scene chain_in_mode(int n, double zero, double frequency) {
  Scene scene({.dt = 1 / frequency, .stabilization = {.policy = StabilizationPolicy::baumgarte}});
  const List<double> shape = laguerre(n, zero);
  const double amplitude = chain_angle * chain_link / zero;  // L_0 - L_1 = x: the lowest link
  BodyId above = ground;
  Vec2<double> anchor = {0, 0};
  for (int i = n - 1; i >= 0; --i) {
    const double x = amplitude * shape[i];
    const double step = x - anchor.x();
    const Vec2<double> place(x, anchor.y() - std::sqrt(chain_link * chain_link - step * step));
    const BodyId bead = scene.add({.position = place, .mass = 1, .fixed_rotation = true});
    scene.join<DistanceJoint>({.a = above, .b = bead, .anchor_a = anchor, .anchor_b = place});
    above = bead;
    anchor = place;
  }
  return scene;
}

/// From the first to the last of so many passages of the lowest bead through the vertical, which are half a
/// period apart: the frequency w [rad/s]. NaN where it does not swing.
double measured_frequency(const EngineMaker& make, const Scene& scene, int iterations, int passages) {
  Motion chain(make, scene, iterations);
  const BodyId lowest = {scene.bodies().size() - 1};
  List<double> times;
  while (times.size() < passages && chain.time() < 60) {
    const double before = chain.position(lowest).x();
    chain.step();
    const double after = chain.position(lowest).x();
    if (before * after <= 0) times.push_back(chain.time() - chain.dt() * after / (after - before));
  }
  if (times.size() < passages) return std::numeric_limits<double>::quiet_NaN();
  return (passages - 1) * pi / (times.back() - times.front());
}

/// Semi-implicit Euler swings with 2 / dt asin(w dt / 2) where it should swing with w.
double semi_implicit_frequency(double omega, double dt) { return 2 / dt * std::asin(omega * dt / 2); }

/// Of a frequency from this many half periods: angles of 1e-3 change it by their square, and where a passage
/// is interpolated, it is off by less than (w dt)^3 / 10 of a step.
double frequency_tolerance(double turn, int half_periods) {
  return chain_angle * chain_angle + std::pow(turn, 4) / (10 * half_periods * pi);
}

const char* const frequency_reason = "angle^2 + (w dt)^4 / (10 pi half periods): wide swings, interpolation";

ValidationResult double_pendulum_modes(const EngineMaker& make) {
  ValidationResult result;
  const char* const names[] = {"slow", "fast"};
  const double zeros[] = {2 - std::sqrt(2.0), 2 + std::sqrt(2.0)};
  const auto frequency_at = [&make](double zero, double frequency) {
    return measured_frequency(make, chain_in_mode(2, zero, frequency), 100, 11);
  };
  for (int mode = 0; mode < 2; ++mode) {
    const double omega = std::sqrt(zeros[mode] * standard_gravity / chain_link);
    for (const double frequency : {60.0, 240.0}) {
      const double discrete = semi_implicit_frequency(omega, 1 / frequency);
      result.add(measured(std::string(names[mode]) + (frequency > 100 ? " mode at 240 Hz" : " mode at 60 Hz"),
                          frequency_at(zeros[mode], frequency), "rad/s")
                     .by("2/dt asin(w dt/2), w^2 = (2 -+ sqrt 2) g/l", discrete)
                     .within_share(frequency_tolerance(omega / frequency, 10), frequency_reason));
    }
  }
  const double fast = std::sqrt(zeros[1] * standard_gravity / chain_link);
  // Semi-implicit Euler is fast by (w dt)^2 / 24.
  result.convergence = converges(
      "frequency of the fast mode", [&](double hertz) { return frequency_at(zeros[1], hertz) - fast; }, 1.8,
      2.2);
  return result;
}

ValidationResult hanging_chain(const EngineMaker& make) {
  ValidationResult result;
  const int passages = 5, iterations = 100;
  for (const int n : {5, 10, 20}) {
    const double omega = std::sqrt(slowest_zero(n) * standard_gravity / chain_link);
    const double got = measured_frequency(make, chain_in_mode(n, slowest_zero(n), 60), iterations, passages);
    result.add(
        measured("slowest mode of " + std::to_string(n) + " beads", got, "rad/s")
            .by("2/dt asin(w dt/2), w^2 = x g/l, L_n(x) = 0", semi_implicit_frequency(omega, standard_dt))
            .within_share(frequency_tolerance(omega * standard_dt, passages - 1), frequency_reason));
    if (n != 20) continue;
    // n beads have 1 / 4n less than a rope, but for terms of 1 / n^2.
    const double rope = 2.404825557695773 / 2 * std::sqrt(standard_gravity / (n * chain_link));
    result.add(measured("slowest mode of 20 beads, beside a rope's", got, "rad/s")
                   .by("1.2024 sqrt(g/L) (1 - 1/4n)", rope * (1 - 0.25 / n))
                   .within_share(1.0 / (n * n), "1/n^2: the next term of the chain"));
  }
  return result;
}

}  // namespace

void add_modes_cases(ValidationCases& cases) {
  cases.push_back(
      {.id = "B17",
       .title =
           "A double pendulum of two equal masses swings with w^2 = (2 - sqrt 2) g / l or (2 + sqrt 2) g / l",
       .asks = Asks::any_engine,
       .run = double_pendulum_modes});
  cases.push_back({.id = "B26",
                   .title = "A hanging chain of n beads swings with the smallest zero of L_n; a rope, of J_0",
                   .source = "D. Bernoulli, 1738",
                   .asks = Asks::any_engine,
                   .run = hanging_chain});
}

}  // namespace cairn
