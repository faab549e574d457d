// Floor 8. A rod that swings about its end, and two that tumble.
#include <fmt/format.h>

#include <algorithm>

#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/geometry/shape.hpp>
#include <cairn/measure/energy.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double swinging_length = 1;  // [m] L

/// The arithmetic-geometric mean of a and b.
double arithmetic_geometric_mean(double a, double b) {
  while (std::abs(a - b) > 4 * double_epsilon * a) {
    const double mean = (a + b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  return a;
}

/// 2 pi sqrt(I / (m g d)) / agm(1, cos(q0 / 2)) [s], with I = m L^2 / 3 about the end and d = L / 2.
double elliptic_period(double amplitude) {
  return 2 * pi * std::sqrt(2 * swinging_length / (3 * standard_gravity)) /
         arithmetic_geometric_mean(1, std::cos(amplitude / 2));
}

/// d ln T / d ln E: how much a period changes with the energy lost or gained on the way.
double period_sensitivity(double amplitude) {
  const double h = 1e-4;
  const double slope = (elliptic_period(amplitude + h) - elliptic_period(amplitude - h)) / (2 * h);
  return slope / elliptic_period(amplitude) * (1 - std::cos(amplitude)) / std::sin(amplitude);
}

/// A thin rod of 1 kg, pinned at its end, at rest at `amplitude` [rad] from hanging down.
Scene swinging_rod(double amplitude, double frequency, double baumgarte) {
  Scene scene({.dt = 1 / frequency,
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = baumgarte}});
  const Vec2<double> hanging(0, -swinging_length / 2);
  const BodyId rod = scene.add({.shapes = {box(0.01, swinging_length)},
                                .position = Rotation<double>(amplitude) * hanging,
                                .angle = amplitude,
                                .mass = 1,
                                .inertia = swinging_length * swinging_length / 12});
  scene.join<RevoluteJoint>({.a = ground, .b = rod, .anchor = {0, 0}});
  return scene;
}

/// The time [s] between the first and the third passage of the vertical: a whole period, in which the half
/// step by which velocities lag behind positions cancels. 0 if it takes longer than 10 s.
double measured_period(const EngineMaker& make, double amplitude, double frequency, double baumgarte) {
  const std::unique_ptr<Engine> engine = make(swinging_rod(amplitude, frequency, baumgarte), 50);
  List<double> passages;
  double before = amplitude;
  for (int step = 1; passages.size() < 3 && step < 10 * frequency; ++step) {
    engine->step();
    const double after = engine->snapshot().bodies.back().pose.angle;
    if (before * after <= 0) passages.push_back((step - after / (after - before)) / frequency);
    before = after;
  }
  return passages.size() < 3 ? 0 : passages[2] - passages[0];
}

/// Of a rod that swings little: 2 pi sqrt(2L/3g), but for the amplitude.
void add_small_swings(List<Measured>& numbers, const EngineMaker& make) {
  const double amplitude = in_radians(5);
  for (const double baumgarte : {0.0, 0.2}) {
    for (const double frequency : {60.0, 240.0}) {
      const double turn = std::sqrt(3 * standard_gravity / (2 * swinging_length)) / frequency;
      numbers.push_back(
          measured(fmt::format("period from 5 degrees at {} Hz, beta = {}", frequency, baumgarte),
                   measured_period(make, amplitude, frequency, baumgarte), "s")
              .by("2 pi sqrt(2L/3g)/agm(1, cos(q0/2))", elliptic_period(amplitude))
              .within(1.5 * turn * turn / 24 * elliptic_period(amplitude),
                      "semi-implicit Euler swings with 2/dt asin(w dt/2): 1.5 (w dt)^2/24 of it"));
    }
  }
}

Measured wide_swing(const EngineMaker& make, double degrees, double frequency) {
  return measured(fmt::format("period from {} degrees at {} Hz, beta = 0.2", degrees, frequency),
                  measured_period(make, in_radians(degrees), frequency, 0.2), "s")
      .by("2 pi sqrt(2L/3g)/agm(1, cos(q0/2))", elliptic_period(in_radians(degrees)));
}

/// At the bottom the rod turns by w dt in a step, and (w dt)^2 of its energy is at stake. From 150
/// degrees an error of the energy counts several times, and at 60 Hz an eighth of the period is lost: no law
/// of small errors holds.
void add_wide_swings(List<Measured>& numbers, const EngineMaker& make) {
  for (const double degrees : {45.0, 90.0, 150.0}) {
    const double amplitude = in_radians(degrees);
    const double top_speed_squared = 3 * standard_gravity / swinging_length * (1 - std::cos(amplitude));
    const double share = 1.5 * top_speed_squared * std::max(1.0, period_sensitivity(amplitude));
    Measured coarse = wide_swing(make, degrees, 60), middle = wide_swing(make, degrees, 240);
    Measured fine = wide_swing(make, degrees, 960);
    coarse.tolerance = share / (60.0 * 60.0) * coarse.expected;
    fine.tolerance = share / (960.0 * 960.0) * fine.expected;
    coarse.reason = fine.reason =
        "(w dt)^2 of the energy at the bottom, times d ln T/d ln E, and half of it more";
    middle.tolerance = coarse.error() / 4;
    middle.reason = "the first order cancels: less than a quarter of the error at 60 Hz";
    if (degrees < 100) numbers.push_back(coarse);
    numbers.push_back(middle);
    numbers.push_back(fine);
  }
}

/// Two errors c dt + d dt^2 + ... combine to -d dt^2 / 2 or so, a quarter of it at half the step.
void add_extrapolated_swings(List<Measured>& numbers, const EngineMaker& make) {
  for (const double degrees : {45.0, 90.0}) {
    const double amplitude = in_radians(degrees), period = elliptic_period(amplitude);
    const double coarse = measured_period(make, amplitude, 120, 0);
    const double middle = measured_period(make, amplitude, 240, 0);
    const double fine = measured_period(make, amplitude, 480, 0);
    numbers.push_back(
        measured(fmt::format("period from {} degrees, beta = 0, extrapolated from 240 and 480 Hz", degrees),
                 2 * fine - middle, "s")
            .by("2 pi sqrt(2L/3g)/agm(1, cos(q0/2))", period)
            .within(1.5 * std::abs(2 * middle - coarse - period) / 4,
                    "of second order: a quarter of the error from 120 and 240 Hz, and half of it more"));
  }
}

// I q'' = -m g d sin q: Legendre's complete elliptic integral, by Gauss's arithmetic-geometric mean.
ValidationResult swinging(const EngineMaker& make) {
  ValidationResult result;
  add_small_swings(result.numbers, make);
  add_wide_swings(result.numbers, make);
  add_extrapolated_swings(result.numbers, make);
  const double amplitude = in_radians(90);
  result.convergence = converges("period from 90 degrees, beta = 0", [&](double frequency) {
    return measured_period(make, amplitude, frequency, 0) - elliptic_period(amplitude);
  });
  return result;
}

/// Two equal thin rods of 1 m and 1 kg, the one at the end of the other, let go from the horizontal.
Scene tumbling_rods(double frequency, double baumgarte) {
  Scene scene({.dt = 1 / frequency,
               .stabilization = {.policy = StabilizationPolicy::baumgarte, .baumgarte = baumgarte}});
  const BodyId first = scene.add({.position = {0.5, 0}, .mass = 1, .inertia = 1.0 / 12});
  const BodyId second = scene.add({.position = {1.5, 0}, .mass = 1, .inertia = 1.0 / 12});
  scene.join<RevoluteJoint>({.a = ground, .b = first, .anchor = {0, 0}});
  scene.join<RevoluteJoint>({.a = first, .b = second, .anchor = {1, 0}});
  return scene;
}

/// The energy of the rods, which start with 0 J.
struct EnergyOfRods {
  double last = 0;     // [J]
  double highest = 0;  // [J], at least 0
};

/// Velocities belong to the middle of a step, so the kinetic energy at its end is the mean of those of this
/// step and the next.
EnergyOfRods energy_of_rods(const EngineMaker& make, double frequency, double baumgarte, double seconds) {
  const std::unique_ptr<Engine> rods = make(tumbling_rods(frequency, baumgarte), 100);
  EnergyOfRods energy;
  const auto steps = std::lround(seconds * frequency);
  rods->step();
  Snapshot now = rods->snapshot();
  for (long step = 0; step < steps; ++step) {
    rods->step();
    const Snapshot next = rods->snapshot();
    energy.last = potential_energy(now) + (kinetic_energy(now) + kinetic_energy(next)) / 2;
    energy.highest = std::max(energy.highest, energy.last);
    now = next;
  }
  return energy;
}

// Nothing but the integration takes or gives energy. What a step takes out because its rows turn, -impulse
// times j v / 2, the stretch that Baumgarte leaves in the joints gives back, once it is steady: the errors of
// first order cancel. Without stabilization they stay.
ValidationResult tumbling(const EngineMaker& make) {
  ValidationResult result;
  for (const double baumgarte : {0.0, 0.2}) {
    for (const double frequency : {60.0, 240.0}) {
      result.add(
          measured(
              fmt::format("most energy above the start in 10 s at {} Hz, beta = {}", frequency, baumgarte),
              energy_of_rods(make, frequency, baumgarte, 10).highest, "J")
              .zero_within(
                  std::pow(standard_gravity / frequency, 2),
                  "at rest a velocity of the middle of a step is not one yet: (g dt)^2 m/2 of two rods"));
    }
  }
  double coarse = energy_of_rods(make, 60, 0.2, 1).last;
  for (const double frequency : {120.0, 240.0, 480.0}) {
    const double fine = energy_of_rods(make, frequency, 0.2, 1).last;
    result.add(measured(fmt::format("energy after 1 s at {} Hz, beta = 0.2", frequency), fine, "J")
                   .zero_within(std::abs(coarse) / 4,
                                "the first order cancels: a quarter, or less, of that at half the rate"));
    coarse = fine;
  }
  result.convergence = converges("energy after 1 s, beta = 0", [&](double frequency) {
    return energy_of_rods(make, frequency, 0, 1).last;
  });
  return result;
}

}  // namespace

void add_pendulum_cases(ValidationCases& cases) {
  cases.push_back({.id = "B15",
                   .title = "A pinned rod swings with the period of the elliptic integral",
                   .source = "A.-M. Legendre, 1825; C. F. Gauss, 1818",
                   .asks = Asks::any_engine,
                   .run = swinging});
  cases.push_back({.id = "B16",
                   .title = "A double pendulum keeps its energy: it loses some to the steps, and never gains",
                   .asks = Asks::any_engine,
                   .run = tumbling});
}

}  // namespace cairn
