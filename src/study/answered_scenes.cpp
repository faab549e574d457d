// Floor 9. Motions with a known end.
#include <cairn/study/answered_scenes.hpp>

#include <algorithm>
#include <cmath>

#include <cairn/constraints/friction_joint.hpp>
#include <cairn/constraints/revolute_joint.hpp>
#include <cairn/measure/energy.hpp>
#include <cairn/math/list.hpp>

namespace cairn {

namespace {

constexpr double gravity = 10;  // [m/s^2]

/// The error of one number that a function finds in the last snapshot.
class LastNumber final : public MotionError {
 public:
  LastNumber(double expected, double scale, std::function<double(const Snapshot&)> number)
      : expected_(expected), scale_(scale), number_(std::move(number)) {}
  void see(const Snapshot& snapshot) override { found_ = number_(snapshot); }
  double value() const override { return std::abs(found_ - expected_) / scale_; }

 private:
  double expected_, scale_;
  double found_ = 0;
  std::function<double(const Snapshot&)> number_;
};

/// How far the energy at the end is from that at the start, of a given scale.
class EnergyChange final : public MotionError {
 public:
  explicit EnergyChange(double scale) : scale_(scale) {}
  void see(const Snapshot& snapshot) override {
    last_ = total_energy(snapshot);
    if (!seen_) first_ = last_;
    seen_ = true;
  }
  double value() const override { return std::abs(last_ - first_) / scale_; }

 private:
  double scale_;
  double first_ = 0, last_ = 0;
  bool seen_ = false;
};

/// The highest point after the first bounce.
class FirstApex final : public MotionError {
 public:
  explicit FirstApex(double expected) : expected_(expected) {}
  void see(const Snapshot& snapshot) override {
    const SnapshotBody& ball = snapshot.bodies[{1}];
    const bool rises = ball.velocity.y() > 0;
    bounces_ += rises && falls_ ? 1 : 0;
    falls_ = !rises;
    if (bounces_ == 1) apex_ = std::max(apex_, ball.pose.position.y());
  }
  double value() const override { return std::abs(apex_ - expected_) / expected_; }

 private:
  double expected_;
  double apex_ = 0;
  int bounces_ = 0;
  bool falls_ = true;
};

double mean_of(double a, double b, double& geometric) {
  while (std::abs(a - b) > 1e-15 * a) {
    const double next = (a + b) / 2;
    b = std::sqrt(a * b);
    a = next;
  }
  geometric = b;
  return a;
}

/// [s] of a rod of 1 m on a pin at its end, from `amplitude`: 2 pi sqrt(I / (m g d)) over the
/// arithmetic-geometric mean of 1 and cos(amplitude / 2) (A. M. Legendre; C. F. Gauss).
double rod_period(double amplitude) {
  double geometric = 0;
  const double mean = mean_of(1, std::cos(amplitude / 2), geometric);
  return 2 * pi * std::sqrt((1.0 / 3) / (gravity * 0.5)) / mean;
}

SceneSettings weightless() {
  SceneSettings settings;
  settings.gravity = {0, 0};
  return settings;
}

/// A rod of 1 m and 1 kg whose upper end is at `pin`, turned by `angle` from hanging.
BodySpec hanging_rod(const Vec2<double>& pin, double angle) {
  return {.shapes = {box(0.05, 1)},
          .position = pin + 0.5 * Vec2<double>(std::sin(angle), -std::cos(angle)),
          .angle = angle,
          .mass = 1,
          .inertia = 1.0 / 12};
}

Scene pendulum(double amplitude) {
  Scene scene;
  const BodyId rod = scene.add(hanging_rod({0, 0}, amplitude));
  scene.join<RevoluteJoint>({.a = ground, .b = rod, .anchor = {0, 0}});
  return scene;
}

Scene double_pendulum() {
  Scene scene;
  const BodyId upper = scene.add(hanging_rod({0, 0}, pi / 2));
  const BodyId lower = scene.add(hanging_rod({1, 0}, pi / 2));
  scene.join<RevoluteJoint>({.a = ground, .b = upper, .anchor = {0, 0}});
  scene.join<RevoluteJoint>({.a = upper, .b = lower, .anchor = {1, 0}});
  return scene;
}

/// A disc on a pin off its centre, which turns once a second without gravity.
Scene rotor() {
  Scene scene(weightless());
  const double rate = 2 * pi;
  const BodyId disc = scene.add({.shapes = {circle(0.2)},
                                 .position = {1, 0},
                                 .velocity = {0, rate},
                                 .angular_velocity = rate,
                                 .mass = 1});
  scene.join<RevoluteJoint>({.a = ground, .b = disc, .anchor = {0, 0}});
  return scene;
}

Scene bouncing_ball() {
  SceneSettings settings;
  settings.restitution_threshold = 0.1;
  Scene scene(settings);
  scene.add_ground({.material = {.friction = 0}});
  scene.add({.shapes = {circle(0.25)},
             .position = {0, 1.25},
             .mass = 1,
             .material = {.friction = 0, .restitution = 0.8}});
  return scene;
}

Scene sliding_box() {
  Scene scene;
  scene.add_ground({.material = {.friction = 0.3}});
  scene.add({.shapes = {box(1, 0.5)},
             .position = {0, 0.25},
             .velocity = {5, 0},
             .mass = 1,
             .material = {.friction = 0.3}});
  return scene;
}

Scene slipping_disc() {
  Scene scene;
  scene.add_ground({.material = {.friction = 0.2}});
  scene.add({.shapes = {circle(0.5)},
             .position = {0, 0.5},
             .velocity = {6, 0},
             .mass = 1,
             .material = {.friction = 0.2}});
  return scene;
}

Scene puck() {
  Scene scene(weightless());
  const double slant = pi / 6;
  const BodyId disc = scene.add(
      {.shapes = {circle(0.25)}, .velocity = {3 * std::cos(slant), 3 * std::sin(slant)}, .mass = 1});
  // mu m g with mu = 0.3
  scene.join<FrictionJoint>({.a = ground, .b = disc, .max_force = 3});
  return scene;
}

std::function<std::unique_ptr<MotionError>()> watch_number(
    double expected, double scale, const std::function<double(const Snapshot&)>& number) {
  return [=] { return std::make_unique<LastNumber>(expected, scale, number); };
}

AnsweredScene pendulum_from(const std::string& name, double degrees) {
  const double amplitude = degrees * pi / 180;
  return {.name = name,
          .what = "angle after one period",
          .formula = "the amplitude again; the period by Legendre and Gauss",
          .seconds = rod_period(amplitude),
          .make = [amplitude] { return pendulum(amplitude); },
          .watch =
              watch_number(amplitude, amplitude, [](const Snapshot& s) { return s.bodies[{1}].pose.angle; })};
}

}  // namespace

const List<AnsweredScene>& answered_scenes() {
  static const List<AnsweredScene> scenes = {
      pendulum_from("pendulum-45", 45),
      pendulum_from("pendulum-150", 150),
      {.name = "double-pendulum-energy",
       .what = "energy after 5 s",
       .formula = "that of the start; compared with 2 m g 2 L",
       .seconds = 5,
       .make = double_pendulum,
       .watch = [] { return std::make_unique<EnergyChange>(2 * gravity * 2); }},
      {.name = "rotor",
       .what = "distance from the pin after 2 turns",
       .formula = "1 m",
       .seconds = 2,
       .make = rotor,
       .watch = watch_number(1, 1, [](const Snapshot& s) { return s.bodies[{1}].pose.position.norm(); })},
      {.name = "bounce",
       .what = "height of the first bounce",
       .formula = "e^2 h",
       .seconds = 1.2,
       .make = bouncing_ball,
       .watch = [] { return std::make_unique<FirstApex>(0.25 + 0.64); }},
      {.name = "stopping",
       .what = "way to a stop",
       .formula = "v^2 / (2 mu g)",
       .seconds = 2.5,
       .make = sliding_box,
       .watch = watch_number(25.0 / 6, 25.0 / 6,
                             [](const Snapshot& s) { return s.bodies[{1}].pose.position.x(); })},
      {.name = "slip-to-roll",
       .what = "way after 2 s",
       .formula = "5 v^2 / (18 mu g) + 2/3 v (t - v / (3 mu g))",
       .seconds = 2,
       .make = slipping_disc,
       .watch = watch_number(9, 9, [](const Snapshot& s) { return s.bodies[{1}].pose.position.x(); })},
      {.name = "puck-from-above",
       .what = "way to a stop at 30 degrees",
       .formula = "v^2 / (2 mu g)",
       .seconds = 1.5,
       .make = puck,
       .watch =
           watch_number(1.5, 1.5, [](const Snapshot& s) { return s.bodies[{1}].pose.position.norm(); })}};
  return scenes;
}

}  // namespace cairn
