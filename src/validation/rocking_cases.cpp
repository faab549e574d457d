// Floor 8. A tall block that rocks from one bottom corner to the other: B40.
#include <cmath>
#include <limits>
#include <string>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double rocker_half_width = 0.5, rocker_half_height = 2;                         // [m] b, h
const double rocker_slenderness = std::atan(rocker_half_width / rocker_half_height);  // alpha
const double rocker_diagonal = std::hypot(rocker_half_width, rocker_half_height);     // [m] R, to its centre
const double rocker_rate = std::sqrt(3 * standard_gravity / (4 * rocker_diagonal));   // [1/s] p

/// When the block, let go at `start` [rad], is upright again [s]: d^2 q/dt^2 = -p^2 sin(alpha - q), with
/// I = 4/3 m R^2 about the corner. From the energy dq/dt = p sqrt(2 (cos(alpha - start) - cos(alpha - q))),
/// with q = start - s^2 to have no pole, by the midpoint rule.
double exact_quarter(double start) {
  const int pieces = 20000;
  const double end = std::sqrt(start);
  double sum = 0;
  for (int i = 0; i < pieces; ++i) {
    const double s = (i + 0.5) / pieces * end;
    // cos(x) - cos(y) = 2 sin((x + y) / 2) sin((y - x) / 2), with y - x = s^2
    const double x = rocker_slenderness - start;
    const double fall = 4 * std::sin(x + s * s / 2) * std::sin(s * s / 2);
    sum += 2 * s / std::sqrt(fall);
  }
  return sum * end / pieces / rocker_rate;
}

/// Leaning to the right on its right corner by `start` [rad], at rest.
Scene rocking_block(double start, double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add_ground({.material = {.friction = 2}});
  const double lean = rocker_slenderness - start;  // of the diagonal from the vertical
  scene.add({.shapes = {box(2 * rocker_half_width, 2 * rocker_half_height)},
             .position = {-rocker_diagonal * std::sin(lean), rocker_diagonal * std::cos(lean)},
             .angle = -start,
             .mass = 1,
             .material = {.friction = 2}});
  return scene;
}

struct Rocking {
  double quarter = std::numeric_limits<double>::quiet_NaN();  // [s] until it is upright
  double before = 0;                                          // [rad/s] how fast it turns there
  double after = 0;  // [rad/s] after the other corner has hit the ground
};

Rocking rocking(const EngineMaker& make, double start, double frequency) {
  Motion block(make, rocking_block(start, frequency), 150);
  Rocking result;
  while (block.time() < 2) {
    const double angle = block.angle({1}), speed = block.velocity({1}).z();
    block.step();
    if (block.angle({1}) <= -speed * block.dt() / 2) continue;
    // The other corner stops it where it hits: the last step is cut short.
    result.quarter = block.time() - block.dt() - angle / speed;
    result.before = speed;
    for (int step = 0; step < 2; ++step) block.step();
    result.after = block.velocity({1}).z();
    return result;
  }
  return result;
}

Measured quarter_number(double share, double exact, double got) {
  return measured("quarter period from " + std::to_string(std::lround(100 * share)) + " % of alpha at 240 Hz",
                  got, "s")
      .by("acosh(1/(1 - share))/p", exact)
      .within_share(0.02, "2 %: sin(alpha - q) for alpha - q, 0.3 %, and 1.5 steps of 240 Hz");
}

/// Angular momentum about the new corner is kept, but for gravity.
Measured landing_number(const Rocking& found, double frequency) {
  return measured("speed after the other corner lands, worst of three starts at 60 and 240 Hz", found.after,
                  "rad/s")
      .by("(1 - 3/2 sin^2 alpha) w", (1 - 1.5 * std::pow(std::sin(rocker_slenderness), 2)) * found.before)
      .within(3 * rocker_rate * rocker_rate * std::sin(rocker_slenderness) / frequency,
              "gravity in the step that is cut short and two more: 3 p^2 sin(alpha) dt");
}

ValidationResult rocking_blocks(const EngineMaker& make) {
  ValidationResult result;
  Worst kept;
  for (const double share : {0.25, 0.5, 0.75}) {
    for (const double frequency : {240.0, 60.0}) {
      const Rocking found = rocking(make, share * rocker_slenderness, frequency);
      kept.add(landing_number(found, frequency));
      if (frequency < 100) continue;
      result.add(quarter_number(share, std::acosh(1 / (1 - share)) / rocker_rate, found.quarter));
    }
  }
  result.add(kept.number());
  const double start = 0.5 * rocker_slenderness, exact = exact_quarter(start);
  result.convergence = converges(
      "quarter period from 50 % of alpha",
      [&make, start, exact](double frequency) { return rocking(make, start, frequency).quarter - exact; });
  return result;
}

}  // namespace

void add_rocking_cases(ValidationCases& cases) {
  cases.push_back({.id = "B40",
                   .title = "A rocking block is upright after acosh(1 / (1 - angle / alpha)) / p",
                   .source = "G. W. Housner, 1963",
                   .asks = Asks::any_engine,
                   .run = rocking_blocks});
}

}  // namespace cairn
