// Exercise 08, graded: rows that stay, change places, come and go, bodies that feel them, a shorter and a
// longer step.
#include "exercise.cpp"

namespace cairn::exercise08 {
namespace {

constexpr double begin_rounding = 1e-14;  // a few operations on numbers near 1

/// The impulse that each row of these keys begins with, all of them between the ground and one body of 2 kg.
struct Begun {
  List<Row> rows = {};
  List<Body> bodies = {{.inverse_mass = 0}, {.inverse_mass = 0.5, .velocity = -4}};
};

Begun begun(const List<int>& keys, double dt_now) {
  const List<Kept> kept = {{.key = 7, .impulse = 3}, {.key = 4, .impulse = 2}, {.key = 9, .impulse = 1}};
  Begun result;
  for (const int key : keys) result.rows.push_back({.key = key, .below = 0, .above = 1});
  begin_step(result.rows, result.bodies, kept, dt_now, 0.02);
  return result;
}

constexpr const char* had = "A row that was there before begins with what it had.";
constexpr const char* undone =
    "A key that does not match says nothing: it must not set the impulse to 0 again.";

bool undoes(const Begun& same) { return same.rows[0].impulse == 0 && same.rows[2].impulse == 1; }

/// Rows that are found by their keys, in whatever order.
void grade_order(Grade& grade) {
  const Begun same = begun({7, 4, 9}, 0.02), other = begun({9, 7, 4}, 0.02);
  const double first = same.rows[0].impulse;
  grade.number({.what = "rows 7, 4, 9 as before: impulse of row 7 (N s)",
                .value = 3,
                .misconceptions = {{0, undoes(same) ? undone : had},
                                   {0.06, "What is kept is an impulse already: no further dt."}},
                .tolerance = begin_rounding},
               first);
  grade.number(
      {.what = "in the order 9, 7, 4: impulse of row 9 (N s)",
       .value = 1,
       .misconceptions = {{3, "That belongs to row 7: rows are known by their key, not by their place."},
                          {0, first == 0 ? had : "Row 9 is the last of `kept`: look at all of them."}},
       .tolerance = begin_rounding},
      other.rows[0].impulse);
}

/// Rows that come, and rows that go.
void grade_change(Grade& grade) {
  const Begun same = begun({7, 4, 9}, 0.02), changed = begun({5, 4}, 0.02);
  const double alone = begun({4}, 0.02).rows[0].impulse;
  grade.number({.what = "row 5 is new: its impulse (N s)",
                .value = 0,
                .misconceptions = {{3, "That belongs to row 7: a new row begins with 0."},
                                   {1, "That belongs to row 9: a new row begins with 0."},
                                   {2, "That belongs to row 4: a new row begins with 0."}},
                .tolerance = begin_rounding},
               changed.rows[0].impulse);
  grade.number({.what = "row 4 after it: its impulse (N s)",
                .value = 2,
                .misconceptions = {{0, alone == 2 ? "A new row must not end the loop: row 4 was there before."
                                       : undoes(same) ? undone
                                                      : had}},
                .tolerance = begin_rounding},
               changed.rows[1].impulse);
  Begun again = changed;
  begin_step(again.rows, again.bodies, {}, 0.02, 0.02);
  grade.number({.what = "nothing is kept: impulse of row 4 (N s)",
                .value = 0,
                .misconceptions = {{2, "A row that was not there begins with 0: set it."}},
                .tolerance = begin_rounding},
               again.rows[1].impulse);
  const bool felt = changed.bodies[1].velocity == -3;
  grade.number(
      {.what = "and by how much its body rises faster (m/s)",
       .value = 0,
       .misconceptions = {{-1, felt ? "The step begins anew: give the impulse, not its change." : ""}},
       .tolerance = begin_rounding},
      again.bodies[1].velocity - changed.bodies[1].velocity);
}

/// A body of 2 kg on the ground and one of 0.4 kg on top: rows 7 and 4 of the last step.
void grade_bodies(Grade& grade) {
  List<Row> rows = {{.key = 4, .below = 1, .above = 2}, {.key = 7, .below = 0, .above = 1}};
  List<Body> bodies = {{.inverse_mass = 0}, {.inverse_mass = 0.5}, {.inverse_mass = 2.5, .velocity = -0.25}};
  begin_step(rows, bodies, {{.key = 7, .impulse = 0.5}, {.key = 4, .impulse = 0.1}}, 0.02, 0.02);
  const bool is_guessed = std::abs(rows[0].impulse - 0.1) <= begin_rounding;
  const char* const acts = "The guess has to act: give the impulse to both bodies (line 4).";
  const char* const down = "Action and reaction: row 4 pushes the lower body down.";
  grade.number({.what = "0.1 N s upon 0.4 kg: velocity of the upper body (m/s)",
                .value = 0,
                .misconceptions = {{-0.25, is_guessed ? acts : ""},
                                   {-0.15, "An impulse changes a velocity by 1/m."},
                                   {-0.21, "An impulse changes a velocity by 1/m: multiply by inverse_mass."},
                                   {-0.245, "An impulse changes a velocity: no further dt."},
                                   {0.25, "Add to the velocity: do not replace it."},
                                   {-0.5, "The row pushes the body above up, not down."},
                                   {-0.2, "Each body has its own inverse mass."},
                                   {1, "That is the impulse of row 7: by key, not by place."}},
                .tolerance = begin_rounding},
               bodies[2].velocity);
  const bool rises = std::abs(bodies[2].velocity) <= begin_rounding;
  grade.number({.what = "0.5 - 0.1 N s upon 2 kg: velocity of the lower body (m/s)",
                .value = 0.2,
                .misconceptions = {{0.25, rises ? down : ""},
                                   {0.3, "Action and reaction: row 4 pushes the lower body down, not up."}},
                .tolerance = begin_rounding},
               bodies[1].velocity);
  const bool is_right = std::abs(bodies[1].velocity - 0.2) <= begin_rounding;
  List<Row> other = {{.key = 7, .below = 2, .above = 1}};
  List<Body> apart = {{.inverse_mass = 0}, {.inverse_mass = 0.5}, {.inverse_mass = 2.5}};
  begin_step(other, apart, {{.key = 7, .impulse = 0.5}}, 0.02, 0.02);
  grade.number(
      {.what = "a row from body 2 up to body 1: velocity of body 2 (m/s)",
       .value = -1.25,
       .misconceptions = {{0, is_right ? "A row says which bodies it has: row.below, row.above." : ""}},
       .tolerance = begin_rounding},
      apart[2].velocity);
}

void grade_steps(Grade& grade) {
  const Begun shorter = begun({7}, 0.01), same = begun({7}, 0.02), longer = begun({7}, 0.03);
  const char* const ratio = "Steps grow as well as shrink: always dt_now / dt_before.";
  const bool is_scaled = shorter.rows[0].impulse == 1.5, acts = same.bodies[1].velocity == -2.5;
  grade.number({.what = "half the step: impulse of row 7 (N s)",
                .value = 1.5,
                .misconceptions = {{3, "The force stays, and the impulse is force times dt: half of it."},
                                   {6, "A shorter step needs less, not more."},
                                   {0.75, "dt_now / dt_before comes in once."}},
                .tolerance = begin_rounding},
               shorter.rows[0].impulse);
  grade.number({.what = "half the step: velocity of its body of 2 kg (m/s)",
                .value = -4 + 0.75,
                .misconceptions = {{-2.5, is_scaled && acts ? "The bodies get the scaled impulse too." : ""}},
                .tolerance = begin_rounding},
               shorter.bodies[1].velocity);
  grade.number(
      {.what = "one and a half of the step: impulse of row 7 (N s)",
       .value = 4.5,
       .misconceptions = {{3, is_scaled ? ratio : "The force stays, and the step is longer: more of it."},
                          {1.5, ratio},
                          {2, "A longer step needs more, not less."}},
       .tolerance = begin_rounding},
      longer.rows[0].impulse);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 8,
      .task = "Lines 1 to 6 of Algorithm 1: each row's impulse by its key, scaled with dt, and applied.",
      .file = "lessons/08_warm_start/exercise.cpp",
      .hints = {"Where in `kept` is the row of this key, if it is there at all?",
                "A row that is not there begins with 0, the others with the same force as before; then the "
                "impulse acts on both bodies.",
                "impulse dt_now / dt_before; velocity -= 1/m impulse below, += 1/m impulse above."},
      .grade = [](Grade& grade) {
        grade_order(grade);
        grade_change(grade);
        grade_bodies(grade);
        grade_steps(grade);
      }};
}

}  // namespace cairn::exercise08
