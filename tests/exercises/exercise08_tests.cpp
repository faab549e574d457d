// Exercise 08: every misconception is told from the answer.
#include "lessons/08_same_thing_twice/exercise.hpp"

#include "exercises/wrong_answers.hpp"
#include "math/list.hpp"

namespace cairn::exercise08 {
namespace {

using Matrix = List<List<double>>;
using Numbers = List<double>;

/// What the row still lacks, with `own` times its own impulse taken off too.
double lacking(int i, const Matrix& a, const Numbers& change, const Numbers& impulse, double own) {
  double sum = change[i];
  for (int k = 0; k < impulse.size(); ++k) sum -= (k == i ? own : 1) * a[i][k] * impulse[k];
  return sum;
}

double diagonal(int i, const Matrix& a) { return a[i][i]; }

double correction(int i, const Matrix& a, const Numbers& c, const Numbers& p) {
  return lacking(i, a, c, p, 1) / diagonal(i, a);
}

double undivided(int i, const Matrix& a, const Numbers& c, const Numbers& p) {
  return lacking(i, a, c, p, 0);
}

double other_sign(int i, const Matrix& a, const Numbers& c, const Numbers& p) {
  return -lacking(i, a, c, p, 0) / diagonal(i, a);
}

double alone(int i, const Matrix& a, const Numbers& c, const Numbers&) { return c[i] / diagonal(i, a); }

}  // namespace

TEST_CASE(
    "exercise 08 tells SI's correction from PGS' value, a missing diagonal, a sign and a row that is alone") {
  CHECK(testing::tells<grade>(correction, "the correction of SI"));
  CHECK(testing::tells<grade>(undivided, "Divide by A_ii"));
  CHECK(testing::tells<grade>(other_sign, "The sign"));
  CHECK(testing::tells<grade>(alone, "The other rows push"));
}

}  // namespace cairn::exercise08
