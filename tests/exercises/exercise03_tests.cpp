// Exercise 03: every misconception is told from the answer.
#include "lessons/03_drift_and_baumgarte/exercise.hpp"

#include <algorithm>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise03 {
namespace {

double plain_speed(double depth, const Recovery& r) { return r.beta * depth / r.dt; }

}  // namespace

TEST_CASE("exercise 03 tells a sign, a missing beta or dt, a slop on the wrong side and a limit not kept") {
  CHECK(testing::tells<grade>([](double d, const Recovery& r) { return -plain_speed(d, r); }, "The sign"));
  CHECK(testing::tells<grade>([](double d, const Recovery& r) { return r.beta * d; }, "over dt"));
  CHECK(testing::tells<grade>([](double d, const Recovery& r) { return d / r.dt; }, "Only the share beta"));
  CHECK(testing::tells<grade>([](double d, const Recovery& r) { return r.beta * d * r.dt; }, "Divide by dt"));
  CHECK(testing::tells<grade>(plain_speed, "The slop is not taken back"));
  CHECK(testing::tells<grade>(plain_speed, "Within the slop nothing"));
  CHECK(testing::tells<grade>(plain_speed, "not drawn together"));
  CHECK(testing::tells<grade>(plain_speed, "The limit"));
  CHECK(testing::tells<grade>([](double d, const Recovery& r) { return plain_speed(d + r.slop, r); },
                              "smaller, not larger"));
  CHECK(testing::tells<grade>([](double d, const Recovery& r) { return plain_speed(d - r.slop, r); },
                              "never a negative"));
  CHECK(testing::tells<grade>([](double d, const Recovery& r) { return plain_speed(d - r.slop, r); },
                              "not drawn together"));
}

}  // namespace cairn::exercise03
