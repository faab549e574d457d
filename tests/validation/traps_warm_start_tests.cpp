// Mistakes with impulses that outlive a step: whose they are, and what becomes of them when sweeps are few.
#include <map>
#include <set>

#include "geometry/random_shapes.hpp"
#include <cairn/collision/collide.hpp>
#include "problems.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

/// Two boxes of different friction on the ground, one upon the other and pushed apart; the lower one is the
/// scene's first body or its second.
struct PushedPair {
  World<double> world;
  BodyId lower;
  BodyId upper;
};

PushedPair pushed_pair(bool lower_first) {
  Scene scene;
  scene.add_ground();
  const BodySpec below = {.shapes = {box(1, 1)}, .position = {0, 0.5}, .velocity = {1, 0}, .mass = 2};
  const BodySpec above = {
      .shapes = {box(1, 0.6)}, .position = {0.1, 1.3}, .mass = 1, .material = {.friction = 0.3}};
  const BodyId first = scene.add(lower_first ? below : above);
  const BodyId second = scene.add(lower_first ? above : below);
  return {World<double>(scene), lower_first ? first : second, lower_first ? second : first};
}

/// A bob of 1 kg on an arm of 1 m and almost no inertia of its own, let go at 45 degrees: its largest energy
/// above that of its start [J], in ten seconds of so many sweeps a step.
double energy_gained(double inertia, int sweeps, bool warm) {
  Scene scene({.stabilization = {.policy = StabilizationPolicy::baumgarte}, .warm_start = warm});
  const double side = std::sqrt(0.5);
  const BodyId bob =
      scene.add({.shapes = {circle(0.1)}, .position = {side, -side}, .mass = 1, .inertia = inertia});
  scene.join<RevoluteJoint>({.a = ground, .b = bob, .anchor = {0, 0}});
  World<double> world(scene);
  SequentialImpulse<double> solver({.iterations = sweeps});
  const double start = total_energy(snapshot(world));
  double gained = 0;
  for (int step = 0; step < 600; ++step) {
    world.step(solver);
    gained = std::max(gained, total_energy(snapshot(world)) - start);
  }
  return gained;
}

}  // namespace

TEST_CASE("a contact's name says whose face it is on and at which end, so that a flip gives new names") {
  struct Place {
    bool face_of_a = true;
    bool left = true;
    auto operator<=>(const Place&) const = default;
  };
  test::Random random(31);
  std::map<std::uint32_t, Place> place_of;
  std::set<Place> places;
  for (int round = 0; round < 4000; ++round) {
    // Two boxes, nearly face to face: top upon top, so that no other number tells the two faces apart.
    const double tilt = random.uniform(-0.1, 0.1), along = random.uniform(-0.9, 0.9);
    const Pose<double> b = {{along, 1 + random.uniform(-0.01, 0.01)}, pi + tilt};
    const Manifold<double> manifold = collide<double>(box(1, 1), {}, box(1, 1), b, 0.2);
    if (manifold.count < 2 || tilt == 0) continue;
    const bool face_of_a = manifold.normal == Vec2<double>(0, 1);
    const bool first_is_left = manifold.points[0].position.x() < manifold.points[1].position.x();
    for (int i = 0; i < 2; ++i) {
      const Place place = {face_of_a, first_is_left == (i == 0)};
      const auto [known, is_new] = place_of.emplace(manifold.points[i].feature, place);
      CHECK(known->second == place);
      places.insert(place);
    }
  }
  CHECK(places.size() == 4);
  CHECK(place_of.size() == 4);  // one name for each, whatever the overlap and the tilt
}

TEST_CASE("the rows of a world have names of their own, whichever body came first") {
  for (const bool lower_first : {true, false}) {
    PushedPair pair = pushed_pair(lower_first);
    SequentialImpulse<double> solver({.iterations = 50});
    for (int step = 0; step < 20; ++step) {
      pair.world.step(solver);
      std::set<RowKey> keys;
      for (const ConstraintRow<double>& row : pair.world.last_step().problem.rows) keys.insert(row.key);
      CHECK(std::ssize(keys) == pair.world.last_step().problem.row_count());
      for (const Contact<double>& contact : pair.world.last_step().problem.contacts) {
        CHECK(contact.manifold.collider_a < contact.manifold.collider_b);
      }
      if (step == 0) continue;
      for (const char is_new : pair.world.last_step().is_new) CHECK(is_new == 0);  // all are found again
    }
  }
}

TEST_CASE("friction that is carried over pushes in the same direction, whichever body came first") {
  PushedPair one = pushed_pair(true), other = pushed_pair(false);
  SequentialImpulse<double> solver({.iterations = 3000, .patience = 3});
  for (int step = 0; step < 6; ++step) {
    one.world.step(solver);
    other.world.step(solver);
    const Vec3<double> lower = velocity_of(one.world, one.lower) - velocity_of(other.world, other.lower);
    const Vec3<double> upper = velocity_of(one.world, one.upper) - velocity_of(other.world, other.upper);
    // Converged to 16 roundings of impulses below 1 N s, of which 100 sweeps are still to come.
    CHECK(lower.cwiseAbs().maxCoeff() <= 1e-12);
    CHECK(upper.cwiseAbs().maxCoeff() <= 1e-12);
  }
  CHECK(velocity_of(one.world, one.upper).x() > 0.1);  // dragged along
}

TEST_CASE(
    "warm starting gives a stack that has settled its answer in one sweep, where a cold one needs many") {
  World<double> world(samples::stack(10));
  SequentialImpulse<double> solver({.iterations = 100});
  run(world, solver, 3);
  VelocityProblem<double> warm = world.velocity_problem();
  VelocityProblem<double> cold = warm;
  cold.impulse.assign(cold.rows.size(), 0);
  const double scale = residual_scale(cold);
  SequentialImpulse<double> once({.iterations = 1});
  once.solve(warm);
  once.solve(cold);
  CHECK(residual(warm, scale).energy <= 1e-3);
  CHECK(residual(cold, scale).energy > 0.1);  // the lowest box has felt one weight of ten
}

TEST_CASE(
    "few sweeps and a warm start feed each other: a pin of little inertia explodes, and not from cold") {
  // At 45 degrees both rows of the pin turn the bob much more easily than they move it:
  // A_12^2 / (A_11 A_22) = ((1 / 2 I) / (1 + 1 / 2 I))^2, so that a sweep leaves all but 4 I of the error.
  struct Case {
    double inertia;  // [kg m^2]
    int sweeps;
  };
  const double swing = test_gravity;  // [J] m g L
  for (const Case& few : {Case{1e-3, 2}, Case{1e-4, 10}}) {
    CHECK(energy_gained(few.inertia, few.sweeps, true) > 1e6 * swing);
    CHECK(energy_gained(few.inertia, few.sweeps, false) <= 1e-12 * swing);
  }
  // 1 / I sweeps are four times 1 / (4 I): e^-4 of an error is left, and warm or cold makes no difference.
  // The energy of semi-implicit Euler sways by up to omega dt / 2 = sqrt(10) / 120 of the swing's.
  const double enough_warm = energy_gained(1e-3, 1000, true);
  const double enough_cold = energy_gained(1e-3, 1000, false);
  CHECK(enough_warm <= 0.026 * swing);
  CHECK(enough_cold <= 0.026 * swing);
  CHECK(std::abs(enough_warm - enough_cold) <= 0.001 * swing);
}
