// Manifolds that move with their bodies, and solvers that take their contacts without rows: to the bits of
// rows.
#include "leaning_wall.hpp"
#include <cairn/samples/samples.hpp>

using namespace cairn;
using namespace cairn::testing;

namespace {

SceneSettings in_substeps(int substeps, ContactSearch search = ContactSearch::every_step) {
  SceneSettings settings = {.substeps = substeps, .contact_search = search};
  settings.stabilization.policy = StabilizationPolicy::soft;
  return settings;
}

/// Boxes in a pyramid, and a disc beside it.
Scene pyramid_and_disc(const SceneSettings& settings) {
  Scene scene = samples::pyramid({.base = 6, .pitch = 1.2}, settings);
  scene.add({.shapes = {circle(0.3)}, .position = {-5, 0.3}});
  return scene;
}

/// Steps both worlds, and calls change(world) before every tenth step.
template <Scalar Real, typename Change>
void check_same_steps(const Scene& scene, int steps, const Change& change) {
  WithRowsAndWithout<Real> twins(scene);
  for (int step = 0; step < steps; ++step) {
    if (step % 10 == 9) twins.change(change);
    twins.step();
  }
  twins.check_alike();
}

}  // namespace

TEST_CASE_TEMPLATE("contacts of manifolds that move have the bits of their rows", Real, float, double) {
  const auto nothing = [](World<Real>&) {};
  for (const ContactSearch search : {ContactSearch::every_step, ContactSearch::when_moved}) {
    check_same_steps<Real>(pyramid_and_disc(in_substeps(4, search)), 25, nothing);
    check_same_steps<Real>(leaning_wall(in_substeps(4, search)), 50, nothing);
  }
  check_same_steps<Real>(pyramid_and_disc(in_substeps(1, ContactSearch::when_moved)), 25, nothing);
  check_same_steps<Real>(leaning_wall(in_substeps(1, ContactSearch::when_moved)), 50, nothing);
  SceneSettings cold = in_substeps(3);
  cold.warm_start = false;
  check_same_steps<Real>(pyramid_and_disc(cold), 10, nothing);
}

TEST_CASE("another dt, and bodies that are put to sleep, change nothing of that") {
  const auto change_dt = [](World<double>& world) {
    world.set_dt(world.clock().dt < 0.01 ? 1.0 / 60 : 0.008);
  };
  check_same_steps<double>(leaning_wall(in_substeps(3)), 60, change_dt);
  check_same_steps<double>(pyramid_and_disc(in_substeps(1, ContactSearch::when_moved)), 60, change_dt);
  SceneSettings drowsy = in_substeps(3);
  drowsy.sleeping = Sleeping{.speed = 0.3, .angular_speed = 0.3, .time = 0.1};
  check_same_steps<double>(leaning_wall(drowsy), 60, [](World<double>&) {});
}

TEST_CASE("shapes that are deep in each other are counted alike") {
  Scene scene = pyramid_and_disc(in_substeps(1, ContactSearch::when_moved));
  scene.add({.shapes = {box(1, 1)}, .position = {20, -0.05}});  // by 0.55 m, and comes out slowly
  check_same_steps<double>(scene, 60, [](World<double>&) {});
}

TEST_CASE("one solver takes the steps of several worlds, and of their copies, as if each had its own") {
  World<double> world(pyramid_and_disc(in_substeps(1, ContactSearch::when_moved))), own = world;
  WideSequentialImpulse<double> shared({.iterations = 4}), alone({.iterations = 4}), third({.iterations = 4});
  const auto step_both = [&](WideSequentialImpulse<double>& solver) {
    world.step(solver);
    own.step(alone);
  };
  for (int step = 0; step < 30; ++step) step_both(shared);
  World<double> copy = world, own_copy = own;
  WideSequentialImpulse<double> copied = shared;
  for (World<double>* moved : {&copy, &own_copy}) moved->set_velocity(BodyId{9}, {0.1, 0, 0});
  for (int step = 0; step < 9; ++step) {
    step_both(shared);
    if (step % 3 == 1) (void)with_rows(world);
    if (step % 3 == 2) continue;
    copy.step(shared);
    own_copy.step(third);
  }
  step_both(copied);  // which knows the contacts of ten steps before
  step_both(shared);  // and those of two
  CHECK(same_motion(world, own));
  CHECK(same_motion(copy, own_copy));
}

TEST_CASE("a substep that ends in no number leaves the impulses of the substep before it") {
  // Nothing stops this body, or touches it: 182 substeps take it farther than there is a number for. That is
  // the second substep of the 61st step.
  const double most = std::numeric_limits<double>::max();
  Scene scene = pyramid_and_disc(in_substeps(3));
  const BodyId lost = scene.add(
      {.shapes = {circle(0.1)}, .position = {0, 9}, .gravity_scale = 0, .filter = {.collides_with = 0}});
  WithRowsAndWithout<double> twins(scene);
  twins.change([&](World<double>& world) { world.set_velocity(lost, {most / 181.5 * 180, 0, 0}); });
  for (int step = 1; step <= 61; ++step) CHECK(twins.step() == (step < 61));
  CHECK(pose_of(twins.world, lost).position.x() > most / 181.5 * 180.5);  // the first substep was done
  twins.check_alike_ahead();
}
