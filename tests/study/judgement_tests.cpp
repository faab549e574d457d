// The one judgement of a run: what scenes expect, what is wished, and how far a run is from that.
#include <cairn/study/judgement.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
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
    const RunJudgement judgement = judge(result, wish_of(entry), entry.body_names);
    for (const std::string& missed : judgement.missed()) FAIL_CHECK(missed);
    for (const std::string& failure : judgement.failures) FAIL_CHECK(failure);
    CHECK(judgement.meets());
  }
}

TEST_CASE("the scenes that are hard are so: ten plain sweeps do not do what is expected") {
  for (const char* name : {"stack-ratio", "stack-5-100", "chain-bob", "weld-beam"}) {
    CAPTURE(name);
    const SceneEntry entry = scene_entry(name);
    CHECK_FALSE(judge(run_trial(entry.make(), {}, trial_options(entry)), wish_of(entry)).meets());
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

namespace {

/// A run that misses each of these by a factor of its own.
const Wish all_wishes{
    .penetration = 0.1, .drift = 0.2, .residual = 0.05, .energy_gain = 0.01, .energy_loss = 0.4, .stands = 2};

TrialResult bad_run() {
  return {.seconds = 2,
          .worst_penetration = 0.25,
          .worst_drift = 0.5,
          .energy_gain = 0.03,
          .energy_loss = 0.5,
          .farthest = 2,
          .fell_at = 0.5,
          .stands_until = 0.5,
          .stand_share = 4,
          .worst_residual = 0.1};
}

}  // namespace

TEST_CASE("what was missed is told with both numbers, the worst first, and the share of the limit decides") {
  const RunJudgement judgement = judge(bad_run(), all_wishes);
  CHECK_FALSE(judgement.meets());
  CHECK_FALSE(judgement.fails());
  CHECK(judgement.share() == 4);
  CHECK(judgement.worst()->name == "stands");
  CHECK(judgement.missed() == List<std::string>{"stands 0.5 s, at least 2 s", "energy gain 3 %, at most 1 %",
                                                "penetration 250 mm, at most 100 mm",
                                                "drift 500 mm, at most 200 mm", "R_E 0.1, at most 0.05",
                                                "energy loss 50 %, at most 40 %"});
  CHECK(judgement.first_missed(2) == "stands 0.5 s");
  CHECK(judge(bad_run(), {.penetration = 0.1}).first_missed(2) == "penetration 250 mm after 2 s");
}

TEST_CASE("a limit is met when it is reached, and its share is then 1") {
  TrialResult result = bad_run();
  const Wish exactly{
      .penetration = 0.25, .drift = 0.5, .residual = 0.1, .energy_gain = 0.03, .energy_loss = 0.5};
  CHECK(judge(result, exactly).share() == 1);
  CHECK(judge(result, exactly).meets());
  CHECK(judge(result, exactly).missed().empty());
  CHECK(judge(result, {.penetration = 0.5}).share() == 0.5);
  CHECK(judge(result, {.stands = 0.5}).meets());  // it fell after that
  CHECK(judge(result, {}).share() == 0);
  CHECK(judge(result, {}).worst() == nullptr);
  result.worst_penetration = std::nextafter(0.25, 1.0);  // over 0.25 it rounds to 1
  CHECK_FALSE(judge(result, exactly).meets());
}

TEST_CASE("a run that ended badly, or showed what no run should, meets nothing, whatever its numbers are") {
  const double never = std::numeric_limits<double>::infinity();
  TrialResult result{.seconds = 2};
  result.status = TrialStatus::nan;
  CHECK(judge(result, {}).missed() == List<std::string>{"nan after 2 s"});
  CHECK(judge(result, {.penetration = 1}).share() == never);
  result.status = TrialStatus::ok;
  CHECK(judge(result, {.penetration = 1}).meets());
  result.failures = {{.kind = FailureKind::fell_out, .time = 2, .a = {1}}};
  const RunJudgement failed = judge(result, {.penetration = 1});
  CHECK(failed.fails());
  CHECK(failed.share() == never);
  CHECK(failed.missed().empty());  // of what was asked
  CHECK(failed.first_missed(2) == "body 1 has fallen out of the scene after 2 s");
}

TEST_CASE("numbers that are not there, or are none, meet no wish for them") {
  TrialResult result{.seconds = 2};
  CHECK(judge(result, {.residual = 1}).missed() == List<std::string>{"R_E cannot be measured, at most 1"});
  result.worst_drift = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(judge(result, {.drift = 1}).meets());
}

TEST_CASE("a run that is not over is lost once it misses what cannot become better") {
  const TrialResult result = bad_run();
  CHECK(judge(result, {.penetration = 0.1}).is_lost());
  CHECK(judge(result, {.stands = 2}).is_lost());
  CHECK_FALSE(judge(result, {.penetration = 0.3}).is_lost());
  CHECK_FALSE(judge(result, {.energy_loss = 0.1}).is_lost());  // asked of the end
}

TEST_CASE("a body that does not end in its place is told with its name and both distances") {
  const Wish wish{
      .places = {{.body = {1}, .position = {1, 2}, .within = 0.05}, {.body = {2}, .within = 0.2}}};
  const TrialResult result{.seconds = 2, .place_distances = {0.25, 0.2}};
  const RunJudgement judgement = judge(result, wish, {"ground", "ball", "box"});
  CHECK(judgement.missed() == List<std::string>{"place of ball off by 250 mm, at most 50 mm"});
  CHECK(judgement.share() == 5);
  CHECK_FALSE(judgement.is_lost());  // it may still get there
}

TEST_CASE("what a scene expects is what its file says, in shares, and standing for all of its time") {
  const SceneEntry stack = scene_entry("stack");
  const Wish wish = wish_of(stack);
  CHECK(*wish.penetration == *stack.expectations.penetration);
  CHECK(*wish.energy_gain == *stack.expectations.energy_gain / 100);
  CHECK(*wish.stands == stack.seconds);
  CHECK_FALSE(wish.drift);
}
