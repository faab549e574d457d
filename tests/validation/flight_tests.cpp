// Flight, collisions and bounces, against their formulas: those of the discrete steps where they exist.
#include "geometry/shape.hpp"
#include "problems.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

struct BallSpec {
  double restitution = 1;
  double height = 1;      // [m] of its lowest point
  double frequency = 60;  // [1/s] steps
  double margin = 0.02;   // [m] speculative
};

const double ball_radius = 0.25;  // [m]

World<double> dropped_ball(const BallSpec& spec) {
  Scene scene({.dt = 1 / spec.frequency, .speculative_margin = spec.margin, .restitution_threshold = 0});
  scene.add_ground();
  scene.add({.shapes = {circle(ball_radius)},
             .position = {0, spec.height + ball_radius},
             .mass = 1,
             .restitution = spec.restitution});
  return World(scene);
}

double height_of_ball(const World<double>& world) {
  return world.bodies().pose[1].position.y() - ball_radius;
}
double speed_of_ball(const World<double>& world) { return world.bodies().velocity[1].y(); }

/// The highest points after each of the first `count` bounces [m].
std::vector<double> apexes(const BallSpec& spec, std::size_t count) {
  World world = dropped_ball(spec);
  SequentialImpulse<double> solver;
  std::vector<double> result;
  double before = 0;
  while (result.size() < count && world.time() < 60) {
    world.step(solver);
    if (speed_of_ball(world) < 0 && before > 0) result.push_back(height_of_ball(world));
    before = speed_of_ball(world);
  }
  return result;
}

/// v^2 / 2 + g y - g dt v / 2, for a ball of 1 kg [J]: what a step of v -= g dt, y += v dt keeps exactly.
double discrete_energy(const World<double>& world) {
  const double v = speed_of_ball(world);
  return v * v / 2 + test_gravity * height_of_ball(world) - test_gravity * world.dt() * v / 2;
}

struct ObliqueHit {
  Vec2<double> first = {0, 0};   // [m/s] of the disc that came
  Vec2<double> second = {0, 0};  // [m/s] of the disc that was at rest
};

/// A disc of radius 0.5 m that comes at 2 m/s along x hits an equal one whose centre is `offset` higher.
ObliqueHit oblique_hit(double offset, double frequency) {
  Scene scene({.gravity = {0, 0}, .dt = 1 / frequency});
  const BodySpec disc{.shapes = {circle(0.5)}, .mass = 1, .friction = 0, .restitution = 1};
  BodySpec coming = disc, waiting = disc;
  coming.position = {-2, 0};
  coming.velocity = {2, 0};
  waiting.position = {0, offset};
  const BodyId first = scene.add(coming);
  const BodyId second = scene.add(waiting);
  World world(scene);
  SequentialImpulse<double> solver;
  run(world, solver, 1.5);
  return {velocity_of(world, first).head<2>(), velocity_of(world, second).head<2>()};
}

}  // namespace

// B1
TEST_CASE("a thrown body follows y0 + v0 t - g t^2 / 2 - g t dt / 2, exactly") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    for (const double frequency : {30.0, 60.0, 120.0}) {
      Scene scene({.dt = 1 / frequency});
      const BodyId ball = scene.add({.shapes = {circle(1)},
                                     .position = {1, 2},
                                     .angle = 0.5,
                                     .velocity = {3, 4},
                                     .angular_velocity = 2});
      World world(scene);
      const auto solver = make({});
      const double t = 2;
      run(world, *solver, t);
      const double g = test_gravity;
      const double y = 2 + 4 * t - g * t * t / 2 - g * t * world.dt() / 2;
      // Each of up to 240 steps rounds numbers below 20 twice.
      const double tolerance = 2 * 20 * double_epsilon * world.steps();
      CHECK(std::abs(pose_of(world, ball).position.x() - (1 + 3 * t)) <= tolerance);
      CHECK(std::abs(pose_of(world, ball).position.y() - y) <= tolerance);
      CHECK(std::abs(pose_of(world, ball).angle - (0.5 + 2 * t)) <= tolerance);
      CHECK(std::abs(velocity_of(world, ball).y() - (4 - g * t)) <= tolerance);
    }
  }
}

// B1
TEST_CASE("the height of a falling body converges to the parabola like dt") {
  check_first_order([](double frequency) {
    Scene scene({.dt = 1 / frequency});
    scene.add({.shapes = {circle(1)}, .velocity = {0, 4}});
    World world(scene);
    SequentialImpulse<double> solver;
    run(world, solver, 2);
    return world.bodies().pose[1].position.y() - (4 * 2.0 - test_gravity * 2);
  });
}

// B3
TEST_CASE("two equal elastic discs part at a right angle when one was at rest") {
  const double radius = 0.5, speed = 2;
  for (const double offset : {0.2, 0.5, 0.8}) {
    for (const double frequency : {60.0, 240.0}) {
      const ObliqueHit hit = oblique_hit(offset, frequency);
      // (v - (v.n) n) . (v.n) n = 0 whatever n is: no integration error, only rounding of 2 m/s squared.
      CHECK(std::abs(hit.first.dot(hit.second)) <= 64 * double_epsilon * speed * speed);
      CHECK(hit.first.squaredNorm() + hit.second.squaredNorm() ==
            doctest::Approx(speed * speed).epsilon(1e-14));
      // The normal is that of the step's begin, when the disc was up to v dt short of the other.
      const double direction = std::atan2(hit.second.y(), hit.second.x());
      CHECK(std::abs(direction - std::asin(offset / (2 * radius))) <= 2 * speed / frequency / radius);
    }
  }
}

// B4
TEST_CASE("a ball that keeps e of its speed rises to e^2 of its height at each bounce") {
  const double e = 0.8, h = 1;
  for (const double frequency : {60.0, 960.0}) {
    const double fall_speed = std::sqrt(2 * test_gravity * h);
    const double tolerance = fall_speed / frequency * (1 + e);  // it turns up to v dt above the ground
    const std::vector<double> tops = apexes({.restitution = e, .height = h, .frequency = frequency}, 5);
    REQUIRE(tops.size() == 5);
    double expected = h;
    for (const double top : tops) {
      expected *= e * e;
      CHECK(std::abs(top - expected) <= tolerance);
    }
  }
}

// B4
TEST_CASE("a ball bounces infinitely often in sqrt(2 h / g) (1 + e) / (1 - e), and then lies still") {
  const double e = 0.8, h = 1;
  const double expected = std::sqrt(2 * h / test_gravity) * (1 + e) / (1 - e);
  struct Case {
    double frequency;
    double tolerance;  // of the time: bounces shorter than a step are lost, and each turns up to dt early
  };
  for (const Case& row : {Case{60, 0.1}, Case{960, 0.02}}) {
    World world = dropped_ball({.restitution = e, .height = h, .frequency = row.frequency});
    SequentialImpulse<double> solver;
    double last_bounce = 0;
    while (world.time() < 2 * expected) {
      world.step(solver);
      if (speed_of_ball(world) > test_gravity * world.dt()) last_bounce = world.time();
    }
    CHECK(last_bounce == doctest::Approx(expected).epsilon(row.tolerance));
    // A ball slower than g dt comes down within four steps, and still keeps e of its speed each time.
    const double steps = (world.time() - last_bounce) * row.frequency;
    const double tremble = test_gravity * world.dt() * std::pow(e, steps / 4);
    const double rounding = 8 * double_epsilon;  // [m] of heights below 1 m
    CHECK(std::abs(height_of_ball(world)) <= tremble * world.dt() + rounding);
    CHECK(std::abs(speed_of_ball(world)) <= tremble + rounding / world.dt());
  }
}

// B4
TEST_CASE("an elastic ball keeps its discrete energy for a minute of bouncing") {
  for (const SolverMaker<double>& make : all_solvers<double>()) {
    World world = dropped_ball({.restitution = 1});
    const auto solver = make({});
    const double start = discrete_energy(world);
    double largest_gap = 0;
    int bounces = 0;
    double before = 0;
    for (int step = 0; step < 3600; ++step) {
      world.step(*solver);
      largest_gap = std::max(largest_gap, std::abs(discrete_energy(world) - start));
      bounces += speed_of_ball(world) > 0 && before < 0;
      before = speed_of_ball(world);
    }
    CHECK(bounces > 60);  // a bounce lasts 2 sqrt(2 h / g) = 0.89 s
    // A step rounds v and y, at most 4.5, a few times each: 16 epsilon of g h = 10 J.
    CHECK(largest_gap <= 16 * double_epsilon * 3600 * start);
  }
}

// A contact that is foreseen must not brake the ball before it bounces.
TEST_CASE("a ball bounces as high with a wide speculative margin as without one") {
  for (const double e : {0.8, 1.0}) {
    for (const double frequency : {60.0, 240.0}) {
      const double tolerance = std::sqrt(2 * test_gravity) / frequency * (1 + e);
      const double without = apexes({.restitution = e, .frequency = frequency, .margin = 0}, 1).at(0);
      for (const double margin : {0.02, 0.1, 0.5}) {
        const double with = apexes({.restitution = e, .frequency = frequency, .margin = margin}, 1).at(0);
        CHECK(std::abs(with - without) <= tolerance);
      }
    }
  }
}
