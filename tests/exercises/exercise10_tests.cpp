// Exercise 10: every misconception is told from the answer.
#include "lessons/10_what_is_stored/exercise.hpp"

#include "exercises/wrong_answers.hpp"
#include "math/list.hpp"

namespace cairn::exercise10 {
namespace {

using Rows = List<RowBodies>;
using Numbers = List<double>;

bool share(const RowBodies& i, const RowBodies& j) {
  return i.a == j.a || i.a == j.b || i.b == j.a || i.b == j.b;
}

int with_ground(const Rows& rows, const Numbers&) {
  int count = 0;
  for (const RowBodies& i : rows) {
    for (const RowBodies& j : rows) count += share(i, j) ? 1 : 0;
  }
  return count;
}

int all_pairs(const Rows& rows, const Numbers&) { return rows.size() * rows.size(); }

int once_for_each_body(const Rows& rows, const Numbers& inverse) {
  int count = 0;
  for (const RowBodies& i : rows) {
    for (const RowBodies& j : rows) {
      for (const int body : {i.a, i.b}) {
        const bool moves = inverse[body] > 0;
        count += moves && (body == j.a || body == j.b) ? 1 : 0;
      }
    }
  }
  return count;
}

int without_diagonal(const Rows& rows, const Numbers& inverse) {
  return entries(rows, inverse) - rows.size();
}

int one_half(const Rows& rows, const Numbers& inverse) { return (entries(rows, inverse) + rows.size()) / 2; }

int ground_for_ever(const Rows& rows, const Numbers& inverse) {
  Numbers without_tray = inverse;
  without_tray[0] = 0;
  return entries(rows, without_tray);
}

}  // namespace

TEST_CASE(
    "exercise 10 tells the ground, all pairs, pairs counted twice, a missing diagonal, one half and a tray "
    "taken for the ground") {
  CHECK(testing::tells<grade>(with_ground, "share the ground only"));
  CHECK(testing::tells<grade>(all_pairs, "share no body"));
  CHECK(testing::tells<grade>(once_for_each_body, "is one entry"));
  CHECK(testing::tells<grade>(without_diagonal, "The diagonal counts"));
  CHECK(testing::tells<grade>(one_half, "two halves"));
  CHECK(testing::tells<grade>(ground_for_ever, "The tray can move"));
}

}  // namespace cairn::exercise10
