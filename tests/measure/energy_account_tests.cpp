// What gains and losses of energy are held against.
#include "testing.hpp"

using namespace cairn;

namespace {

/// A ball of 2 kg and 0.2 m at a height and with a speed downwards, at 10 m/s^2.
Snapshot falling_ball(double height, double speed) {
  Scene scene;
  scene.add({.shapes = {circle(0.1)}, .position = {0, height}, .velocity = {0, -speed}, .mass = 2});
  return snapshot(World<double>(scene));
}

}  // namespace

TEST_CASE("a ball that falls 2 m and lies has lost all that it had, and no more") {
  EnergyAccount account(falling_ball(2.1, 0));
  // 20 N through the diagonal of the box around it, until it has come farther.
  CHECK(account.scale() == doctest::Approx(20 * 0.2 * std::sqrt(2.0)).epsilon(1e-12));
  account.see(falling_ball(1.1, std::sqrt(20.0)));
  CHECK(account.change() == doctest::Approx(0).scale(20).epsilon(1e-12));
  CHECK(account.scale() == doctest::Approx(20).epsilon(1e-12));
  account.see(falling_ball(0.1, 0));
  CHECK(account.scale() == doctest::Approx(40).epsilon(1e-12));
  CHECK(account.change() / account.scale() == doctest::Approx(-1).epsilon(1e-12));
}

TEST_CASE("what is given from outside is no gain, and belongs to the scale") {
  EnergyAccount account(falling_ball(2, 0));
  account.give(9);
  account.see(falling_ball(2, 3));
  CHECK(account.change() == doctest::Approx(0).scale(9).epsilon(1e-12));
  CHECK(account.scale() == doctest::Approx(9).epsilon(1e-12));
  account.scene_changed(falling_ball(2, 4));  // 16 J
  CHECK(account.change() == doctest::Approx(0).scale(16).epsilon(1e-12));
  account.see(falling_ball(2, 5));
  CHECK(account.change() == doctest::Approx(9).epsilon(1e-12));
}

TEST_CASE("a motor gives its power, and a body that moves by itself twice its speed at every meeting") {
  Scene scene;
  const BodyId wheel = scene.add({.shapes = {circle(1)}, .mass = 8});
  CHECK(Drive(scene).most_energy(3, 100, 100) == doctest::Approx(3).epsilon(1e-12));
  Scene with_wall = scene;
  with_wall.add({.type = BodyType::kinematic,
                 .shapes = {circle(0.5)},
                 .position = {9, 0},
                 .velocity = {3, 4},
                 .angular_velocity = 2});
  // From sqrt(2 E / m) = 3 m/s to 3 + 2 * 6 m/s of 8 kg.
  CHECK(Drive(with_wall).most_energy(36, 1, 1) == doctest::Approx(0.5 * 8 * 15 * 15).epsilon(1e-12));
  scene.join<RevoluteJoint>({.b = wheel, .motor = RevoluteJoint::Motor{.speed = -2, .max_torque = 5}});
  CHECK(Drive(scene).most_energy(3, 4, 100) == doctest::Approx(3 + 5 * 2 * 4).epsilon(1e-12));
}
