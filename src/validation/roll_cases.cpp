// Floor 8. Discs that are thrown along the ground, slip, and come to roll.
#include <fmt/format.h>

#include <cairn/geometry/shape.hpp>
#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_runs.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double roll_radius = 0.5;                             // [m] R
const double roll_friction = 0.2;                           // mu
const double roll_pull = roll_friction * standard_gravity;  // [m/s^2] of friction while it slips

/// A disc on the ground that is thrown to the right at `speed`, and turns as if it rolled to the left at
/// `rim` = R w0 [m/s].
Scene thrown_disc(double speed, double rim, double frequency) {
  Scene scene({.dt = 1 / frequency});
  scene.add_ground({.material = {.friction = roll_friction}});
  scene.add({.shapes = {circle(roll_radius)},
             .position = {0, roll_radius},
             .velocity = {speed, 0},
             .angular_velocity = rim / roll_radius,
             .mass = 2,
             .inertia = roll_radius * roll_radius,
             .material = {.friction = roll_friction}});
  return scene;
}

const std::string roll_reason = "the sums are exact; the rows of a disc do not act on each other";

// The rim slides at v0 and friction takes 3 mu g of that a second: mu g from v, 2 mu g from the spin.
ValidationResult slip_to_roll(const EngineMaker& make) {
  const double v0 = 6, t = v0 / (3 * roll_pull);  // 1 s
  const double ideal = 5 * v0 * v0 / (18 * roll_pull);
  const auto way = [&](double frequency) {
    return run_scene(make, thrown_disc(v0, 0, frequency), 10, t).bodies.back().pose.position.x();
  };
  ValidationResult result;
  result.add(measured("way until it rolls, after 1 s at 60 Hz", way(60), "m")
                 .by("5 v0^2/(18 mu g) - v0 dt/6", ideal - v0 * standard_dt / 6)
                 .within(1e-9 * ideal, roll_reason));
  const Snapshot end = run_scene(make, thrown_disc(v0, 0, 60), 10, t + 1);
  const Vec3<double> v = end.bodies.back().velocity;
  result.add(
      measured("speed when it rolls", v.x(), "m/s").by("2/3 v0", 2 * v0 / 3).within(1e-9 * v0, roll_reason));
  result.add(measured("speed of its rim when it rolls", -v.z() * roll_radius, "m/s")
                 .by("2/3 v0", 2 * v0 / 3)
                 .within(1e-9 * v0, roll_reason));
  result.convergence = converges("way until it rolls, to 5 v0^2/(18 mu g)",
                                 [&](double frequency) { return way(frequency) - ideal; });
  return result;
}

const double backspin_speed = 3;  // [m/s] v0

/// When it begins to roll [s]: the rim slides at v0 + R w0.
double rolling_begins(double rim) { return (backspin_speed + rim) / (3 * roll_pull); }

/// The way of a disc with backspin until it rolls [m], and what calculus says of it.
double backspin_way(const EngineMaker& make, double rim, double frequency) {
  const Snapshot end = run_scene(make, thrown_disc(backspin_speed, rim, frequency), 10, rolling_begins(rim));
  return end.bodies.back().pose.position.x();
}
double ideal_backspin_way(double rim) {
  const double t = rolling_begins(rim);
  return backspin_speed * t - roll_pull * t * t / 2;
}

void add_rolling(List<Measured>& numbers, const EngineMaker& make, double share) {
  const double rim = share * backspin_speed;
  const Snapshot end = run_scene(make, thrown_disc(backspin_speed, rim, 60), 10, rolling_begins(rim) + 0.1);
  const Vec3<double> v = end.bodies.back().velocity;
  const auto add = [&](const std::string& what, double got) {
    numbers.push_back(measured(what + fmt::format(", R w0 = {} v0", share), got, "m/s")
                          .by("(2 v0 - R w0)/3", (2 * backspin_speed - rim) / 3)
                          .within(1e-9 * backspin_speed, roll_reason));
  };
  add("speed when it rolls", v.x());
  add("speed of its rim when it rolls", -v.z() * roll_radius);
}

// Friction acts until v = -R w: it takes v0 + R w0 from the two together, a third of that from v. A negative
// speed is a return.
ValidationResult backspin(const EngineMaker& make) {
  ValidationResult result;
  for (const double share : {0.5, 1.9, 2.0, 2.1, 4.0}) add_rolling(result.numbers, make, share);
  for (const double share : {1.0, 3.0}) {  // it rolls after 1 s and 2 s: whole numbers of steps
    const double rim = share * backspin_speed;
    result.add(measured(fmt::format("way until it rolls at 60 Hz, R w0 = {} v0", share),
                        backspin_way(make, rim, 60), "m")
                   .by("v0 t - mu g t^2/2 - mu g t dt/2",
                       ideal_backspin_way(rim) - roll_pull * rolling_begins(rim) * standard_dt / 2)
                   .within(1e-9, roll_reason));
  }
  result.convergence =
      converges("way until it rolls, R w0 = v0, to v0 t - mu g t^2/2", [&](double frequency) {
        return backspin_way(make, backspin_speed, frequency) - ideal_backspin_way(backspin_speed);
      });
  return result;
}

}  // namespace

void add_roll_cases(ValidationCases& cases) {
  cases.push_back({.id = "B8",
                   .title = "A disc thrown without spin slips for v0 / (3 mu g), and then rolls at 2/3 v0",
                   .asks = Asks::any_engine,
                   .run = slip_to_roll});
  cases.push_back(
      {.id = "B9",
       .title = "A disc with backspin comes to roll at (2 v0 - R w0) / 3, and returns if R w0 > 2 v0",
       .asks = Asks::any_engine,
       .run = backspin});
}

}  // namespace cairn
