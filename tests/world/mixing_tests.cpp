// What two surfaces have in common, by rule or by pair.
#include "testing.hpp"

using namespace cairn;
using namespace cairn::testing;

namespace {

// Sums of 30 steps, each solved to a few roundings.
const double sums = 1e-9;

}  // namespace

TEST_CASE("what two surfaces have in common follows by the rule of the scene, or is that of the pair") {
  const Material one = {.friction = 0.2, .static_friction = 0.4, .restitution = 0.25};
  const Material other = {.friction = 0.8, .restitution = 0.5};
  const auto of = [&](MixingRule rule) { return mixed({rule, rule}, {1}, one, {2}, other); };
  CHECK(of(MixingRule::geometric_mean).friction == doctest::Approx(0.4));
  CHECK(of(MixingRule::geometric_mean).static_friction == doctest::Approx(std::sqrt(0.32)));
  CHECK(of(MixingRule::minimum).friction == 0.2);
  CHECK(of(MixingRule::average).friction == doctest::Approx(0.5));
  CHECK(of(MixingRule::maximum).restitution == 0.5);
  CHECK(of(MixingRule::product).restitution == doctest::Approx(0.125));
  Mixing mixing;
  mixing.pairs = {{.a = {{1}, {3}}, .b = {{2}}, .friction = 0.1, .restitution = 0}};
  CHECK(mixed(mixing, {2}, other, {3}, one).friction == 0.1);
  CHECK(mixed(mixing, {1}, one, {2}, other).static_friction == 0.1);
  CHECK(mixed(mixing, {2}, other, {3}, one).restitution == 0);
  CHECK(mixed(mixing, {1}, one, {3}, other).friction == doctest::Approx(0.4));
}

TEST_CASE("a scene with a rule or a pair slides and rebounds by it") {
  const auto speed = [](const Mixing& mixing) {
    Scene scene;
    scene.add_ground({.material = {.friction = 0.1, .restitution = 0}});
    scene.add(
        {.shapes = {box(1, 0.5)}, .position = {0, 0.25}, .velocity = {5, 0}, .material = {.friction = 0.4}});
    SceneSettings settings = scene.settings();
    settings.mixing = mixing;
    scene.set_settings(settings);
    return velocity_of(world_after(scene, 30, 60), {1}).x();
  };
  CHECK(speed({}) == doctest::Approx(5 - 0.2 * 5).epsilon(sums));
  CHECK(speed({.friction = MixingRule::minimum}) == doctest::Approx(5 - 0.1 * 5).epsilon(sums));
  CHECK(speed({.friction = MixingRule::maximum}) == doctest::Approx(5 - 0.4 * 5).epsilon(sums));
  Mixing ice;
  ice.pairs = {{.a = {ground}, .b = {{1}}, .friction = 0}};
  CHECK(speed(ice) == doctest::Approx(5).epsilon(sums));
}

TEST_CASE("surfaces out of range are refused by name") {
  Scene scene;
  scene.add_ground();
  const auto add = [&scene](const Material& material) {
    scene.add({.shapes = {circle(1)}, .material = material});
  };
  CHECK_THROWS_WITH_AS(add({.friction = 0.5, .static_friction = 0.4}),
                       "Scene::add: static_friction must be from friction, 0.5, to 1e6, got 0.4",
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(add({.rolling_resistance = -1}),
                       "Scene::add: rolling_resistance must be >= 0 m and finite, got -1",
                       std::invalid_argument);
  CHECK_THROWS_AS(add({.static_friction = std::numeric_limits<double>::quiet_NaN()}), std::invalid_argument);
  const auto set = [&scene](const PairMaterial& pair) {
    SceneSettings settings = scene.settings();
    settings.mixing.pairs = {pair};
    scene.set_settings(settings);
  };
  CHECK_THROWS_AS(set({.a = {ground}, .b = {{7}}, .friction = 1}), std::invalid_argument);
  CHECK_THROWS_AS(set({.a = {}, .b = {ground}, .friction = 1}), std::invalid_argument);
  CHECK_THROWS_AS(set({.a = {ground}, .b = {ground}, .restitution = 2}), std::invalid_argument);
}
