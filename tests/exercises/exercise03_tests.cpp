// Exercise 03: every misconception is told from the answer.
#include "lessons/03_drift_and_baumgarte/exercise.hpp"

#include <algorithm>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise03 {
namespace {

bool speed_is_told(Answer answer, const std::string& misconception) {
  Grade marks;
  grade(marks, answer);
  return testing::names(marks, misconception);
}

double plain_speed(double depth, const Recovery& r) { return r.beta * depth / r.dt; }

}  // namespace

TEST_CASE("exercise 03 tells a sign, a missing beta or dt, a slop on the wrong side and a limit not kept") {
  CHECK(speed_is_told([](double d, const Recovery& r) { return -plain_speed(d, r); }, "The sign"));
  CHECK(speed_is_told([](double d, const Recovery& r) { return r.beta * d; }, "over dt"));
  CHECK(speed_is_told([](double d, const Recovery& r) { return d / r.dt; }, "Only the share beta"));
  CHECK(speed_is_told([](double d, const Recovery& r) { return r.beta * d * r.dt; }, "Divide by dt"));
  CHECK(speed_is_told(plain_speed, "The slop is not taken back"));
  CHECK(speed_is_told(plain_speed, "Within the slop nothing"));
  CHECK(speed_is_told(plain_speed, "not drawn together"));
  CHECK(speed_is_told(plain_speed, "The limit"));
  CHECK(speed_is_told([](double d, const Recovery& r) { return plain_speed(d + r.slop, r); },
                      "smaller, not larger"));
  CHECK(speed_is_told([](double d, const Recovery& r) { return plain_speed(d - r.slop, r); },
                      "never a negative"));
  CHECK(speed_is_told([](double d, const Recovery& r) { return plain_speed(d - r.slop, r); },
                      "not drawn together"));
}

}  // namespace cairn::exercise03
