// Springs give back what they held: swings against their closed forms, and the energy that is counted.
#include <cairn/samples/samples.hpp>
#include "testing.hpp"

using namespace cairn;

namespace {

constexpr double swings_per_second = 1.6, omega = 2 * pi * swings_per_second;  // [Hz], [rad/s]
constexpr double turn = omega / 240;                                           // [rad] in a substep of four

/// A bob of 3 kg under the origin on a spring of 2 m, pulled out by 0.25 m.
Scene bob_under(const Softness& softness, const SceneSettings& settings) {
  Scene scene(settings);
  const BodyId bob =
      scene.add({.shapes = {circle(0.1)}, .position = {0, -2.25}, .mass = 3, .fixed_rotation = true});
  samples::hang(scene, bob, {0, 0}, samples::spring(2, softness));
  return scene;
}

/// The least and the largest of a number within some seconds of steps.
struct Range {
  double least = 1e300;
  double largest = -1e300;
};

template <typename Number>
Range range_of(World<double>& world, double seconds, const Number& number) {
  SequentialImpulse<double> solver({.iterations = 10});
  Range range;
  for (int step = 0; step < std::lround(60 * seconds); ++step) {
    world.step(solver);
    range.least = std::min(range.least, number());
    range.largest = std::max(range.largest, number());
  }
  return range;
}

/// A torsion spring on the angle of one body against the ground: a weld that gives way.
class TorsionSpring final : public ConstraintOf<TorsionSpring> {
 public:
  TorsionSpring(BodyId body, const Softness& softness) : body_(body), softness_(softness) {}
  std::string name() const override { return "torsion"; }
  List<Attachment> attachments() const override { return {{ground, {0, 0}}, {body_, {0, 0}}}; }
  template <Scalar Real>
  void rows(const Placements<Real>& at, RowWriter<Real>& rows) const {
    RowSpec<Real> row = angle_row<Real>(ground, body_, at[body_].angle);
    row.softness = softness_;
    rows.add(row);
  }

 private:
  BodyId body_;
  Softness softness_;
};

}  // namespace

TEST_CASE("an undamped spring keeps its amplitude for ten swings and more, level and under gravity") {
  for (const double gravity : {0.0, 10.0}) {
    CAPTURE(gravity);
    World world(
        bob_under(SwingSoftness{.frequency = swings_per_second}, {.gravity = {0, -gravity}, .substeps = 4}));
    const double sag = gravity / (omega * omega), amplitude = std::abs(0.25 - sag);
    const auto stretch = [&] { return -world.bodies().pose[{1}].position.y() - 2 - sag; };
    range_of(world, 9.5 / swings_per_second, stretch);
    const Range last = range_of(world, 1.1 / swings_per_second, stretch);
    // A turning point lies up to half a step of 1/60 s beside one that is seen; the first step is half a
    // substep late.
    const double unseen = 1 - std::cos(omega / 120), late = turn * turn / 8;
    CHECK(last.largest >= amplitude * (1 - unseen - 20 * pi * std::pow(turn, 5)));
    CHECK(last.largest <= amplitude * (1 + late + 1e-6));
    CHECK(-last.least >= amplitude * (1 - unseen - 20 * pi * std::pow(turn, 5)));
    CHECK(-last.least <= amplitude * (1 + late + 1e-6));
  }
}

TEST_CASE("two masses on one spring, and a torsion spring, keep kinetic energy and that of the spring") {
  for (const bool twists : {false, true}) {
    CAPTURE(twists);
    Scene scene({.gravity = {0, 0}, .substeps = 4});
    const BodyId a = scene.add({.shapes = {circle(0.1)}, .position = {0, 0}, .mass = 1, .inertia = 2});
    const Softness softness = SwingSoftness{.frequency = swings_per_second};
    if (twists) {
      scene.join(std::make_shared<TorsionSpring>(a, softness));
      displace(scene, a, {0, 0}, 0.5);
    } else {
      const BodyId b = scene.add({.shapes = {circle(0.1)}, .position = {1.5, 0}, .mass = 7});
      DistanceJoint::Spec spring = samples::spring(1, softness);
      spring.a = a;
      samples::hang(scene, b, {0, 0}, spring);
    }
    World world(scene);
    const double mass = twists ? 2 : 7.0 / 8;  // [kg m^2], [kg]: reduced
    const double start = mass * omega * omega * 0.5 * 0.5 / 2;
    CHECK(total_energy(snapshot(world)) == doctest::Approx(start).epsilon(1e-12));
    const Range energy =
        range_of(world, 10 / swings_per_second, [&] { return total_energy(snapshot(world)); });
    // Places are half a substep ahead of velocities: w h / 2 of the energy, there and back.
    CHECK(energy.largest <= start * (1 + 1.02 * turn / 2));
    CHECK(energy.least >= start * (1 - 1.02 * turn / 2));
  }
}

TEST_CASE("a damped swing fades by exp(-zeta w t), and a damper too strong for the step throws nothing") {
  for (const double zeta : {0.02, 0.1, 0.3}) {
    CAPTURE(zeta);
    World world(bob_under(SwingSoftness{.frequency = swings_per_second, .damping_ratio = zeta},
                          {.gravity = {0, 0}, .substeps = 4}));
    SequentialImpulse<double> solver({.iterations = 1});
    for (int step = 1; step <= 60; ++step) {
      world.step(solver);
      const Snapshot now = snapshot(world);
      // Where it was in the middle of the last substep, with the velocity that it had there.
      const double x = -now.bodies[{1}].pose.position.y() - 2 + now.dt / 2 * now.bodies[{1}].velocity.y();
      const double v = -now.bodies[{1}].velocity.y(), damped = omega * std::sqrt(1 - zeta * zeta);
      const double envelope = std::hypot(x, (v + zeta * omega * x) / damped);
      const double expected = 0.25 / std::sqrt(1 - zeta * zeta) * std::exp(-zeta * omega * step / 60);
      CHECK(envelope == doctest::Approx(expected).epsilon(0.01));
    }
  }
  World stiff(bob_under(SwingSoftness{.frequency = 1e4, .damping_ratio = 100}, {.gravity = {0, 0}}));
  const Range stretch = range_of(stiff, 1, [&] { return -stiff.bodies().pose[{1}].position.y() - 2; });
  CHECK(stretch.least >= 0);
}

TEST_CASE("no spring is too stiff: what the step can follow is kept, what it cannot comes back and stays") {
  for (const double turn_of_step : {1e-3, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 1e3, 1e6}) {
    CAPTURE(turn_of_step);
    const double dt = turn_of_step > 1e4 ? 1 : 1.0 / 60;  // no spring may swing more often than 1e6 Hz
    World world(
        bob_under(SwingSoftness{.frequency = turn_of_step / dt / (2 * pi)}, {.gravity = {0, 0}, .dt = dt}));
    const auto stretch = [&] {  // in the middle of the step
      return -world.bodies().pose[{1}].position.y() - 2 +
             world.clock().dt / 2 * world.bodies().velocity[{1}].y();
    };
    const Range all = range_of(world, 10, stretch);
    CHECK(std::max(all.largest, -all.least) <= 0.25 * (1 + 1e-12));
    const Range end = range_of(world, 1, stretch);
    if (turn_of_step >= 1) CHECK(std::max(end.largest, -end.least) <= 1e-12);
    if (turn_of_step == 0.1) CHECK(std::max(end.largest, -end.least) >= 0.99 * 0.25);
  }
}

TEST_CASE("springs off the middle of a turning body keep its energy, by frequency and by stiffness") {
  for (const bool by_frequency : {false, true}) {
    Scene scene({.substeps = 4});
    const BodyId bar = scene.add({.shapes = {box(1, 0.1)}, .position = {0.5, 0}, .mass = 1});
    const Softness soft = SpringSoftness{.stiffness = 90}, swing = SwingSoftness{.frequency = 1.5};
    for (const double x : {0.0, 0.9})
      scene.join<DistanceJoint>({.a = ground,
                                 .b = bar,
                                 .anchor_a = {x, 1},
                                 .anchor_b = {x, 0},
                                 .length = 0.8,
                                 .kind = DistanceJoint::Kind::spring,
                                 .softness = by_frequency ? swing : soft});
    World world(scene);
    const double start = total_energy(snapshot(world));
    const Range energy = range_of(world, 20, [&] { return total_energy(snapshot(world)) - start; });
    const double scale = 1 * 10 * 0.5;  // [J] of a fall by about what it swings
    CHECK(energy.largest <= 0.03 * scale);
    CHECK(energy.least >= -0.03 * scale);
  }
}

TEST_CASE("a slack rubber rope holds nothing, a taut one k C^2 / 2, and a hand what its limit gives back") {
  const double stiffness = 300;
  const auto energy_at = [&](double place, std::optional<double> most) {
    Scene scene;
    const BodyId bob = scene.add({.shapes = {circle(0.1)}, .position = {0, -place}, .mass = 70});
    const SpringSoftness rubber{.stiffness = stiffness};
    if (most)
      scene.join<DragJoint>(
          {.body = bob, .anchor = {0, -place}, .target = {0, 0}, .softness = rubber, .max_force = *most});
    else
      samples::hang(scene, bob, {0, 0}, samples::rope(5, rubber));
    return snapshot(World<double>(scene)).joints[0].energy;
  };
  CHECK(energy_at(4.8, {}) == 0);
  CHECK(energy_at(7, {}) == doctest::Approx(stiffness * 2 * 2 / 2).epsilon(1e-12));
  CHECK(energy_at(2, 1e6) == doctest::Approx(stiffness * 2 * 2 / 2).epsilon(1e-12));
  // 150 N are reached at 0.5 m; from there on the force is the same.
  CHECK(energy_at(2, 150) == doctest::Approx(stiffness * 0.25 / 2 + 150 * 1.5).epsilon(1e-12));
}

TEST_CASE("a jump on a rubber rope comes back up to where it began, again and again") {
  Scene scene({.substeps = 4});
  const BodyId bob = scene.add({.shapes = {circle(0.1)}, .position = {0, -1}, .mass = 70});
  samples::hang(scene, bob, {0, 0}, samples::rope(5, SpringSoftness{.stiffness = 300}));
  World world(scene);
  range_of(world, 20, [] { return 0.0; });
  const Range height = range_of(world, 10, [&] { return world.bodies().pose[{1}].position.y(); });
  const double lowest =
      -5 - 70 * 10 / 300.0 - std::sqrt(std::pow(70 * 10 / 300.0, 2) + 2 * 70 * 10 * 4 / 300.0);
  CHECK(height.largest == doctest::Approx(-1).epsilon(0.02 * 11));  // of the way there and back
  CHECK(height.least == doctest::Approx(lowest).epsilon(0.02));
}
