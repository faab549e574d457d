// A hand that drags bodies of a world, and repeats what it did.
#include "yard.hpp"

namespace cairn {

using namespace testing;

TEST_CASE("a hand drags a body to where it pulls, wakes it, and lets go") {
  Yard yard({.sleeping = Sleeping{}});
  World<double> world(yard.scene);
  take_steps(world, 120);
  REQUIRE(!world.is_awake(yard.lonely));
  world.move_hand(
      HandInput::grab({.body = yard.lonely, .anchor = {-20, 0.5}, .target = {-20, 0.5}, .max_force = 200}));
  for (int i = 0; i < 120; ++i) {
    world.move_hand(HandInput::drag_to({-20 + 0.02 * i, 3}));
    take_steps(world, 1);
  }
  take_steps(world, 60);
  CHECK(world.is_awake(yard.lonely));
  // The spring of 5 Hz gives way to the weight by g / omega^2.
  const double sag = 10 / std::pow(2 * pi * 5, 2);
  CHECK(world.bodies().pose[yard.lonely].position.y() == doctest::Approx(3 - sag).epsilon(0.002));
  CHECK(world.bodies().pose[yard.lonely].position.x() == doctest::Approx(-20 + 0.02 * 119).epsilon(0.002));
  const Snapshot seen = snapshot(world);
  CHECK(seen.joints.back().name == "drag");
  CHECK(seen.joints.back().impulse.y() / seen.dt == doctest::Approx(10).epsilon(0.01));  // its weight: 1 kg
  world.move_hand(HandInput::let_go());
  CHECK(world.hand().joint() == nullptr);
  take_steps(world, 30);
  CHECK(world.bodies().pose[yard.lonely].position.y() < 2.5);
}

TEST_CASE("a run with a hand is repeated from its inputs, over edits and sleep") {
  const auto begin = [] { return World<double>(Yard({.sleeping = Sleeping{}}).scene); };
  const BodyId top = Yard().pile[5];
  const auto add_ball = [](Scene& scene) { scene.add({.shapes = {circle(0.3)}, .position = {0, 9}}); };
  World<double> world = begin();
  for (int i = 0; i < 200; ++i) {
    if (i == 50) world.move_hand(HandInput::grab({.body = top, .anchor = {0.3, 4.6}, .target = {1, 5}}));
    if (i > 50 && i < 120) world.move_hand(HandInput::drag_to({1 + 0.03 * (i - 50), 5 + std::sin(0.1 * i)}));
    if (i == 80) world.edit(add_ball);
    if (i == 120) world.move_hand(HandInput::let_go());
    take_steps(world, 1);
  }
  World<double> again = begin();
  auto input = world.hand().inputs().begin();
  for (int i = 0; i < 200; ++i) {
    for (; input != world.hand().inputs().end() && input->step == i; ++input) again.move_hand(*input);
    if (i == 80) again.edit(add_ball);
    take_steps(again, 1);
  }
  CHECK(go_alike(world, again));
  CHECK(again.hand().inputs().size() == world.hand().inputs().size());
}

TEST_CASE("a hand refuses what it cannot hold and targets without a grip") {
  World<double> world(Yard().scene);
  CHECK_THROWS_AS(world.move_hand(HandInput::drag_to({0, 0})), std::invalid_argument);
  CHECK_THROWS_AS(world.move_hand(HandInput::grab({.body = ground})), std::invalid_argument);
  CHECK_THROWS_AS(world.move_hand(HandInput::grab({.body = {99}})), std::invalid_argument);
  CHECK(world.hand().joint() == nullptr);
  world.move_hand(HandInput::grab({.body = {1}}));
  CHECK_THROWS_AS(world.move_hand(HandInput::drag_to({std::numeric_limits<double>::quiet_NaN(), 0})),
                  std::invalid_argument);
  CHECK(world.hand().inputs().size() == 1);
  // What it holds goes: so does the hand.
  world.edit([](Scene& scene) { scene.remove(BodyId{1}); });
  CHECK(world.hand().joint() == nullptr);
}

}  // namespace cairn
