// Runs of scenes that change on the way, and of scenes that say where they should end.
#include <doctest/doctest.h>

#include <cairn/geometry/shape.hpp>
#include <cairn/study/trial.hpp>

using namespace cairn;

namespace {

const double event_trial_dt = 1.0 / 64;  // [s] exact, so that sums of it are

}  // namespace

TEST_CASE("what an event gives or takes is neither a gain nor a loss of energy") {
  // The second disc falls; the first flies away without gravity, and then is taken out.
  Scene scene;
  const BodyId flying = scene.add({.shapes = {circle(0.5)}, .mass = 2, .gravity_scale = 0});
  scene.add({.shapes = {circle(0.5)}, .position = {5, 0}, .mass = 1});
  scene.add({.time = 0.25, .action = PushBody{.body = flying, .impulse = {-20, 0}}});
  const Setting setting{.dt = event_trial_dt};
  const auto error = [&](const Scene& tried) {
    const TrialResult result = run_trial(tried, setting, {.seconds = 1});
    CHECK(result.status == TrialStatus::ok);
    CHECK(result.energy_gain == 0);
    return result.energy_loss * result.energy_scale;  // [J]
  };
  // Semi-implicit Euler loses m g^2 dt t / 2 of what falls, and nothing of what flies straight on.
  const double loss = 100 * event_trial_dt / 2;
  CHECK(error(scene) == doctest::Approx(loss).epsilon(1e-12));  // J^2 / (2 m) = 100 J are left out
  scene.add({.time = 0.5, .action = RemoveBody{flying}});
  CHECK(error(scene) == doctest::Approx(loss).epsilon(1e-12));
}

TEST_CASE("a body that an event removes has not fallen, nor has what stood on a floor that is gone") {
  Scene scene;
  const BodyId floor =
      scene.add({.type = BodyType::static_body, .shapes = {box(8, 1)}, .position = {0, -0.5}});
  const BodyId first = scene.add({.shapes = {box(1, 1)}, .position = {-2, 0.5}});
  scene.add({.shapes = {box(1, 1)}, .position = {2, 0.5}});
  const auto end = [](const Scene& tried) {
    return run_trial(tried, {.sweeps = {.iterations = 20}}, {.seconds = 1.5, .stand_distance = 0.1});
  };
  scene.add({.time = 0.25, .action = RemoveBody{first}});
  CHECK(end(scene).stands());
  CHECK(end(scene).failures.empty());
  scene.add({.time = 0.5, .action = RemoveBody{floor}});
  CHECK_FALSE(end(scene).stands());    // the other one falls,
  CHECK(end(scene).failures.empty());  // but not out of what there was to hold it
}

TEST_CASE("a scene with places stands if it ends in them, whatever was on the way") {
  Scene scene;
  scene.add({.shapes = {circle(0.5)}, .mass = 1});
  const Setting setting{.dt = event_trial_dt};
  const double fall = 10 * event_trial_dt * event_trial_dt * 64 * 65 / 2;  // semi-implicit Euler, 64 steps
  const auto run = [&](double height, double seconds) {
    TrialOptions options{.seconds = seconds, .stand_distance = 0.1};
    options.places = {{.body = {1}, .position = {0.3, height}, .within = 0.501}};
    return run_trial(scene, setting, options);
  };
  const TrialResult met = run(-fall + 0.4, 1);
  CHECK(met.stands());
  CHECK(met.stands_until == 1);
  CHECK(met.place_distances[0] == doctest::Approx(0.5));  // 0.3 and 0.4 m
  const TrialResult missed = run(-fall + 0.41, 1);
  CHECK_FALSE(missed.stands());
  CHECK(missed.stands_until == 0);
  CHECK(run(0, 0).stands());  // where it begins
}
