// Exercise 12: every misconception is told from the answer.
#include "lessons/12_blocks/exercise.hpp"

#include "exercises/wrong_answers.hpp"
#include "math/list.hpp"

namespace cairn::exercise12 {
namespace {

using Two = FixedList<double, 2>;

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
  CHECK(testing::tells<grade>(each_alone, "Each row for itself"));
  CHECK(testing::tells<grade>(undivided, "The determinant"));
  CHECK(testing::tells<grade>(plus_sign, "The sign of k12"));
  CHECK(testing::tells<grade>(unswapped, "change places"));
  CHECK(testing::tells<grade>(other_sign, "The sign: K x"));
}

}  // namespace cairn::exercise12
