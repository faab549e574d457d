// Floor 8. A ball that bounces.
#include <fmt/format.h>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/validation/worst.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double bounce_restitution = 0.8;  // e
const double bounce_height = 1;         // [m] h, of the ball's lowest point
const double bounce_radius = 0.25;      // [m]

Scene dropped_ball(double restitution, double frequency) {
  Scene scene({.dt = 1 / frequency, .restitution_threshold = 0});
  scene.add_ground();
  scene.add({.shapes = {circle(bounce_radius)},
             .position = {0, bounce_height + bounce_radius},
             .mass = 1,
             .material = {.restitution = restitution}});
  return scene;
}

double ball_height(const Snapshot& now) { return now.bodies.back().pose.position.y() - bounce_radius; }
double ball_speed(const Snapshot& now) { return now.bodies.back().velocity.y(); }

/// Of a ball that bounces until it lies still.
struct BounceRecord {
  List<double> apexes = {};  // [m] the highest points after each bounce
  double last_bounce = 0;    // [s] when it last rose faster than g dt
  double end = 0;            // [s]
  Snapshot rest = {};        // at the end
};

BounceRecord watch_ball(const EngineMaker& make, double frequency, double seconds) {
  const std::unique_ptr<Engine> ball = make(dropped_ball(bounce_restitution, frequency), 10);
  BounceRecord record;
  double before = 0;
  const auto steps = std::lround(seconds * frequency);
  for (long step = 1; step <= steps; ++step) {
    ball->step();
    const Snapshot now = ball->snapshot();
    if (ball_speed(now) < 0 && before > 0) record.apexes.push_back(ball_height(now));
    before = ball_speed(now);
    record.end = static_cast<double>(step) / frequency;
    if (before > standard_gravity / frequency) record.last_bounce = record.end;
  }
  record.rest = ball->snapshot();
  return record;
}

void add_bounce_apexes(List<Measured>& numbers, const BounceRecord& record, double frequency) {
  const double fall_speed = std::sqrt(2 * standard_gravity * bounce_height);
  for (int bounce = 1; bounce <= 5; ++bounce) {
    numbers.push_back(
        measured(fmt::format("apex after bounce {} at {} Hz", bounce, frequency),
                 bounce <= record.apexes.size() ? record.apexes[bounce - 1] : 0, "m")
            .by(fmt::format("e^{} h", 2 * bounce), std::pow(bounce_restitution, 2 * bounce) * bounce_height)
            .within(fall_speed / frequency * (1 + bounce_restitution),
                    "it turns up to v dt above the ground: v dt (1 + e)"));
  }
}

void add_rest(List<Measured>& numbers, const BounceRecord& record, double frequency) {
  // A ball slower than g dt comes down within four steps, and still keeps e of its speed each time.
  const double steps = (record.end - record.last_bounce) * frequency;
  const double tremble = standard_gravity / frequency * std::pow(bounce_restitution, steps / 4);
  const double rounding = 8 * double_epsilon;  // [m] of heights below 1 m
  numbers.push_back(measured(fmt::format("height at rest at {} Hz", frequency), ball_height(record.rest), "m")
                        .zero_within(tremble / frequency + rounding,
                                     "below g dt it keeps e of its speed every four steps; rounding of 1 m"));
  numbers.push_back(
      measured(fmt::format("speed at rest at {} Hz", frequency), ball_speed(record.rest), "m/s")
          .zero_within(tremble + rounding * frequency,
                       "below g dt it keeps e of its speed every four steps; rounding of 1 m/dt"));
}

/// v^2 / 2 + g y - g dt v / 2, for a ball of 1 kg [J]: what a step of v -= g dt, y += v dt keeps exactly.
double discrete_ball_energy(const Snapshot& now) {
  const double v = ball_speed(now);
  return v * v / 2 + standard_gravity * ball_height(now) - standard_gravity * standard_dt * v / 2;
}

Measured elastic_minute(const EngineMaker& make) {
  const int steps = 3600;
  const std::unique_ptr<Engine> ball = make(dropped_ball(1, 1 / standard_dt), 10);
  const double start = discrete_ball_energy(ball->snapshot());
  List<double> energies;
  for (int step = 0; step < steps; ++step) {
    ball->step();
    energies.push_back(discrete_ball_energy(ball->snapshot()));
  }
  return measured("energy in a minute of elastic bouncing at 60 Hz, the farthest from the start",
                  farthest(start, energies), "J")
      .by("v^2/2 + g y - g dt v/2 = g h", standard_gravity * bounce_height)
      .within(16 * double_epsilon * steps * start,
              "a step rounds v and y, below 4.5, a few times: 16 epsilon of g h");
}

// It falls for sqrt(2h/g), and each bounce lasts 2 e sqrt(2h/g), e^2, ...: a geometric series.
ValidationResult bouncing_ball(const EngineMaker& make) {
  const double e = bounce_restitution;
  const double total = std::sqrt(2 * bounce_height / standard_gravity) * (1 + e) / (1 - e);
  struct Accuracy {
    double frequency = 0;
    double share = 0;  // of the time
  };
  ValidationResult result;
  for (const Accuracy& row : {Accuracy{60, 0.1}, Accuracy{960, 0.02}}) {
    const BounceRecord record = watch_ball(make, row.frequency, 2 * total);
    add_bounce_apexes(result.numbers, record, row.frequency);
    result.add(
        measured(fmt::format("time until it lies still at {} Hz", row.frequency), record.last_bounce, "s")
            .by("sqrt(2h/g) (1 + e)/(1 - e)", total)
            .within(row.share * total,
                    "bounces shorter than a step are lost, and each turns up to dt early"));
    add_rest(result.numbers, record, row.frequency);
  }
  result.add(elastic_minute(make));
  return result;
}

}  // namespace

void add_bounce_cases(ValidationCases& cases) {
  cases.push_back({.id = "B4",
                   .title = "A ball that keeps e of its speed rises to e^2 of its height at each bounce",
                   .asks = Asks::any_engine,
                   .run = bouncing_ball});
}

}  // namespace cairn
