// Exercise 12: every misconception is told from the answer.
#include "lessons/12_blocks/exercise.hpp"

#include "exercises/wrong_answers.hpp"

namespace cairn::exercise12 {
namespace {

bool is_told(Answer answer, const std::string& misconception) {
  Grade marks;
  grade(marks, answer);
  return testing::names(marks, misconception);
}

using Two = std::array<double, 2>;

double determinant(double k11, double k12, double k22) { return k11 * k22 - k12 * k12; }

Two each_alone(double k11, double, double k22, const Two& c) { return {c[0] / k11, c[1] / k22}; }

Two undivided(double k11, double k12, double k22, const Two& c) {
  return {k22 * c[0] - k12 * c[1], k11 * c[1] - k12 * c[0]};
}

Two plus_sign(double k11, double k12, double k22, const Two& c) {
  const double d = determinant(k11, k12, k22);
  return {(k22 * c[0] + k12 * c[1]) / d, (k11 * c[1] + k12 * c[0]) / d};
}

Two unswapped(double k11, double k12, double k22, const Two& c) {
  const double d = determinant(k11, k12, k22);
  return {(k11 * c[0] - k12 * c[1]) / d, (k22 * c[1] - k12 * c[0]) / d};
}

Two other_sign(double k11, double k12, double k22, const Two& c) {
  const Two x = undivided(k11, k12, k22, c);
  const double d = determinant(k11, k12, k22);
  return {-x[0] / d, -x[1] / d};
}

}  // namespace

TEST_CASE("exercise 12 tells rows solved alone, a missing determinant, signs and places in the inverse") {
  CHECK(is_told(each_alone, "Each row for itself"));
  CHECK(is_told(undivided, "The determinant"));
  CHECK(is_told(plus_sign, "The sign of k12"));
  CHECK(is_told(unswapped, "change places"));
  CHECK(is_told(other_sign, "The sign: K x"));
}

}  // namespace cairn::exercise12
