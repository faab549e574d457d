// The run that others are held against.
#include <cairn/study/exact_run.hpp>

#include <doctest/doctest.h>

#include <cairn/study/trial.hpp>
#include <cairn/validation/case_scenes.hpp>

using namespace cairn;

TEST_CASE("a free fall is off the exact run by g t (dt - dt') / 2, in which both steps are too early") {
  Scene scene;
  scene.add({.shapes = {circle(0.5)}});
  const ExactRun exact(scene, 3);
  REQUIRE(exact.is_known());
  CHECK(exact.seconds() == 1);
  Snapshot end;
  TrialOptions options{.seconds = 1};
  options.observer = [&end](const Snapshot& now) { end = now; };
  run_trial(scene, {.dt = 1.0 / 64}, options);
  const double g = scene.settings().gravity.norm();
  CHECK(exact.gap(end) == doctest::Approx(g * (1.0 / 64 - 1.0 / 3840) / 2).epsilon(1e-6));
}

TEST_CASE("where there are more than 300 freedoms nothing is run") {
  CHECK_FALSE(ExactRun(cases::box_column(List<double>(101, 1.0)), 1).is_known());
}
