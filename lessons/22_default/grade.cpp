// Exercise 22, graded: a scene with every kind of body and row, and scenes at the border.
#include "exercise.cpp"

namespace cairn::exercise22 {
namespace {

template <typename T>
void add(List<T>& list, int count, const T& each) {
  for (int i = 0; i < count; ++i) list.push_back(each);
}

/// The counts are such that each mistake gives a number of its own.
void grade_freedoms(Grade& grade) {
  List<BodyKind> bodies;
  List<RowKind> rows;
  add(bodies, 10, {.moves = true, .turns = true});
  add(bodies, 2, {.moves = true});
  add(bodies, 5, {.turns = true});
  add(rows, 6, {.is_equality = true});
  add(rows, 1, {});
  add(rows, 4, {.is_equality = true, .is_soft = true});
  add(rows, 7, {.is_equality = true, .has_largest_force = true});
  grade.number(
      {.what = "10 bodies, 2 that slide, 5 static; 6 rigid rows: freedoms",
       .value = 10 * 3 + 2 * 2 - 6,
       .misconceptions = {{43, "A static body has no freedom: it never moves."},
                          {30, "A body that only slides has two."},
                          {18, "A body that turns has three."},
                          {34, "Each rigid row of a joint takes a freedom away."},
                          {40, "The sign: a row takes a freedom away."},
                          {27, "A limit stops one direction only: it takes no freedom away."},
                          {24, "A spring gives way: it takes no freedom away."},
                          {21, "A motor gives way above its largest force: it takes no freedom away."},
                          {17, "Springs and motors give way: they take no freedom away."},
                          {16, "Only rows that never give way count."},
                          {0, "Nothing was counted."}}},
      choose(bodies, rows, 1).freedoms);
}

/// So many bodies that turn, less rigid rows.
double at_once(int bodies, int rigid_rows) {
  List<BodyKind> all;
  List<RowKind> rows;
  add(all, bodies, {.moves = true, .turns = true});
  add(rows, rigid_rows, {.is_equality = true});
  return choose(all, rows, 1).at_once ? 1 : 0;
}

void grade_choice(Grade& grade) {
  const bool few = at_once(10, 0) == 1;
  const char* const turned = "Few freedoms are solved at once, and many are swept.";
  grade.number({.what = "300 freedoms, all rows at once (1: yes)",
                .value = 1,
                .misconceptions = {{0, few ? "Up to 300, and 300 too." : turned}}},
               at_once(100, 0));
  grade.number({.what = "301 freedoms: 101 bodies and 2 rigid rows",
                .value = 0,
                .misconceptions = {{1, few ? "Beyond 300 freedoms rows are swept." : turned}}},
               at_once(101, 2));
  const int eight = choose({}, {}, 8).substeps;
  grade.number({.what = "the scene asks for 1: substeps",
                .value = 4,
                .misconceptions = {{1, eight == 8 ? "Four at least, whatever the scene asks for."
                                                  : "Take the larger of both."}}},
               choose({}, {}, 1).substeps);
  grade.number({.what = "the scene asks for 8: substeps",
                .value = 8,
                .misconceptions = {{4, "It is eight if the scene asks for eight."}}},
               eight);
}

void grade(Grade& grade) {
  grade_freedoms(grade);
  grade_choice(grade);
}

}  // namespace

Exercise exercise() {
  return {.lesson = 22,
          .task = "The default for a scene: its freedoms, the way to solve, the substeps.",
          .file = "lessons/22_default/exercise.cpp",
          .hints = {"Which bodies can move, and in how many ways?",
                    "A row counts only if nothing makes it give way: no spring, no largest force, no limit.",
                    "3 or 2 a body that moves, less 1 a rigid row; at once up to 300; max(4, asked)."},
          .grade = grade};
}

}  // namespace cairn::exercise22
