// Box2D as one more contestant.
#include <doctest/doctest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include <cairn/math/list.hpp>
#include <cairn/study/contestant.hpp>
#include <cairn/study/judgement.hpp>

#ifdef CAIRN_HAVE_BOX2D

using namespace cairn;

namespace {

const Setting usual_box2d{.solver = "box2d", .sweeps = {.iterations = 8}};

}  // namespace

TEST_CASE("Box2D runs the scenes of what it has, and says why it refuses the others") {
  const List<std::string> beyond_it = {"gears",           "differential",    "workshop", "friction-taught",
                                       "breaking-bridge", "cradle-touching", "sorting"};
  for (const SceneEntry& entry : scene_entries()) {
    CAPTURE(entry.name);
    const bool refused = std::find(beyond_it.begin(), beyond_it.end(), entry.name) != beyond_it.end();
    const TrialResult result = run_trial(entry.make(), usual_box2d, {.seconds = 0.5});
    CHECK(result.status == (refused ? TrialStatus::refused : TrialStatus::ok));
    CHECK(result.reason.empty() != refused);
    if (refused) CHECK_THROWS_AS(make_contestant(entry.make(), usual_box2d), std::invalid_argument);
  }
}

TEST_CASE("a run in Box2D has the same hash when it is repeated, and its rows are counted") {
  const Scene stack = scene_entry("stack").make();
  const TrialOptions options{.seconds = 0.5, .residual = ResidualMeasure::every_step};
  const TrialResult first = run_trial(stack, usual_box2d, options);
  CHECK(run_trial(stack, usual_box2d, options).state_hash == first.state_hash);
  // Ten boxes, two points under each, two rows a point, eight sweeps, 30 steps.
  CHECK(first.row_updates == 30 * 10 * 2 * 2 * 8);
  CHECK_FALSE(first.mean_residual.has_value());  // its rows cannot be seen
}

TEST_CASE("a tower of ten stands in Box2D, whose skin lifts it by more than its place is wide") {
  const SceneEntry stack = scene_entry("stack");
  TrialOptions options = trial_options(stack);
  options.seconds = 10;
  const TrialResult result = run_trial(stack.make(), usual_box2d, options);
  CHECK(result.stands());
  CHECK(result.stands_until == 10);
  CHECK(result.farthest > *stack.expectations.stands);  // from where it was placed
}

TEST_CASE("a step of Box2D with substeps is as many shorter steps") {
  const Scene tower = scene_entry("stack-offset").make();
  Setting coarse = usual_box2d;
  coarse.substeps = 4;
  Setting fine = usual_box2d;
  fine.dt = coarse.dt / 4;
  List<int> steps;
  TrialOptions options{.seconds = 0.5};
  options.observer = [&](const Snapshot& now) { steps.push_back(now.step); };
  const TrialResult one = run_trial(tower, coarse, options);
  CHECK(steps.back() == 30);
  const TrialResult other = run_trial(tower, fine, {.seconds = 0.5});
  CHECK(one.steps == 30);
  CHECK(other.steps == 120);
  CHECK(one.state_hash == other.state_hash);
}

#endif
