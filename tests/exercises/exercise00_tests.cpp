// Exercise 00: every misconception is told from the answer.
#include "lessons/00_one_body/exercise.hpp"

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise00 {
namespace {

void place_first(Falling& body, double acceleration, double dt) {
  body.height += body.velocity * dt;
  body.velocity += acceleration * dt;
}

void parabola(Falling& body, double acceleration, double dt) {
  body.height += body.velocity * dt + acceleration * dt * dt / 2;
  body.velocity += acceleration * dt;
}

void without_dt(Falling& body, double acceleration, double) { body.velocity += acceleration; }

void other_sign(Falling& body, double acceleration, double dt) { body.velocity -= acceleration * dt; }

void without_gravity(Falling& body, double, double dt) { body.height += body.velocity * dt; }

}  // namespace

TEST_CASE("exercise 00 tells explicit Euler, the parabola, a forgotten dt and a sign") {
  CHECK(testing::tells<grade>(place_first, "explicit Euler"));
  CHECK(testing::tells<grade>(parabola, "the parabola itself"));
  CHECK(testing::tells<grade>(without_dt, "a change of velocity"));
  CHECK(testing::tells<grade>(without_dt, "The height has not changed"));
  CHECK(testing::tells<grade>(other_sign, "The sign"));
  CHECK(testing::tells<grade>(without_gravity, "The velocity has not changed"));
  CHECK(testing::tells<grade>(without_gravity, "Gravity has not"));
}

}  // namespace cairn::exercise00
