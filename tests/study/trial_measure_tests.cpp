// Times of steps, and errors beside the size of bodies, as a trial tells them.
#include <cairn/study/trial.hpp>

#include <doctest/doctest.h>

#include <cmath>

using namespace cairn;

TEST_CASE("a run tells its median and its slowest step, and how long a frame takes of median steps") {
  Scene scene({.gravity = {0, 0}});
  scene.add({.shapes = {circle(0.5)}});
  int readings = 0;
  double now = 0;
  TrialOptions options{.seconds = 5.0 / 120};  // five steps, which take 1, 2, 4, 8 and 16 s
  options.clock = [&] {
    if (readings >= 2 && readings % 2 == 1) now += std::pow(2, (readings - 3) / 2);
    readings += 1;
    return now;
  };
  const TrialResult result = run_trial(scene, {.dt = 1.0 / 120}, options);
  CHECK(result.steps == 5);
  CHECK(result.median_step == 4);
  CHECK(result.slowest_step == 16);
  CHECK(result.frame() == doctest::Approx(2 * 4).epsilon(1e-15));  // two steps in a 60th of a second
}

TEST_CASE("what is worst is told beside the thinner of its two bodies") {
  Scene scene({.gravity = {0, 0}});
  scene.add({.type = BodyType::static_body, .shapes = {box(4, 1)}});
  scene.add({.shapes = {box(1, 0.25)}, .position = {0, 0.5 + 0.125 - 0.05}});
  const TrialResult result = run_trial(scene, {.dt = 1e-9}, {.seconds = 1e-9});
  CHECK(result.penetration_worst.thickness == 0.25);
  CHECK(result.of_body() == doctest::Approx(0.05 / 0.25).epsilon(1e-6));
}
