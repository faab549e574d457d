// Floor 8. Overlap that Baumgarte stabilization turns into speed: B24.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

/// The bare law (7), whose pop this is.
const double uncapped = std::numeric_limits<double>::infinity();

struct PopSpec {
  double overlap = 0.1;    // [m] d, at rest
  double frequency = 240;  // [1/s] steps
  Stabilization stabilization = {
      .policy = StabilizationPolicy::baumgarte, .baumgarte = 0.2, .slop = 0, .max_speed = uncapped};
  Shape<double> shape = circle(0.5);  // 1 m high
};

/// A body that is in the ground by d.
Scene sunk_body(const PopSpec& spec) {
  Scene scene({.dt = 1 / spec.frequency, .stabilization = spec.stabilization});
  scene.add_ground();
  scene.add({.shapes = {spec.shape}, .position = {0, 0.5 - spec.overlap}, .mass = 3});
  return scene;
}

/// How high above its place of rest it comes in 1.5 s, in which it has landed again [m].
double pop_apex(const EngineMaker& make, const PopSpec& spec) {
  Motion body(make, sunk_body(spec), 60);
  double top = -spec.overlap;
  while (body.time() < 1.5) {
    body.step();
    top = std::max(top, body.position({1}).y() - 0.5);
  }
  return top;
}

double pop_speed(const EngineMaker& make, const PopSpec& spec) {
  Motion body(make, sunk_body(spec), 60);
  body.step();
  return body.velocity({1}).y();
}

const char* const pop_formula = "sum of (v - k g dt) dt - d, v = beta d/dt";

/// The apex as the steps sum up, and as in continuous flight.
void add_pop_apexes(const EngineMaker& make, double d, double frequency, ValidationResult& result) {
  const double v = 0.2 * d * frequency, dt = 1 / frequency, g = standard_gravity;
  // The sum of the steps' ways v - k g dt, up to the last one that goes up.
  const double n = std::floor(v / (g * dt) + 1e-9);
  const double discrete = dt * ((n + 1) * v - g * dt * n * (n + 1) / 2) - d;
  const double got = pop_apex(make, {.overlap = d, .frequency = frequency});
  const std::string when = " at " + std::to_string(std::lround(frequency)) + " Hz";
  result.add(measured("apex above the place of rest" + when, got, "m")
                 .by(pop_formula, discrete)
                 .within(1e-9, "1e-9: rounding of a hundred steps and less"));
  result.add(measured("the same, beside continuous flight" + when, got, "m")
                 .by("(beta d/dt)^2/2g - d", v * v / (2 * g) - d)
                 .within(v * dt / 2 + g * dt * dt / 8 + 1e-9,
                         "v dt/2 + g dt^2/8: the first step goes v dt, not v dt - g dt^2/2"));
}

Measured still(const EngineMaker& make, const std::string& how, const Stabilization& stabilization) {
  return measured("apex above the place of rest with " + how,
                  std::max(0.0, pop_apex(make, {.stabilization = stabilization})), "m")
      .zero_within(1e-9, "1e-9: it must not jump at all; rounding");
}

ValidationResult pop(const EngineMaker& make) {
  ValidationResult result;
  for (const Shape<double>& shape : {Shape<double>(circle(0.5)), Shape<double>(box(1, 1))}) {
    const bool is_disc = std::holds_alternative<Circle<double>>(shape);
    result.add(measured(std::string("speed at which a ") + (is_disc ? "disc" : "box") + " leaves",
                        pop_speed(make, {.shape = shape}), "m/s")
                   .by("beta d/dt", 0.2 * 0.1 * 240)
                   .within_share(1e-9, "1e-9: 60 sweeps leave rounding"));
  }
  for (const double frequency : {120.0, 240.0, 480.0}) add_pop_apexes(make, 0.1, frequency, result);
  result.add(still(make, "no stabilization", {.policy = StabilizationPolicy::none}));
  result.add(still(make, "split impulses", {.policy = StabilizationPolicy::split_impulse}));
  result.add(still(make, "soft rows and a relaxing solve", {.policy = StabilizationPolicy::soft}));
  return result;
}

}  // namespace

void add_pop_cases(ValidationCases& cases) {
  cases.push_back({.id = "B24",
                   .title = "A body that overlaps the ground by d leaves it with beta d / dt, and so jumps",
                   .asks = Asks::any_engine,
                   .run = pop});
}

}  // namespace cairn
