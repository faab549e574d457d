// The motion of what should rest, against motions that are formulas.
#include <cairn/study/shaking.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <cairn/world/world.hpp>

using namespace cairn;

namespace {

/// A disc of radius 0.5 m whose centre is there, and which is turned by so much.
Snapshot turned_disc(const Vec2<double>& place, double angle = 0) {
  Scene scene;
  scene.add({.shapes = {circle(0.5)}, .position = place, .angle = angle});
  return snapshot(World<double>(scene));
}

/// From second 1 on, of a disc that trembles sideways by `size` [m] at each of ten looks a second.
double trembling(double size) {
  Shaking shaking(1);
  for (int look = 0; look <= 20; ++look) shaking.see(turned_disc({look % 2 == 0 ? 0 : size, 0}), 0.1 * look);
  return shaking.speed();
}

}  // namespace

TEST_CASE("a body that trembles goes ten times its way in a second of ten looks") {
  CHECK(trembling(0.001) == doctest::Approx(0.01).epsilon(1e-12));
  CHECK(trembling(0) == 0);
}

TEST_CASE("a body that goes farther than a fiftieth of its radius does not rest, and is not looked at") {
  CHECK(trembling(0.0099) > 0);
  CHECK(trembling(0.0101) == 0);
}

TEST_CASE("a body that creeps gets on, and does not tremble") {
  Shaking shaking(0);
  for (int look = 0; look <= 10; ++look) shaking.see(turned_disc({0.0005 * look, 0}), 0.1 * look);
  CHECK(shaking.speed() < 1e-15);
}

TEST_CASE("what happens before the end is not looked at, and turning counts at the rim") {
  Shaking shaking(1);
  shaking.see(turned_disc({5, 0}), 0.5);
  shaking.see(turned_disc({0, 0}), 1);
  shaking.see(turned_disc({0, 0}, 0.002), 1.5);
  shaking.see(turned_disc({0, 0}), 2);
  CHECK(shaking.speed() == doctest::Approx(2 * 0.5 * 0.002).epsilon(1e-9));
  CHECK(Shaking(1).speed() == 0);
}

TEST_CASE("a body is as thin as its thinnest shape, and one without shapes is not thin at all") {
  Scene scene;
  const BodyId both = scene.add({.shapes = {box(2, 0.3), circle(0.1)}});
  const BodyId none = scene.add({.mass = 1, .inertia = 1});
  scene.add({.type = BodyType::static_body, .shapes = {box(1, 0.01)}});
  const Snapshot now = snapshot(World<double>(scene));
  CHECK(thickness_of(now.bodies[both]) == doctest::Approx(0.2).epsilon(1e-12));
  CHECK(thickness_of(now.bodies[none]) == std::numeric_limits<double>::infinity());
  CHECK(thinnest_body(now) == doctest::Approx(0.2).epsilon(1e-12));  // of what can be moved
}
