// What the scenes that come with Cairn expect of a run, and whether it is met.
#include <cairn/study/expectation.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

using namespace cairn;

TEST_CASE("a scene begins without overlap, without drift, and with something that can move") {
  for (const SceneEntry& entry : scene_entries()) {
    CAPTURE(entry.name);
    bool moves = false;
    double drift = 0;
    TrialOptions options{.seconds = 0};
    options.observer = [&](const Snapshot& now) {
      for (const SnapshotBody& body : now.bodies) moves |= body.type == BodyType::dynamic;
      for (const SnapshotJoint& joint : now.joints) drift = std::max(drift, joint.drift);
    };
    const TrialResult start = run_trial(entry.make(), {}, options);
    CHECK(start.steps == 0);
    CHECK(moves);
    CHECK(drift <= 1e-13);  // roundings of places of some 10 m
    // In a microsecond nothing here moves further than 10 micrometres: what overlaps more did so at first.
    const TrialResult soon = run_trial(entry.make(), {.dt = 1e-6}, {.seconds = 1e-6});
    CHECK(soon.steps == 1);
    CHECK(soon.worst_penetration <= 1e-5);
  }
}

TEST_CASE("every scene takes 60 steps of plain sequential impulses with finite numbers") {
  for (const SceneEntry& entry : scene_entries()) {
    CAPTURE(entry.name);
    const Setting plain;
    const TrialResult result = run_trial(entry.make(), plain, {.seconds = 1, .penetration_every = 60});
    CHECK(result.status == TrialStatus::ok);
    CHECK(result.steps == 60);
  }
}

TEST_CASE("every scene keeps to its expectations under the setting that comes with it") {
  for (const SceneEntry& entry : scene_entries()) {
    CAPTURE(entry.name);
    const TrialResult result = run_trial(entry.make(), entry.setting, trial_options(entry));
    for (const std::string& missed : unmet(entry.expectations, result)) FAIL_CHECK(missed);
    for (const Failure& failure : result.failures) FAIL_CHECK(failure_text(failure, entry.body_names));
  }
}

TEST_CASE("the scenes that are hard are so: ten plain sweeps do not do what is expected") {
  for (const char* name : {"stack-ratio", "stack-5-100", "chain-bob", "weld-beam"}) {
    CAPTURE(name);
    const SceneEntry entry = scene_entry(name);
    CHECK_FALSE(unmet(entry.expectations, run_trial(entry.make(), {}, trial_options(entry))).empty());
  }
}

TEST_CASE("Painleve's rod sends single rows round in circles, and is solved by blocks") {
  const SceneEntry entry = scene_entry("painleve");
  TrialOptions options{.seconds = 0.1, .residual = ResidualMeasure::every_step};
  Setting rows = entry.setting;
  rows.solver = "si";
  rows.sweeps.iterations = 1000;
  CHECK(*run_trial(entry.make(), entry.setting, options).worst_residual <= 1e-12);  // a few roundings
  // Where the friction of 1.45 is above A_nn / A_nt = 4/3, sweeps never come to rest.
  CHECK(*run_trial(entry.make(), rows, options).worst_residual >= 0.1);
}

TEST_CASE("expectations that were missed are told with both numbers, and met ones are not told") {
  TrialResult result{.seconds = 2,
                     .worst_penetration = 0.25,
                     .worst_drift = 0.5,
                     .energy_gain = 0.03,
                     .energy_loss = 0.5,
                     .farthest = 2,
                     .fell_at = 0.5,
                     .stands_until = 0.5};
  const Expectations all{.penetration = 0.1, .drift = 0.2, .energy_gain = 1, .energy_loss = 40, .stands = 1};
  const List<std::string> missed = unmet(all, result);
  REQUIRE(missed.size() == 5);
  CHECK(missed[0] == "worst penetration 0.25 m, expected at most 0.1 m");
  CHECK(missed[1] == "worst drift 0.5 m or rad, expected at most 0.2 m or rad");
  CHECK(missed[2] == "energy gain 3 %, expected at most 1 %");
  CHECK(missed[3] == "energy loss 50 %, expected at most 40 %");
  CHECK(missed[4] == "stands for 0.5 s of 2 s");
  CHECK(unmet({}, result).empty());
  result.fell_at.reset();
  CHECK(unmet({.penetration = 0.25, .drift = 0.5, .energy_gain = 3, .energy_loss = 50, .stands = 2}, result)
            .empty());
  result.status = TrialStatus::nan;
  CHECK(unmet({}, result).size() == 1);
}

TEST_CASE("a body that does not end in its place is told with its name and both distances") {
  const Expectations expectations{
      .places = {{.body = {1}, .position = {1, 2}, .within = 0.05}, {.body = {2}, .within = 0.2}}};
  const TrialResult result{.seconds = 2, .place_distances = {0.25, 0.2}};
  const List<std::string> missed = unmet(expectations, result, {"ground", "ball", "box"});
  REQUIRE(missed.size() == 1);
  CHECK(missed[0] == "place of ball off by 0.25 m, expected at most 0.05 m");
}
