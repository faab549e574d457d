// Forces that turn with what they hold: light links under heavy loads, on pins and over discs, at rest and
// when they get tight; and what swings on a rope.
#include <numbers>

#include <cairn/samples/samples.hpp>
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

constexpr double thin = 0.008;  // [m] of a link of a string: past that a joint has failed

struct Gaps {
  double worst = 0;  // [m] of a joint
  double gain = 0;   // [J] of energy above the start
};

Gaps gaps_of(const Scene& scene, Solver<double>& solver, double seconds) {
  World<double> world(scene);
  const double start = total_energy(snapshot(world));
  Gaps gaps;
  for (int step = 0; step < std::lround(60 * seconds); ++step) {
    world.step(solver);
    const Snapshot now = snapshot(world);
    gaps.worst = std::max(gaps.worst, worst_joint_drift(now));
    gaps.gain = std::max(gaps.gain, total_energy(now) - start);
  }
  return gaps;
}

/// Planks of 0.1 kg between two walls, each on a rod of 0.2 m from the one before; one of them is heavier.
Scene plank_bridge(double heavy, int substeps) {
  Scene scene({.substeps = substeps});
  BodyId before = ground;
  Vec2<double> end = {0, 0};
  for (int i = 0; i < 6; ++i) {
    const BodyId plank = scene.add({.shapes = {box(0.8, 0.1)},
                                    .position = {0.6 + i, 0},
                                    .mass = i == 2 ? heavy : 0.1,
                                    .filter = {.collides_with = 0}});
    scene.join<DistanceJoint>(
        {.a = before, .b = plank, .anchor_a = end, .anchor_b = Vec2<double>(0.2 + i, 0)});
    end = {1.0 + i, 0};
    before = plank;
  }
  scene.join<DistanceJoint>(
      {.a = before, .b = ground, .anchor_a = end, .anchor_b = end + Vec2<double>(0.2, 0)});
  return scene;
}

/// Links of 1 kg on pins, level, between two walls.
Scene chain_between_walls(int links, int substeps) {
  Scene scene({.substeps = substeps});
  const List<BodyId> chain = samples::add_chain(
      scene, links, {.shapes = {box(0.5, 0.1)}, .position = {0.25, 0}, .mass = 1}, {0.5, 0});
  scene.join<RevoluteJoint>({.a = chain.back(), .b = ground, .anchor = {0.5 * links, 0}});
  return scene;
}

/// Links of 10 g, 8 mm thick, and pins between them, through these points.
List<BodyId> string_of_links(Scene& scene, const List<Vec2<double>>& points, double radius) {
  List<BodyId> links;
  for (int i = 0; i + 1 < points.size(); ++i) {
    const Vec2<double> span = points[i + 1] - points[i];
    links.push_back(scene.add({.shapes = {capsule({-span.norm() / 2, 0}, {span.norm() / 2, 0}, radius)},
                               .position = (points[i] + points[i + 1]) / 2,
                               .angle = std::atan2(span.y(), span.x()),
                               .mass = 0.01,
                               .material = {.friction = 0}}));
    if (i > 0) scene.join<RevoluteJoint>({.a = links[i - 1], .b = links[i], .anchor = points[i]});
  }
  return links;
}

/// A string that hangs in folds, with a load at its end.
Scene folded_string(double load, int substeps) {
  Scene scene({.substeps = substeps});
  List<Vec2<double>> points = {{0, 0}};
  for (int i = 0; i < 10; ++i)
    points.push_back(points[i] + 0.1 * Vec2<double>((i % 2 == 0 ? 1 : -1) * std::sin(0.3), -std::cos(0.3)));
  const List<BodyId> links = string_of_links(scene, points, thin / 2);
  scene.join<RevoluteJoint>({.a = ground, .b = links[0], .anchor = points[0]});
  const BodyId bob = scene.add({.position = points[10], .mass = load, .fixed_rotation = true});
  scene.join<RevoluteJoint>({.a = links[9], .b = bob, .anchor = points[10]});
  return scene;
}

/// The upper half of a disc of 1 m, and a string with a load at each end that begins 2 cm above it.
Scene string_over_disc(double load, int substeps) {
  Scene scene({.substeps = substeps});
  scene.add({.type = BodyType::static_body, .shapes = {circle(1)}, .material = {.friction = 0}});
  List<Vec2<double>> points;
  constexpr int links = 24;
  for (int i = 0; i <= links; ++i) {
    const double turn = std::numbers::pi * i / links;
    points.push_back(1.02 * Vec2<double>(-std::cos(turn), std::sin(turn)));
  }
  const List<BodyId> string = string_of_links(scene, points, thin / 2);
  for (const int end : {0, links}) {
    const BodyId bob = scene.add({.position = points[end], .mass = load, .fixed_rotation = true});
    scene.join<RevoluteJoint>({.a = string[end == 0 ? 0 : links - 1], .b = bob, .anchor = points[end]});
  }
  return scene;
}

/// A string holds so many loads of 1 to 100 kg under an exact solver.
void check_holds(Scene (*make)(double, int), std::initializer_list<int> substeps, int loads) {
  for (const double load : {1.0, 10.0, 100.0}) {
    for (const int count : substeps) {
      CAPTURE(load);
      CAPTURE(count);
      NewtonSolver<double> newton({.iterations = 20});
      const Gaps gaps = gaps_of(make(load, count), newton, 2);
      CHECK(gaps.worst <= thin);
      CHECK(gaps.gain <= 0.01 * loads * load * 10);  // [J] as of a centimetre of its fall
    }
  }
}

}  // namespace

TEST_CASE("light planks carry a heavy one under an exact solver, with one substep and with four") {
  for (const auto& bridge : {std::pair(1.0, 1), {1.0, 4}, {10.0, 1}, {10.0, 4}, {100.0, 4}}) {
    const double heavy = bridge.first;
    const int substeps = bridge.second;
    CAPTURE(heavy);
    CAPTURE(substeps);
    NewtonSolver<double> newton({.iterations = 20});
    const Gaps gaps = gaps_of(plank_bridge(heavy, substeps), newton, 4);
    CHECK(gaps.worst <= 0.025);             // a quarter of a plank's thickness: past that a joint has failed
    CHECK(gaps.gain <= 0.01 * heavy * 10);  // [J] as of a centimetre of its fall
  }
}

TEST_CASE("the more exactly a level chain is solved, the better its pins hold") {
  for (const int links : {20, 40, 80}) {
    for (const int substeps : {1, 4}) {
      CAPTURE(links);
      CAPTURE(substeps);
      SequentialImpulse<double> ten({.iterations = 10}), hundred({.iterations = 100});
      NewtonSolver<double> newton({.iterations = 20});
      const Scene scene = chain_between_walls(links, substeps);
      const double by_ten = gaps_of(scene, ten, 2).worst, by_hundred = gaps_of(scene, hundred, 2).worst;
      const double exactly = gaps_of(scene, newton, 2).worst;
      CHECK(exactly <= by_hundred);
      CHECK(by_hundred <= by_ten);
      CHECK(exactly <= 0.001);
    }
  }
}

TEST_CASE(
    "a body takes part with its mass, or with what its joint's stiffness makes of it where that is more") {
  for (const double length : {0.001, 1.0}) {
    CAPTURE(length);
    Scene scene;
    const BodyId bob = scene.add({.position = {0, -length}, .mass = 2, .fixed_rotation = true});
    scene.join<DistanceJoint>({.a = ground, .b = bob, .anchor_b = {0, -length}});
    World<double> world = world_after(scene, 1);
    world.set_velocity(bob, {3, 0, 0});
    const double h = world.clock().dt, tension = 2 * 10;  // [N] its weight
    // At rest in the line of the rod: K of an end is 2 T / L.
    const double mass = std::max(2.0, h * h * 2 * tension / length);
    const VelocityProblem<double> problem = world.velocity_problem();
    CHECK(1 / problem.inverse_mass[bob].x() == doctest::Approx(mass).epsilon(1e-12));
    CHECK(problem.velocity[bob].x() == doctest::Approx(3 * 2 / mass).epsilon(1e-12));  // the same momentum
    if (length == 1) CHECK(problem.inverse_mass[bob].x() == 0.5);
  }
}

TEST_CASE("a link that lies on a disc takes part with the stiffness of the disc's radius under its load") {
  const double radius = 1.5, half = 0.04, load = 10;
  Scene scene;
  scene.add({.type = BodyType::static_body, .shapes = {circle(radius)}});
  const Vec2<double> top = {0, radius + half};
  const BodyId link =
      scene.add({.shapes = {capsule({-0.1, 0}, {0.1, 0}, half)}, .position = top, .mass = 0.01});
  const BodyId bob = scene.add({.position = top, .mass = load, .fixed_rotation = true});
  scene.join<RevoluteJoint>({.a = link, .b = bob, .anchor = top});  // with no arms, so with no K
  World<double> world(scene);
  NewtonSolver<double> newton({.iterations = 20});
  world.step(newton);
  const double force = (load + 0.01) * 10;  // [N]
  CHECK(1 / world.velocity_problem().inverse_mass[link].z() ==
        doctest::Approx(world.clock().dt * world.clock().dt * force * (radius + half)).epsilon(1e-9));
  CHECK(1 / world.last_step().problem.inverse_mass[link].z() ==  // the first step has none before it
        doctest::Approx(world.clock().dt * world.clock().dt * force * (radius + half)).epsilon(1e-9));
}

TEST_CASE("a string of light links holds a heavy load that gets it tight") {
  check_holds(folded_string, {2, 4, 8}, 1);
}

TEST_CASE("a string of light links holds heavy loads over a disc that it falls on") {
  check_holds(string_over_disc, {1, 4}, 2);
  SequentialImpulse<double> sweeps({.iterations = 200});  // a gap of 5 mm, and half of it for twice as many
  CHECK(gaps_of(string_over_disc(10, 4), sweeps, 2).worst <= thin);
}

TEST_CASE("a pendulum on a rope that stays taut swings as far as one on a rod") {
  const double angle = std::numbers::pi / 3, w_dt = std::sqrt(10.0) / 240;
  for (const auto kind : {DistanceJoint::Kind::rod, DistanceJoint::Kind::rope}) {
    Scene scene({.substeps = 4});
    const Vec2<double> place = {std::sin(angle), -std::cos(angle)};
    const BodyId bob = scene.add({.shapes = {circle(0.05)}, .position = place, .mass = 1});
    scene.join<DistanceJoint>({.a = ground, .b = bob, .anchor_b = place, .kind = kind});
    World<double> world(scene);
    SequentialImpulse<double> solver;
    const double start = total_energy(snapshot(world)), swing = 10 * (1 - std::cos(angle));
    double worst = 0;
    for (int step = 0; step < 60 * 20; ++step) {
      world.step(solver);
      worst = std::max(worst, std::abs(total_energy(snapshot(world)) - start));
    }
    // Semi-implicit Euler shows w dt / 2 of a swing's energy and takes it back.
    CHECK(worst <= w_dt * swing);
  }
}
