// Exercise 10, graded: stacks, boxes on the ground, on a tray and at a wall; boxes of 2 and 0.5 kg in turn.
#include "exercise.cpp"

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
  List<double> inverse = {of_ground};
  for (int box = 0; box < boxes; ++box) inverse.push_back(box % 2 == 0 ? 0.5 : 2);
  return inverse;
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 10,
      .task = "How many entries of A are between rows that share a body which can move.",
      .file = "lessons/10_what_is_stored/exercise.cpp",
      .hints = {"For which pairs of rows is J_i M⁻¹ J_jᵀ not simply a sum of zeros?",
                "Go through all pairs (i, j), also i = j, and look for a common body with an inverse "
                "mass above 0.",
                "Count if (a of i moves and is a or b of j) or (b of i moves and is a or b of j)."},
      .grade = [](Grade& grade) {
        const char* const cross =
            "Four comparisons: the a and the b of row i, each with the a and the b of row j.";
        const char* const both = "One shared body that can move is enough: or, not and.";
        const double two = entries(stack_rows(4, 2), masses(4, 0));
        const double beside = entries(side_by_side(5), masses(5, 0));
        // A stack: n on the diagonal, and 2 (n - 1) beside it.
        grade.number(
            {.what = "4 boxes on each other, a row each",
             .value = 10,
             .misconceptions = {{6, "The diagonal counts too: a row shares its bodies with itself."},
                                {7, two == 28 ? cross : "A has two halves: A_ij and A_ji."},
                                {3, two == 16 ? "A has two halves, A_ij and A_ji, and a diagonal." : both},
                                {8, beside == 0
                                        ? both
                                        : "A row is left out: begin with row 0, and end with the last."},
                                {9, "The first row meets its neighbour as well: box 1 can move."},
                                {1, "It is bodies that can move that couple: an inverse mass above 0."},
                                {16, "Rows 1 and 3 share no body: their entry is 0."},
                                {13, "A pair of rows that shares two bodies is one entry, not two."},
                                {4,
                                 "A row meets its neighbours: the first body of one row may be the second of "
                                 "another."},
                                {0, "A body can move whatever its mass: the inverse mass is above 0."}},
             .tolerance = 0},
            entries(stack_rows(4, 1), masses(4, 0)));
        // Each entry becomes a block of 2 x 2.
        grade.number({.what = "4 boxes on each other, two rows each",
                      .value = 40,
                      .misconceptions = {{22, "Rows share bodies, whatever their places: look at all pairs."},
                                         {28, cross}},
                      .tolerance = 0},
                     two);
        grade.number(
            {.what = "5 boxes side by side on the ground",
             .value = 5,
             .misconceptions = {{25, "They share the ground only, and M⁻¹ of the ground is 0: so is A_ij."}},
             .tolerance = 0},
            beside);
        grade.number({.what = "5 boxes on a tray that can move",
                      .value = 25,
                      .misconceptions = {{5, "The tray can move: it couples all rows that act on it."},
                                         {30, "A row shares two bodies with itself: one entry, not two."}},
                      .tolerance = 0},
                     entries(side_by_side(5), masses(5, 0.25)));
        // Body 3 is the wall, and the second body of its rows.
        grade.number(
            {.what = "3 boxes at a wall, two of them also at each other",
             .value = 8,
             .misconceptions = {{14, "The wall cannot move, and it is the second body of its rows."}},
             .tolerance = 0},
            entries({{0, 3}, {1, 3}, {2, 3}, {0, 1}}, {0.5, 2, 0.5, 0}));
      }};
}

}  // namespace cairn::exercise10
