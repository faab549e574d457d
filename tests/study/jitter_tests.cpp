// Starts that differ a little.
#include <cairn/study/jitter.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include <cairn/geometry/shape.hpp>

using namespace cairn;

namespace {

Scene three_bodies() {
  Scene scene;
  scene.add_ground();
  scene.add({.shapes = {circle(1)}, .position = {0, 0}});
  scene.add({.type = BodyType::static_body, .shapes = {circle(1)}, .position = {5, 5}});
  scene.add({.shapes = {circle(1)}, .position = {0, 0}, .angle = 2});
  return scene;
}

}  // namespace

TEST_CASE("jitter has the bits of the 64-bit Mersenne twister, whose numbers the standard fixes") {
  // Its 10000th number for the default seed is given in the C++ standard.
  std::mt19937_64 generator;
  generator.discard(9999);
  CHECK(generator() == 9981545732273789042U);

  // The first 53 bits of each number n: 2 n / 2^53 - 1, computed here in another way.
  std::mt19937_64 numbers(7);
  const Scene result = jittered(three_bodies(), 0.5, 7);
  for (const BodyId body : {BodyId{1}, BodyId{3}}) {
    for (int axis = 0; axis < 2; ++axis) {
      const double expected = std::ldexp(static_cast<double>(numbers() / 2048), -53) - 0.5;
      CHECK(result.bodies()[body].pose.position[axis] == expected);
    }
  }
}

TEST_CASE("jitter moves dynamic bodies by up to its size along each axis, and nothing else") {
  const Scene scene = three_bodies();
  const double size = 1e-3;
  double largest = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Scene result = jittered(scene, size, seed);
    CHECK(result.bodies()[ground].pose.position == scene.bodies()[ground].pose.position);
    CHECK(result.bodies()[{2}].pose.position == scene.bodies()[{2}].pose.position);
    CHECK(result.bodies()[{3}].pose.angle == 2);
    largest = std::max(largest, result.bodies()[{1}].pose.position.cwiseAbs().maxCoeff());
  }
  CHECK(largest <= size);
  CHECK(largest >= 0.9 * size);  // of 200 numbers all are smaller with a chance of 0.9^200 = 7e-10
  CHECK(jittered(scene, 0, 1).bodies()[{1}].pose.position == scene.bodies()[{1}].pose.position);
  CHECK(jittered(scene, size, 1).bodies()[{1}].pose.position !=
        jittered(scene, size, 2).bodies()[{1}].pose.position);
}

TEST_CASE("a jitter of no size is refused") {
  CHECK_THROWS_AS(jittered(Scene(), -1, 0), std::invalid_argument);
  CHECK_THROWS_AS(jittered(Scene(), NAN, 0), std::invalid_argument);
}
