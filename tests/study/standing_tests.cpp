// Whether bodies keep their places: what settling may do, and what it may not.
#include <cairn/study/standing.hpp>

#include <doctest/doctest.h>

#include <cairn/study/trial.hpp>
#include <cairn/world/world.hpp>

using namespace cairn;

namespace {

const double standing_dt = 1.0 / 64;  // [s] exact, so that sums of it are

/// A disc of radius 0.5 m that moves at a speed that nothing changes.
TrialResult drifting_disc(const Vec2<double>& velocity, double seconds, double distance) {
  Scene scene({.gravity = {0, 0}});
  scene.add({.shapes = {circle(0.5)}, .velocity = velocity});
  return run_trial(scene, {.dt = standing_dt}, {.seconds = seconds, .stand_distance = distance});
}

/// A snapshot of one disc of radius 0.5 m at a place, under gravity.
Snapshot disc_at(const Vec2<double>& place) {
  Scene scene;
  scene.add({.shapes = {circle(0.5)}, .position = place});
  return snapshot(World<double>(scene));
}

}  // namespace

TEST_CASE("what slides away at once does not stand, though it has a second to settle") {
  // Half of its radius is 0.25 m: at 1 m/s it is there after 16 steps, and beyond it after the next.
  const TrialResult result = drifting_disc({1, 0}, 4, 0.03);
  REQUIRE(result.fell_at.has_value());
  CHECK(*result.fell_at == 17 * standing_dt);
}

TEST_CASE("what creeps stands while it settles, and falls when it is too far from where it then was") {
  // At 0.1 m/s it is 0.1 m off after a second, which is less than 0.25 m; after 0.3 s more it is 0.03 m on.
  const TrialResult result = drifting_disc({0, -0.1}, 4, 0.03);
  REQUIRE(result.fell_at.has_value());
  CHECK(*result.fell_at == 84 * standing_dt);  // the first multiple of the step beyond 1.3 s
  CHECK(drifting_disc({0, -0.1}, 1.28, 0.07).stands());
}

TEST_CASE("a short run settles for half of its time") {
  // Places are those after 0.25 s; at 0.1 m/s it is 0.02 m on after 0.2 s more.
  const TrialResult result = drifting_disc({0.1, 0}, 0.5, 0.02);
  REQUIRE(result.fell_at.has_value());
  CHECK(*result.fell_at == 29 * standing_dt);  // 0.25 s + 0.2 s = 28.8 steps
}

TEST_CASE("a distance that is wider than half the radius holds while the scene settles, too") {
  CHECK(drifting_disc({0.3, 0}, 2, 0.31).stands());        // 0.3 m, twice
  CHECK_FALSE(drifting_disc({0.3, 0}, 2, 0.29).stands());  // 0.3 m before it has settled
}

TEST_CASE("aside and down are bounded by the distance, up by half the radius") {
  const auto holds = [](const Vec2<double>& way) {
    Standing standing(disc_at({0, 0}), 0.03, 1);
    REQUIRE(standing.share(disc_at({0.1, 0.1}), 1) <= 1);  // settled there
    const Vec2<double> place = Vec2<double>(0.1, 0.1) + way;
    return standing.share(disc_at(place), 2) <= 1;
  };
  CHECK(holds({0.029, 0}));
  CHECK_FALSE(holds({0.031, 0}));
  CHECK(holds({0, -0.029}));
  CHECK_FALSE(holds({0, -0.031}));
  CHECK(holds({0.029, 0.2}));
  CHECK_FALSE(holds({0.031, 0.2}));
  CHECK(holds({0, 0.249}));
  CHECK_FALSE(holds({0, 0.251}));
}
