// How chains swing: small modes against eigenvalues, springs against implicit Euler, and wide swings against
// the energy that they must keep.
#include "constraints/distance_joint.hpp"
#include "constraints/revolute_joint.hpp"
#include "measure/energy.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double chain_link = 0.5;    // [m]
const double chain_angle = 1e-3;  // [rad] about how far links are tilted at the start

/// The Laguerre polynomials L_0(x) to L_n(x). A hanging chain of n equal beads on equal links l swings with
/// w^2 = x g / l where L_n(x) = 0, and bead k, counted from its lower end, goes out by L_k(x).
std::vector<double> laguerre(int n, double x) {
  std::vector<double> value = {1, 1 - x};
  for (int k = 1; k < n; ++k) {
    const double next = ((2 * k + 1 - x) * value.back() - k * value[value.size() - 2]) / (k + 1);
    value.push_back(next);
  }
  return value;
}

/// The zero of L_n between two places that have one between them.
double laguerre_zero(int n, double lower, double upper) {
  const bool rises = laguerre(n, lower)[static_cast<std::size_t>(n)] < 0;
  for (int i = 0; i < 100; ++i) {
    const double middle = (lower + upper) / 2;
    const bool below = laguerre(n, middle)[static_cast<std::size_t>(n)] < 0;
    (below == rises ? lower : upper) = middle;
  }
  return (lower + upper) / 2;
}

/// The slowest mode: the smallest zero is near j^2 / (4 n + 2), with j = 2.4048 the first zero of J_0.
double slowest_zero(int n) { return laguerre_zero(n, 0, 1.2 * 2.4048 * 2.4048 / (4 * n + 2)); }

/// n beads of 1 kg on massless rods under the origin, at rest in the shape of the mode of this zero.
World<double> chain_in_mode(int n, double zero, double frequency) {
  Scene scene({.dt = 1 / frequency});
  const std::vector<double> shape = laguerre(n, zero);
  const double amplitude = chain_angle * chain_link / zero;  // L_0 - L_1 = x: the lowest link
  BodyId above = ground;
  Vec2<double> anchor = {0, 0};
  for (int i = n - 1; i >= 0; --i) {
    const double x = amplitude * shape[static_cast<std::size_t>(i)];
    const double step = x - anchor.x();
    const Vec2<double> place(x, anchor.y() - std::sqrt(chain_link * chain_link - step * step));
    const BodyId bead = scene.add({.position = place, .mass = 1, .fixed_rotation = true});
    scene.join<DistanceJoint>({.a = above, .b = bead, .anchor_a = anchor, .anchor_b = place});
    above = bead;
    anchor = place;
  }
  return World(scene);
}

/// From the first to the last of 11 passages of the lowest bead through the vertical, which are five periods:
/// the frequency w [rad/s].
double measured_frequency(World<double>& world, Solver<double>& solver) {
  std::vector<double> passages;
  while (passages.size() < 11 && world.time() < 60) {
    const double before = world.bodies().pose.back().position.x();
    world.step(solver);
    const double after = world.bodies().pose.back().position.x();
    if (before * after <= 0) passages.push_back(world.time() - world.dt() * after / (after - before));
  }
  REQUIRE(passages.size() == 11);
  return 10 * pi / (passages.back() - passages.front());
}

/// Semi-implicit Euler swings with 2 / dt asin(w dt / 2) where it should swing with w.
double semi_implicit_frequency(double omega, double dt) { return 2 / dt * std::asin(omega * dt / 2); }

/// Two equal thin rods of 1 m and 1 kg, the one at the end of the other, let go from the horizontal.
World<double> double_pendulum(double frequency, double baumgarte) {
  Scene scene({.dt = 1 / frequency, .stabilization = {.baumgarte = baumgarte}});
  const BodyId first = scene.add({.position = {0.5, 0}, .mass = 1, .inertia = 1.0 / 12});
  const BodyId second = scene.add({.position = {1.5, 0}, .mass = 1, .inertia = 1.0 / 12});
  scene.join<RevoluteJoint>({.a = ground, .b = first, .anchor = {0, 0}});
  scene.join<RevoluteJoint>({.a = first, .b = second, .anchor = {1, 0}});
  return World(scene);
}

struct EnergyRange {
  double last = 0;     // [J] above the start
  double highest = 0;  // [J] the most above the start
};

/// The energy of a double pendulum, which starts with 0 J. Velocities belong to the middle of a step, so the
/// kinetic energy at its end is the mean of those of this step and the next.
EnergyRange pendulum_energy(double frequency, double baumgarte, double seconds) {
  World world = double_pendulum(frequency, baumgarte);
  SequentialImpulse<double> solver({.iterations = 500, .tolerance = 1e-12});
  EnergyRange energy;
  const int steps = static_cast<int>(std::lround(seconds * frequency));
  for (int step = 0; step < steps; ++step) {
    world.step(solver);
    const Snapshot now = snapshot(world);
    World next = world;
    next.step(solver);
    energy.last = potential_energy(now) + (kinetic_energy(now) + kinetic_energy(snapshot(next))) / 2;
    energy.highest = std::max(energy.highest, energy.last);
  }
  return energy;
}

/// Five beads of 1 kg between two walls, on six springs of 1 N/m, in the shape of mode k: w = 2 sin(k pi /
/// 12).
World<double> spring_chain(int mode, double amplitude, double dt) {
  const int n = 5;
  Scene scene({.gravity = {0, 0}, .dt = dt});
  const SpringSoftness spring{.stiffness = 1};
  BodyId left = ground;
  Vec2<double> anchor = {0, 0};
  for (int i = 1; i <= n + 1; ++i) {
    const Vec2<double> place(i + amplitude * std::sin(i * mode * pi / (n + 1)), 0);
    const Vec2<double> end = i <= n ? place : Vec2<double>(n + 1, 0);
    const BodyId bead = i <= n ? scene.add({.position = place, .mass = 1, .fixed_rotation = true}) : ground;
    scene.join<DistanceJoint>({.a = left,
                               .b = bead,
                               .anchor_a = anchor,
                               .anchor_b = end,
                               .length = 1,
                               .kind = DistanceJoint::Kind::spring,
                               .softness = spring});
    left = bead;
    anchor = end;
  }
  return World(scene);
}

}  // namespace

// B17
TEST_CASE("a double pendulum of two equal masses swings with w^2 = (2 -+ sqrt(2)) g / l") {
  for (const double zero : {2 - std::sqrt(2.0), 2 + std::sqrt(2.0)}) {
    const double omega = std::sqrt(zero * test_gravity / chain_link);
    for (const double frequency : {60.0, 240.0}) {
      World world = chain_in_mode(2, zero, frequency);
      SequentialImpulse<double> solver({.iterations = 200});
      const double measured = measured_frequency(world, solver);
      // Angles of 1e-3 change a frequency by their square, and where a passage is interpolated, by less than
      // (w dt)^3 / 10 of a step in five periods.
      const double turn = omega / frequency;
      const double tolerance = chain_angle * chain_angle + std::pow(turn, 4) / (100 * pi);
      CHECK(std::abs(measured / semi_implicit_frequency(omega, 1 / frequency) - 1) <= tolerance);
      if (frequency > 200) CHECK(measured == doctest::Approx(omega).epsilon(0.005));
    }
  }
}

// B26
TEST_CASE("a hanging chain of n beads swings with the smallest zero of the Laguerre polynomial L_n") {
  for (const int n : {5, 10, 20}) {
    const double omega = std::sqrt(slowest_zero(n) * test_gravity / chain_link);
    World world = chain_in_mode(n, slowest_zero(n), 60);
    AcceleratedProjectedGaussSeidel<double> solver({.iterations = 2000, .tolerance = 1e-10});
    const double measured = measured_frequency(world, solver);
    const double tolerance = chain_angle * chain_angle + std::pow(omega / 60, 4) / (100 * pi);
    CHECK(std::abs(measured / semi_implicit_frequency(omega, test_dt) - 1) <= tolerance);
    // A rope has 1.2024 sqrt(g / L), half the first zero of J_0; n beads have 1 / 4n less.
    const double rope = 2.404825557695773 / 2 * std::sqrt(test_gravity / (n * chain_link));
    CHECK(measured / rope - 1 == doctest::Approx(-0.25 / n).epsilon(1.0 / n));
  }
  CHECK(std::sqrt(50 * slowest_zero(50)) == doctest::Approx(1.19646).epsilon(1e-5));
}

// B27
TEST_CASE("five beads on springs swing in mode k with w = 2 sqrt(k / m) sin(k pi / 12), as implicit Euler") {
  const double amplitude = 0.1, dt = 0.02;
  for (int mode = 1; mode <= 5; ++mode) {
    const double omega = 2 * std::sin(mode * pi / 12), turn = omega * dt;
    World world = spring_chain(mode, amplitude, dt);
    SequentialImpulse<double> solver({.iterations = 50});
    double x = 1, v = 0;  // of the mode
    double quarter = 0;   // [s] until it first passes its middle
    for (int step = 0; step < 500; ++step) {
      world.step(solver);
      v = (v - dt * omega * omega * x) / (1 + turn * turn);
      const double before = x;
      x += dt * v;
      if (quarter == 0 && x <= 0) quarter = world.time() - dt * x / (x - before);
      for (int i = 1; i <= 5; ++i) {
        const double place = i + amplitude * x * std::sin(i * mode * pi / 6);
        // Neighbours share k dt^2 / (1 + 2 k dt^2) of an impulse: 50 sweeps leave rounding of lengths of 6 m.
        CHECK(std::abs(pose_of(world, {i}).position.x() - place) <= 64 * 6 * double_epsilon * (step + 1));
      }
    }
    // It turns by atan(w dt) in a step, not by w dt; its first step comes from rest, a whole turn late.
    CHECK(quarter == doctest::Approx(pi / 2 / omega).epsilon(1.5 * turn * 2 / pi));
  }
}

// B28
TEST_CASE("a spring with a damper converges to the continuous damped swing like dt") {
  const double swing = 0.2, omega = 2 * pi * swing, t = 2;  // [Hz], [rad/s], [s]
  for (const double zeta : {0.0, 0.2}) {
    const double damped = omega * std::sqrt(1 - zeta * zeta);
    const double ideal = 0.25 * std::exp(-zeta * omega * t) *
                         (std::cos(damped * t) + zeta / std::sqrt(1 - zeta * zeta) * std::sin(damped * t));
    check_first_order([=](double frequency) {
      Scene scene({.gravity = {0, 0}, .dt = 1 / frequency});
      const BodyId bob = scene.add({.position = {2.25, 0}, .mass = 3, .fixed_rotation = true});
      scene.join<DistanceJoint>({.a = ground,
                                 .b = bob,
                                 .anchor_b = {2.25, 0},
                                 .length = 2,
                                 .kind = DistanceJoint::Kind::spring,
                                 .softness = SwingSoftness{.frequency = swing, .damping_ratio = zeta}});
      World world(scene);
      SequentialImpulse<double> solver({.iterations = 1});
      run(world, solver, t);
      return pose_of(world, bob).position.x() - 2 - ideal;
    });
  }
}

// B16
TEST_CASE("without stabilization a double pendulum loses energy like dt") {
  check_first_order([](double frequency) { return pendulum_energy(frequency, 0, 1).last; });
}

// B16
TEST_CASE("with Baumgarte stabilization a double pendulum's loss shrinks like dt^2 or faster") {
  // What a step takes out of the energy because its rows turn, -impulse times j v / 2, the stretch that
  // Baumgarte leaves in the joints gives back, once it is steady: the errors of first order cancel.
  double coarse = -pendulum_energy(60, 0.2, 1).last;
  for (const double frequency : {120.0, 240.0, 480.0}) {
    const double fine = -pendulum_energy(frequency, 0.2, 1).last;
    CAPTURE(frequency);
    CHECK(fine > 0);
    CHECK(fine <= coarse / 4);
    coarse = fine;
  }
}

// B16
TEST_CASE("a double pendulum never swings higher than it started, in ten seconds of tumbling") {
  for (const double baumgarte : {0.0, 0.2}) {
    for (const double frequency : {60.0, 240.0}) {
      // It starts from rest, where a velocity of the middle of a step is not one yet: (g dt)^2 for two rods.
      const double start = 2 * std::pow(test_gravity / frequency, 2) / 2;
      CHECK(pendulum_energy(frequency, baumgarte, 10).highest <= start);
    }
  }
}
