// Floor 9. Maps of what a step and a number can resolve: springs, and places far from the origin.
#include <fmt/format.h>

#include <cmath>

#include <cairn/constraints/distance_joint.hpp>
#include <cairn/study/extremes/atlas.hpp>
#include <cairn/math/math.hpp>

namespace cairn {

namespace {

constexpr double spring_pull = 0.1;  // [m] of each spring of the row
constexpr int spring_balls = 5;
constexpr double spring_gain = 0.01;  // of the energy at the start; an exact solve only loses

/// Balls of 1 kg one behind the other on undamped springs of 1 m, all pulled out; the last weighs 100 kg.
Scene row_on_springs(double frequency) {
  Scene scene({.gravity = {0, 0}});
  BodyId before = ground;
  for (int i = 1; i <= spring_balls; ++i) {
    const double mass = i == spring_balls ? 100 : 1, from = (1 + spring_pull) * (i - 1);
    const Vec2<double> place(from + 1 + spring_pull, 0);
    const BodyId ball = scene.add({.position = place, .mass = mass, .inertia = 0.1 * mass});
    scene.join<DistanceJoint>({.a = before,
                               .b = ball,
                               .anchor_a = {from, 0},
                               .anchor_b = place,
                               .length = 1,
                               .kind = DistanceJoint::Kind::spring,
                               .softness = SwingSoftness{.frequency = frequency}});
    before = ball;
  }
  return scene;
}

/// Kinetic energy and that of the springs [J] in the middle of a step, where both are those of one moment;
/// k = m (2 pi f)^2, with the reduced mass m of the two.
double energy_on_springs(const Snapshot& now, double frequency) {
  double energy = 0;
  for (int i = 1; i < now.bodies.size(); ++i) {
    const SnapshotBody &before = now.bodies[{i - 1}], &ball = now.bodies[{i}];
    const double free = i == 1 ? 0 : 1 / before.mass;
    const double stiffness = std::pow(2 * pi * frequency, 2) / (free + 1 / ball.mass);
    const auto middle = [&](const SnapshotBody& body) -> Vec2<double> {
      return body.pose.position - now.dt / 2 * body.velocity.head<2>();
    };
    const double stretch = (middle(ball) - middle(before)).norm() - 1;
    energy += ball.mass * ball.velocity.head<2>().squaredNorm() / 2 + stiffness * stretch * stretch / 2;
  }
  return energy;
}

/// What is left of the energy after a second: all of it, if springs were exact.
AtlasCell swing_of(const Setting& setting, double frequency) {
  double first = 0, most = 0, last = 0;
  TrialOptions options;
  options.seconds = std::max(1.0, setting.dt);
  options.most_energy = std::numeric_limits<double>::infinity();
  options.observer = [&](const Snapshot& now) {
    last = energy_on_springs(now, frequency);
    if (first == 0) first = last;
    most = std::max(most, last);
  };
  options.gives_up = [&](const TrialResult&) { return most > (1 + spring_gain) * first; };
  const TrialResult result = run_trial(row_on_springs(frequency), setting, options);
  AtlasCell cell{.measured = last / first, .energy_gain = most / first - 1};
  const bool exploded = result.status != TrialStatus::ok || !(cell.energy_gain <= spring_gain);
  cell.ending = class_of(1 - cell.measured, {.holds = 0.1, .strained = 0.9});
  if (exploded) cell.ending = AtlasClass::exploded;
  if (result.status == TrialStatus::refused) cell.ending = AtlasClass::refused;
  return cell;
}

constexpr double rolling_speed = 0.4;  // [m/s]: less than 7 mm a step

/// A disc that rolls on a table at (x, x).
Scene far_disc(double x) {
  const double radius = 0.35;  // [m]: no sum of a few powers of 2, which would be exact at any x
  Scene scene;
  scene.add({.type = BodyType::static_body, .shapes = {box(20, 2)}, .position = {x, x - 1}});
  scene.add({.shapes = {circle(radius)},
             .position = {x, x + radius},
             .velocity = {rolling_speed, 0},
             .angular_velocity = -rolling_speed / radius});
  return scene;
}

/// Against the same disc at the origin.
AtlasCell far_cell(const Setting& setting, double x) {
  const AtlasLimits limits{.seconds = 2, .holds = usual_slop, .strained = 0.25};
  const auto way = [](const TrialResult& result) { return result.farthest; };
  const double near = atlas_cell(far_disc(0), setting, limits, way).measured;
  return atlas_cell(far_disc(x), setting, limits,
                    [&](const TrialResult& result) { return std::abs(result.farthest - near); });
}

}  // namespace

AtlasMap spring_map() {
  AtlasMap map;
  map.name = "springs";
  map.what =
      "Five balls in a row on undamped springs, the last of 100 kg, the others of 1 kg: the energy that is "
      "left after 1 s. 10 sweeps, warm start.";
  map.quantity = "energy left, as a part of that at the start";
  map.x = {.title = "steps a second",
           .values = {10, 20, 30, 60, 120, 240, 480, 1e3, 2e3, 5e3, 1e4},
           .labels = {"10", "", "", "60", "", "", "", "10^3", "", "", "10^4"}};
  map.y = {.title = "frequency of a spring [Hz]",
           .values = {0.1, 0.3, 1, 3, 10, 30, 100, 300, 1e3},
           .labels = {"0.1", "0.3", "1", "3", "10", "30", "100", "300", "1000"}};
  map.panels = solver_panels(10);
  map.panels.push_back({"reference, exact", atlas_setting("reference", 1)});
  map.classes = {{{"swings", "at least 90 % of the energy is left"},
                  {"fades", "at least 10 %"},
                  {"stands still", "less than 10 %"},
                  {"gains", "1 % more energy than at the start; solved exactly, springs only lose"},
                  {"", ""}}};
  map.reading = AtlasReading::up_to_y;
  map.headline = 3;
  map.headline_text = "At 60 steps a second a spring still swings after 1 s";
  map.y_unit = "Hz";
  map.run = [](const AtlasPanel& panel, double rate, double frequency) {
    Setting setting = panel.setting;
    setting.dt = 1 / rate;
    return swing_of(setting, frequency);
  };
  return map;
}

AtlasMap origin_map() {
  AtlasMap map;
  map.name = "origin";
  map.what =
      "A disc that rolls at 0.4 m/s on a table at (x, x), 2 s at 60 steps a second, 10 sweeps. Warm start, "
      "Baumgarte.";
  map.quantity = "way of the disc beside that at the origin [m]";
  map.x.title = "distance from the origin [m]";
  for (int power = 2; power <= 19; ++power) {
    map.x.values.push_back(std::pow(10.0, power));
    map.x.labels.push_back(power % 3 == 2 ? fmt::format("10^{{{}}}", power) : "");
  }
  map.y = {.title = "scalar", .values = {0, 1, 2}, .labels = {"float", "double", "long"}};
  map.panels = solver_panels(10);
  map.panels.push_back({"reference, exact", atlas_setting("reference", 1)});
  if (has_box2d()) map.panels.push_back({"Box2D 2.4.1", atlas_setting("box2d", 10)});
  map.classes = {{{"as at the origin", "within 5 mm, the slop"},
                  {"shifts", "within 25 cm"},
                  {"breaks", "farther, and stays finite"},
                  {"explodes", "10 % more energy than at the start"},
                  {"refused", "an error names the body and its place"}}};
  map.reading = AtlasReading::up_to_x;
  map.headline_text = "Far from the origin";
  map.run = [](const AtlasPanel& panel, double x, double scalar) {
    Setting setting = panel.setting;
    setting.scalar = static_cast<Precision>(static_cast<int>(scalar));
    if (setting.solver == "box2d" && scalar > 0) return AtlasCell{};  // it has float alone
    return far_cell(setting, x);
  };
  return map;
}

}  // namespace cairn
