// Momentum of bodies that only have each other, and discs that pass it on along a line.
#include <random>

#include "geometry/shape.hpp"
#include "measure/energy.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

const double drum_radius = 3;  // [m] of its inner side
const int drum_discs = 20;

/// The wall of a drum: 12 planks around the origin.
std::vector<Shape<double>> drum_wall() {
  const int planks = 12;
  const double length = 2 * (drum_radius + 0.5) * std::tan(pi / planks);
  std::vector<Shape<double>> shapes;
  for (int i = 0; i < planks; ++i) {
    const double angle = 2 * pi * i / planks;
    const Vec2<double> middle = (drum_radius + 0.25) * Vec2<double>(std::cos(angle), std::sin(angle));
    shapes.push_back(moved(box(0.5, length), middle, angle));
  }
  return shapes;
}

/// 20 elastic, rough discs that fly about in a drum, which floats freely itself, so that they never stop
/// hitting each other. Masses and inertias are powers of two: then 1 / m is exact in every number type, and
/// nothing but the rounding of sums can change a momentum.
Scene discs_in_drum() {
  Scene scene({.gravity = {0, 0}});
  scene.add({.shapes = drum_wall(), .mass = 16, .inertia = 128, .friction = 0.5, .restitution = 1});
  std::mt19937 random(20);
  const auto uniform = [&random] { return static_cast<double>(random()) / 4294967296.0; };  // in [0, 1)
  for (int i = 0; i < drum_discs; ++i) {
    const Vec2<double> place(-1.6 + 0.8 * (i % 5), -1.2 + 0.8 * (i / 5));
    scene.add({.shapes = {circle(0.25)},
               .position = place,
               .velocity = {4 * uniform() - 1, 4 * uniform() - 2},
               .angular_velocity = 4 * uniform(),
               .mass = i % 2 == 0 ? 1.0 : 0.5,
               .inertia = 1.0 / 32,
               .friction = 0.5,
               .restitution = 1});
  }
  return scene;
}

/// What momenta are made of, each with its size: sum m |v| and sum (m |x| |v| + I |w|).
Vec3<double> momentum_scale(const Snapshot& snapshot) {
  Vec3<double> sum = Vec3<double>::Zero();
  for (const SnapshotBody& body : snapshot.bodies) {
    const double p = body.mass * body.velocity.head<2>().norm();
    const double spin = body.inertia * std::abs(body.velocity.z());
    sum += Vec3<double>(p, p, body.pose.position.norm() * p + spin);
  }
  return sum;
}

/// Discs of radius 0.2 m on a line with 0.3 m between them: more than any of them goes in a step. The first
/// comes at 2 m/s.
World<double> cradle_with_gaps(const std::vector<double>& masses, double restitution) {
  Scene scene({.gravity = {0, 0}});
  double x = 0;
  for (const double mass : masses) {
    scene.add({.shapes = {circle(0.2)},
               .position = {x, 0},
               .velocity = {x > 0 ? 0.0 : 2.0, 0},
               .mass = mass,
               .restitution = restitution});
    x += 0.7;
  }
  return World(scene);
}

double speed_in_row(const World<double>& world, std::size_t place) {
  return world.bodies().velocity[place + 1].x();
}

}  // namespace

// B2
TEST_CASE_TEMPLATE("20 discs that collide in a floating drum keep their momenta over 10 000 steps", Real,
                   float, double) {
  World<Real> world(discs_in_drum());
  SequentialImpulse<Real> solver({.iterations = 10});
  const Vec3<double> start = momentum(snapshot(world));
  Vec3<double> scale = momentum_scale(snapshot(world));
  REQUIRE(start.cwiseAbs().minCoeff() > 0.01 * scale.maxCoeff());  // all three have something to lose
  double updates = 0;
  int late_contacts = 0;
  for (int step = 0; step < 10000; ++step) {
    const StepReport report = world.step(solver);
    updates += 10.0 * report.rows;
    if (step >= 9000) late_contacts += report.contacts;
    if (step % 500 == 499) scale = scale.cwiseMax(momentum_scale(snapshot(world)));
  }
  CHECK(late_contacts > 100);  // they still collide
  // An update rounds the velocities of two bodies by up to epsilon / 2 either way, 0.29 epsilon on average:
  // five times the deviation of the sum of so many. For a double it is 8e-13.
  const double epsilon = static_cast<double>(std::numeric_limits<Real>::epsilon());
  const double tolerance = 5 * 0.29 * std::sqrt(2 * updates) * epsilon;
  const Vec3<double> change = momentum(snapshot(world)) - start;
  for (int i = 0; i < 3; ++i) CHECK(std::abs(change[i]) <= tolerance * scale[i]);
}

// B42
TEST_CASE("along a row of equal elastic discs with gaps one after the other takes all of the speed") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const std::size_t n : {2u, 3u, 5u, 8u}) {
      World world = cradle_with_gaps(std::vector<double>(n, 1.0), 1);
      const auto solver = make({.iterations = 5});
      std::size_t moving = 0;
      for (int step = 0; step < 100; ++step) {  // 8 discs are hit every 8 or 9 steps
        world.step(*solver);
        // Nobody has moved between two hits but the last one to be hit.
        if (moving + 1 < n && speed_in_row(world, moving) < 1) ++moving;
        for (std::size_t i = 0; i < n; ++i) {
          CHECK(std::abs(speed_in_row(world, i) - (i == moving ? 2 : 0)) <= 1e-12);
        }
      }
      CHECK(moving + 1 == n);
    }
  }
}

// B42
TEST_CASE("along a row of ever lighter elastic discs with gaps the speed grows by 2 / (1 + r) at each hit") {
  const int n = 6;
  for (const double r : {0.5, 0.8}) {  // each disc has r times the mass of the one before
    std::vector<double> masses;
    for (int i = 0; i < n; ++i) masses.push_back(std::pow(r, i));
    World world = cradle_with_gaps(masses, 1);
    SequentialImpulse<double> solver({.iterations = 5});
    run(world, solver, 2);
    // A disc keeps (1 - r) / (1 + r) of its speed: it follows, and is slower than the next one.
    double speed = 2;
    for (int i = 0; i + 1 < n; ++i) {
      CHECK(velocity_of(world, {i + 1}).x() == doctest::Approx(speed * (1 - r) / (1 + r)).epsilon(1e-12));
      speed *= 2 / (1 + r);
    }
    CHECK(velocity_of(world, {n}).x() == doctest::Approx(speed).epsilon(1e-12));
  }
}
