// Exercise 10, graded: stacks, boxes on the ground and a tray.
#include "exercise.hpp"
#include "math/list.hpp"

namespace cairn::exercise10 {
namespace {

/// n boxes on each other, `points` rows for each contact; body 0 is the ground.
List<RowBodies> stack_rows(int boxes, int points) {
  List<RowBodies> rows;
  for (int box = 0; box < boxes; ++box) {
    for (int point = 0; point < points; ++point) rows.push_back({box, box + 1});
  }
  return rows;
}

/// n boxes side by side on body 0.
List<RowBodies> side_by_side(int boxes) {
  List<RowBodies> rows;
  for (int box = 0; box < boxes; ++box) rows.push_back({0, box + 1});
  return rows;
}

List<double> masses(int boxes, double of_ground) {
  List<double> inverse(boxes + 1, 1);
  inverse[0] = of_ground;
  return inverse;
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  // A stack: n on the diagonal, and 2 (n - 1) beside it.
  grade.number(
      {.what = "3 boxes on each other, a row each",
       .value = 7,
       .tolerance = 0,
       .misconceptions = {{4, "The diagonal counts too: a row shares its bodies with itself."},
                          {9, "Rows 1 and 3 share no body; and a pair with two in common is one pair."},
                          {5, "A has two halves: A_ij and A_ji."}}},
      answer(stack_rows(3, 1), masses(3, 0)));
  // Four times as many with two rows a contact: each entry becomes a block of 2 x 2.
  grade.number({.what = "3 boxes on each other, two rows each", .value = 28, .tolerance = 0},
               answer(stack_rows(3, 2), masses(3, 0)));
  grade.number(
      {.what = "5 boxes side by side on the ground",
       .value = 5,
       .tolerance = 0,
       .misconceptions = {{25, "They share the ground only, and M⁻¹ of the ground is 0: so is A_ij."}}},
      answer(side_by_side(5), masses(5, 0)));
  grade.number({.what = "5 boxes on a tray that can move",
                .value = 25,
                .tolerance = 0,
                .misconceptions = {{5, "The tray can move: what pushes one box is felt by all rows."},
                                   {30, "A row has two bodies in common with itself, and is one entry."}}},
               answer(side_by_side(5), masses(5, 1)));
}

Exercise exercise() {
  return {.lesson = 10,
          .task = "How many entries of A are between rows that share a body which can move.",
          .file = "lessons/10_what_is_stored/exercise.cpp",
          .hints = {"For which pairs of rows is J_i M⁻¹ J_jᵀ not simply a sum of zeros?",
                    "Go through all pairs (i, j), also i = j, and look for a common body with an inverse "
                    "mass above 0.",
                    "count if (a of i moves and is a or b of j) or (b of i moves and is a or b of j)."},
          .grade = [](Grade& marks) { grade(marks, entries); }};
}

}  // namespace cairn::exercise10
