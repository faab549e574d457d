// Motions with a known end: the error of a run goes down with its step, to what formulas foretell.
#include <cairn/study/answered_scenes.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <cairn/study/trial.hpp>

using namespace cairn;

namespace {

const AnsweredScene& answered(const std::string& name) {
  const auto found = std::find_if(answered_scenes().begin(), answered_scenes().end(),
                                  [&](const AnsweredScene& scene) { return scene.name == name; });
  REQUIRE(found != answered_scenes().end());
  return *found;
}

/// The error of SI with ten sweeps.
double error_at(const AnsweredScene& scene, double frequency, const Stabilization& stabilization = {}) {
  const std::unique_ptr<MotionError> error = scene.watch();
  const TrialOptions options{.seconds = scene.seconds,
                             .penetration_every = 1000000,
                             .observer = [&](const Snapshot& snapshot) { error->see(snapshot); }};
  const TrialResult result =
      run_trial(scene.make(), {.dt = 1 / frequency, .stabilization = stabilization}, options);
  REQUIRE(result.status == TrialStatus::ok);
  return error->value();
}

}  // namespace

TEST_CASE("answered scenes have names of their own, words and runs") {
  std::set<std::string> names;
  for (const AnsweredScene& scene : answered_scenes()) {
    CAPTURE(scene.name);
    CHECK(names.insert(scene.name).second);
    CHECK_FALSE(scene.what.empty());
    CHECK_FALSE(scene.formula.empty());
    CHECK(scene.seconds > 0);
    CHECK(scene.make().bodies().size() >= 1);
  }
}

TEST_CASE("the error of every answered scene goes down like its step, or faster") {
  // From 30 to 960 Hz: over five halvings, so that an error that changes its sign on the way counts little.
  for (const AnsweredScene& scene : answered_scenes()) {
    if (scene.name == "bounce") continue;  // see below
    CAPTURE(scene.name);
    const double coarse = error_at(scene, 30), fine = error_at(scene, 960);
    CHECK(std::log2(coarse / fine) / 5 >= 0.8);
    CHECK(fine <= 0.0015);  // of the number itself: a seventh of a per cent
  }
}

TEST_CASE("what slides under constant friction misses its way by mu g t dt / 2, exactly") {
  // Velocities are right at the end of every step, and move the body through all of it: each step falls short
  // by mu g dt^2 / 2. The body slides for a whole number of steps. Ten sweeps leave
  // 4e-10 of the load in the wrong corner of the box at 60 Hz; eighty leave 1e-12.
  for (const double frequency : {60.0, 240.0, 960.0}) {
    const double dt = 1 / frequency;
    CAPTURE(frequency);
    CHECK(std::abs(error_at(answered("stopping"), frequency) - 3 * (5.0 / 3) * dt / 2 / (25.0 / 6)) <= 1e-9);
    CHECK(std::abs(error_at(answered("slip-to-roll"), frequency) - 2 * 1 * dt / 2 / 9) <= 1e-9);
    CHECK(std::abs(error_at(answered("puck-from-above"), frequency) - 3 * 1 * dt / 2 / 1.5) <= 1e-9);
  }
}

TEST_CASE("a rotor's pin gives way by (omega dt)^2 / (2 beta), where Baumgarte holds it") {
  // A step along the tangent leads away from the circle by r (omega dt)^2 / 2, and beta of the error is taken
  // back. The next terms are omega dt and its square: 1.3 % at 480 Hz.
  for (const double frequency : {480.0, 960.0}) {
    const double turned = 2 * pi / frequency;
    const double expected = turned * turned / (2 * 0.2);
    const double error = error_at(answered("rotor"), frequency, {.policy = StabilizationPolicy::baumgarte});
    CHECK(std::abs(error / expected - 1) <= turned);
    // Joints that follow their arcs take the term of second order back; the next one is left.
    CHECK(error_at(answered("rotor"), frequency) <= std::pow(turned, 3));
  }
}

TEST_CASE("the height of a bounce depends on where in a step the ball arrives, by what it falls in a step") {
  // It bounces up to v dt from the floor, which counts 1 + e^2 at the apex, and semi-implicit steps are
  // behind by v dt / 2 down, of which e^2 comes back, and by e v dt / 2 up. Of e^2 h = 0.89 m above zero.
  const double v = std::sqrt(2 * 10 * 1.0), e = 0.8;
  for (const double frequency : {60.0, 120.0, 240.0, 480.0, 960.0}) {
    const double bound = v / frequency * (1 + e * e + e * e / 2 + e / 2) / 0.89;
    CAPTURE(frequency);
    CHECK(error_at(answered("bounce"), frequency) <= bound);
  }
}

TEST_CASE("who watches a wrong motion sees the error") {
  // A snapshot by hand, where the box stopped 10 % too soon.
  const AnsweredScene& scene = answered("stopping");
  const std::unique_ptr<MotionError> error = scene.watch();
  Snapshot snapshot;
  snapshot.bodies.resize(2);
  snapshot.bodies[{1}].pose.position = {0.9 * 25 / 6, 0.25};
  error->see(snapshot);
  CHECK(std::abs(error->value() - 0.1) <= 4e-16);
}
