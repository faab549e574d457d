// Contacts solved as they are, and the same contacts as rows: to the last bit.
#include "leaning_wall.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

/// A leaning wall after 40 steps.
WithRowsAndWithout<double> twins_after_40() {
  WithRowsAndWithout<double> twins(leaning_wall({}));
  twins.steps(40);
  return twins;
}

template <Scalar Real>
void check_steps(const Scene& scene, const SolverSettings& settings, Momentum momentum, LaneSet set) {
  WithRowsAndWithout<Real> twins(scene, settings, momentum, set);
  for (int step = 0; step < 90; ++step) {
    twins.step();
    if (step % 9 == 0) twins.check_alike();
  }
  CHECK(twins.world.last_step().problem.contacts.size() > 40);
  CHECK(same_motion(twins.world, twins.observed));
}

List<Scene> walls() {
  List<Scene> scenes;
  using enum StabilizationPolicy;
  for (const StabilizationPolicy policy : {none, baumgarte, relaxed, soft}) {
    for (const int substeps : {1, 3}) {
      SceneSettings settings = {.substeps = substeps};
      settings.stabilization.policy = policy;
      settings.contact_search = substeps > 1 ? ContactSearch::every_step : ContactSearch::when_moved;
      scenes.push_back(leaning_wall(settings));
    }
  }
  return scenes;
}

}  // namespace

TEST_CASE_TEMPLATE("contacts without rows are solved to the bits of their rows", Real, float, double) {
  for (const Scene& scene : walls()) {
    check_steps<Real>(scene, {.iterations = 4}, Momentum::none, widest_lane_set());
    check_steps<Real>(scene, {.iterations = 4}, Momentum::none, LaneSet::baseline);
  }
  check_steps<Real>(leaning_wall({}), {.iterations = 4}, Momentum::nesterov, widest_lane_set());
}

TEST_CASE_TEMPLATE("a tolerance is judged alike with rows and without", Real, float, double) {
  const SolverSettings settings = {.iterations = 60, .tolerance = 0.02};
  for (const Scene& scene : walls()) {
    check_steps<Real>(scene, settings, Momentum::none, widest_lane_set());
  }
  check_steps<Real>(leaning_wall({}), settings, Momentum::none, LaneSet::baseline);
  check_steps<Real>(leaning_wall({}), settings, Momentum::nesterov, widest_lane_set());
}

TEST_CASE("without rows too, an answer is as near as its tolerance asks") {
  World<double> world(leaning_wall({}));
  WideSequentialImpulse<double> solver({.iterations = 20000, .tolerance = 1e-9});
  for (int step = 0; step < 30; ++step) {
    // Before the solve: what R_E is measured by, and the velocities that it starts from.
    const VelocityProblem<double> before = world.velocity_problem();
    const StepReport report = world.step(solver);
    REQUIRE(report.solve.stop == Stop::tolerance);
    // R_E by rows is the same sum in another order, of fewer than 1000 terms.
    const Residual<double> left = residual(with_rows(world).problem, residual_scale(before));
    CHECK(left.energy <= 1e-9 * (1 + 1e-12));
  }
}

TEST_CASE("a solver may be given rows and contacts without them by turns") {
  WithRowsAndWithout<double> twins(leaning_wall({}));
  for (int step = 0; step < 60; ++step) {
    twins.world.step(twins.wide, step % 3 == 1 ? &twins.onlooker : nullptr);
    twins.observed.step(twins.watched, &twins.onlooker);
  }
  twins.check_alike();
}

TEST_CASE("the record of a step without rows is that step's, whenever it is asked for") {
  WithRowsAndWithout<double> twins = twins_after_40();
  const World<double> copy = twins.world;
  take_steps(twins.world, twins.wide, 5);
  check_same_record(with_rows(copy), with_rows(twins.observed));
}

TEST_CASE("neither another dt nor a hand changes the record of the step before") {
  const WithRowsAndWithout<double> twins = twins_after_40();
  World<double> with_other_dt = twins.world, with_a_hand = twins.world;
  with_other_dt.set_dt(0.005);
  with_a_hand.move_hand(HandInput::grab({.body = BodyId{7}, .target = {3, 9}}));
  check_same_record(with_rows(with_other_dt), with_rows(twins.observed));
  check_same_record(with_rows(with_a_hand), with_rows(twins.observed));
}

TEST_CASE("masses that change in mid-run reach the lanes") {
  WithRowsAndWithout<double> twins(leaning_wall({}));
  twins.steps(60);
  twins.change([](World<double>& world) {
    world.edit([](Scene& scene) {
      BodySpec spec = scene.bodies()[BodyId{5}].spec;
      spec.density *= 10;
      scene.change(BodyId{5}, spec);
    });
  });
  twins.steps(20);
  CHECK(same_motion(twins.world, twins.observed));
}

TEST_CASE("patience, split impulses and one row of friction for two points ask for rows") {
  CHECK(WideSequentialImpulse<double>({.iterations = 4}).takes_contacts());
  CHECK(WideSequentialImpulse<double>({.tolerance = 1e-6}).takes_contacts());
  CHECK_FALSE(WideSequentialImpulse<double>({.patience = 8}).takes_contacts());
  CHECK_FALSE(SequentialImpulse<double>().takes_contacts());
  CHECK(make_plan(leaning_wall({})).contacts_without_rows());
  SceneSettings split;
  split.stabilization.policy = StabilizationPolicy::split_impulse;
  CHECK_FALSE(make_plan(leaning_wall(split)).contacts_without_rows());
  CHECK_FALSE(make_plan(leaning_wall({.friction_rows = FrictionRows::per_manifold})).contacts_without_rows());
}

TEST_CASE_TEMPLATE("joints and rebounds leave contacts without rows: to the same bits", Real, float, double) {
  for (const SolverSettings& settings : {SolverSettings{.iterations = 4}, SolverSettings{.iterations = 1},
                                         SolverSettings{.iterations = 60, .tolerance = 0.02}}) {
    for (const Scene& scene : walls()) {
      const auto check = [&](const Scene& mixed) {
        check_steps<Real>(mixed, settings, Momentum::none, widest_lane_set());
        check_steps<Real>(mixed, settings, Momentum::nesterov, LaneSet::baseline);
      };
      Scene mixed = scene;
      mixed.add({.shapes = {circle(0.5)},
                 .position = {0.3, 20},
                 .velocity = {0, -9},
                 .material = {.restitution = 0.5}});
      check(mixed);
      mixed.join<DistanceJoint>({.a = BodyId{3}, .b = BodyId{9}, .anchor_a = {0, 9}, .anchor_b = {2, 9}});
      mixed.join<RevoluteJoint>(
          {.a = ground, .b = BodyId{5}, .anchor = scene.bodies()[BodyId{5}].pose.position});
      check(mixed);
    }
  }
  check_steps<Real>(leaning_wall({.friction_rows = FrictionRows::per_manifold}), {.iterations = 4},
                    Momentum::none, widest_lane_set());
}
