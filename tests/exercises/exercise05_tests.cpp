// Exercise 05: every misconception is told from the answer.
#include "lessons/05_sweep_and_bounds/exercise.hpp"

#include <algorithm>
#include <limits>

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise05 {
namespace {

bool is_told(Answer answer, const std::string& misconception) {
  Grade marks;
  grade(marks, answer);
  return testing::names(marks, misconception);
}

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
  CHECK(is_told({free_interval, clamped}, "A contact does not pull"));
  CHECK(is_told({free_interval, clamped}, "A rope does not push"));
  CHECK(is_told({free_interval, clamped}, "A motor drives"));
  CHECK(is_told({push_interval, clamped}, "A joint pulls"));
  CHECK(is_told({push_interval, clamped}, "A rope pulls"));
  CHECK(is_told({pull_interval, clamped}, "A contact pushes"));
  CHECK(is_told({pull_interval, clamped}, "A joint pushes"));
  CHECK(is_told({weak_interval, clamped}, "A contact does not pull"));
  CHECK(is_told({push_interval, clamped}, "A motor brakes"));
  CHECK(is_told({interval_of, unclamped}, "Nothing was clamped"));
  CHECK(is_told({interval_of, to_zero}, "to its end, not to 0"));
  CHECK(is_told({interval_of, swapped_ends}, "the other end"));
  CHECK(is_told({interval_of, always_upper}, "in the interval stays"));
}

}  // namespace cairn::exercise05
