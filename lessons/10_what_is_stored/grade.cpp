// Exercise 10, graded: stacks, boxes on the ground, on a tray and at a wall; boxes of 2 and 0.5 kg in turn;
// how often rows are looked at, and for how long.
#include <ctime>

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

/// On each other: what the answer gives with a row for each contact, and with two.
void grade_stacks(Grade& grade, double beside) {
  const char* const filed = "File a row under both of its bodies, and go from a row to both of its bodies.";
  const double one = entries(Rows(stack_rows(4, 1)), masses(4, 0));
  const double two = entries(Rows(stack_rows(4, 2)), masses(4, 0));
  // A stack: n on the diagonal, and 2 (n - 1) beside it.
  grade.number(
      {.what = "4 boxes on each other, a row each",
       .value = 10,
       .misconceptions =
           {{6, two == 24 ? filed : "The diagonal counts too: a row shares its bodies with itself."},
            {7, two == 28 ? filed : "A has two halves: A_ij and A_ji."},
            {3, two == 12 ? filed : "A has two halves, A_ij and A_ji, and a diagonal."},
            {8, beside == 0 ? "One body that can move is enough: rows on the ground count as well."
                            : "A row is left out: begin with row 0, and end with the last."},
            {1, "It is bodies that can move that couple: an inverse mass above 0."},
            {16, "Rows 1 and 3 share no body: their entry is 0."},
            {13, "A pair of rows that shares two bodies is one entry, not two."},
            {4, "A row meets its neighbours: the first body of one row may be the second of another."},
            {0, "A body can move whatever its mass: the inverse mass is above 0."}},
       .tolerance = 0},
      one);
  // Each entry becomes a block of 2 x 2.
  grade.number({.what = "4 boxes on each other, two rows each",
                .value = 40,
                .misconceptions = {{22, "Rows share bodies, whatever their places in the list."}},
                .tolerance = 0},
               two);
}

/// Beside each other: what couples is a body that can move.
void grade_grounds(Grade& grade, double beside) {
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
               entries(Rows(side_by_side(5)), masses(5, 0.25)));
  // Body 3 is the wall, and the second body of its rows.
  grade.number({.what = "3 boxes at a wall, two of them also at each other",
                .value = 8,
                .misconceptions = {{14, "The wall cannot move, and it is the second body of its rows."}},
                .tolerance = 0},
               entries(Rows({{0, 3}, {1, 3}, {2, 3}, {0, 1}}), {0.5, 2, 0.5, 0}));
}

/// Looks at a copy of the rows are not counted, but all pairs of so many take more than a second.
void grade_time(Grade& grade) {
  constexpr int boxes = 4000;
  constexpr double most = 0.25;  // [s] ten times as long as the model answer, without an optimiser
  const Rows rows(stack_rows(boxes, 2));
  const List<double> inverse_mass = masses(boxes, 0);
  const std::clock_t begin = std::clock();
  const int counted = entries(rows, inverse_mass);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  grade.number({.what = "4000 boxes, two rows each", .value = 4 * (3 * boxes - 2), .tolerance = 0}, counted);
  grade.number({.what = "processor time for them above 0.25 s", .value = 0, .tolerance = 0},
               std::max(0.0, seconds - most));
  if (seconds > most)
    grade.explain("That time is that of all pairs, also if it is a copy that is looked at.");
}

/// A row of a stack meets six at most: whoever looks at all pairs, looks at each row 2000 times.
void grade_looks(Grade& grade) {
  constexpr int boxes = 1000;
  constexpr long most = 32;  // at each row: eight times as often as the model answer
  const Rows rows(stack_rows(boxes, 2));
  const int counted = entries(rows, masses(boxes, 0));
  grade.number({.what = "1000 boxes, two rows each", .value = 4 * (3 * boxes - 2), .tolerance = 0}, counted);
  const long looks = rows.looks() / rows.size();
  grade.number({.what = "how often each row was looked at, above 32", .value = 0, .tolerance = 0},
               static_cast<double>(std::max(0L, looks - most)));
  if (looks > most)
    grade.explain("Each row looked at every other: keep for each body the rows that act on it, and ask it.");
  else if (counted == 4 * (3 * boxes - 2))
    grade_time(grade);
}

}  // namespace

Exercise exercise() {
  return {.lesson = 10,
          .task = "How many entries of A are between rows that share a body which can move, in time.",
          .file = "lessons/10_what_is_stored/exercise.cpp",
          .hints = {"Which rows act on a body? Write that down first, for each body that can move.",
                    "A row meets the rows of its two bodies, itself among them.",
                    "Who is on both bodies must count once: remember the last row that met each."},
          .grade = [](Grade& grade) {
            const double beside = entries(Rows(side_by_side(5)), masses(5, 0));
            grade_stacks(grade, beside);
            grade_grounds(grade, beside);
            grade_looks(grade);
          }};
}

}  // namespace cairn::exercise10
