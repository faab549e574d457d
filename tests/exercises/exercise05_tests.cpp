// Exercise 05: every misconception is told from the answer.
#include "lessons/05_sweep_and_bounds/exercise.hpp"

#include <algorithm>
#include <limits>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise05 {
namespace {

constexpr double without_end = std::numeric_limits<double>::infinity();

Interval free_interval(RowKind, double) { return {-without_end, without_end}; }
Interval push_interval(RowKind, double) { return {0, without_end}; }
Interval pull_interval(RowKind, double) { return {-without_end, 0}; }
Interval weak_interval(RowKind, double strength) { return {-strength, strength}; }

double unclamped(double lambda, const Interval&) { return lambda; }
double to_zero(double lambda, const Interval& i) { return lambda < i.lower || lambda > i.upper ? 0 : lambda; }
double swapped_ends(double lambda, const Interval& i) {
  return lambda < i.lower ? i.upper : (lambda > i.upper ? i.lower : lambda);
}
double always_upper(double, const Interval& i) { return i.upper; }

}  // namespace

TEST_CASE("exercise 05 tells intervals of other rows, and clamps that go elsewhere") {
  CHECK(testing::tells<grade>(Answer{free_interval, clamped}, "A contact does not pull"));
  CHECK(testing::tells<grade>(Answer{free_interval, clamped}, "A rope does not push"));
  CHECK(testing::tells<grade>(Answer{free_interval, clamped}, "A motor drives"));
  CHECK(testing::tells<grade>(Answer{push_interval, clamped}, "A joint pulls"));
  CHECK(testing::tells<grade>(Answer{push_interval, clamped}, "A rope pulls"));
  CHECK(testing::tells<grade>(Answer{pull_interval, clamped}, "A contact pushes"));
  CHECK(testing::tells<grade>(Answer{pull_interval, clamped}, "A joint pushes"));
  CHECK(testing::tells<grade>(Answer{weak_interval, clamped}, "A contact does not pull"));
  CHECK(testing::tells<grade>(Answer{push_interval, clamped}, "A motor brakes"));
  CHECK(testing::tells<grade>(Answer{interval_of, unclamped}, "Nothing was clamped"));
  CHECK(testing::tells<grade>(Answer{interval_of, to_zero}, "to its end, not to 0"));
  CHECK(testing::tells<grade>(Answer{interval_of, swapped_ends}, "the other end"));
  CHECK(testing::tells<grade>(Answer{interval_of, always_upper}, "in the interval stays"));
}

}  // namespace cairn::exercise05
