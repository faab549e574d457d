// Exercise 12, graded: a rod of 2 kg on a pin in the ground, and a pin between bodies of 2 and 0.5 kg.
#include "exercise.cpp"

namespace cairn::exercise12 {
namespace {

constexpr double block_rounding = 1e-13;  // a few dozen operations on numbers up to 20

using Pair = FixedList<double, 2>;

/// A symmetric block of A, right or wrong [1/kg].
struct Block {
  double k11 = 0, k12 = 0, k22 = 0;
};

Pair solved(const Block& k, const Pair& jv, double determinant) {
  return {-(k.k22 * jv[0] - k.k12 * jv[1]) / determinant, -(k.k11 * jv[1] - k.k12 * jv[0]) / determinant};
}

Pair solved(const Block& k, const Pair& jv) { return solved(k, jv, k.k11 * k.k22 - k.k12 * k.k12); }

struct Scene {
  Pin pin = {};
  Body one = {};
  Body two = {};
};

/// k11 = 2.5 + 2.5/4 + 4, k12 = -2.5/2 + 2, k22 = 2.5 + 2.5 + 1, and j·v = -K (1, -2): the pin has to give
/// 1 and -2 N s.
Scene two_bodies() {
  return {.pin = {.r1x = 1, .r1y = 0.5, .r2x = -0.5, .r2y = 1},
          .one = {.inverse_mass = 0.5, .inverse_inertia = 2.5},
          .two = {.inverse_mass = 2, .inverse_inertia = 4, .vx = -5.625, .vy = 11.25}};
}

constexpr Block right = {7.125, 0.75, 6};

bool is_near(const Pair& got, const Pair& value) {
  return std::abs(got[0] - value[0]) <= block_rounding && std::abs(got[1] - value[1]) <= block_rounding;
}

struct Wrong {
  Pair impulse = {};
  const char* what = "";
};

List<Wrong> wrong_impulses() {
  const Pair jv = {-5.625, 11.25};
  const double x = 5.625 / right.k11, y = -11.25 / right.k22;
  return {{{x, -jv[1] / right.k22}, "Each row for itself: the other row's impulse comes in by k12."},
          {{x, -(jv[1] + right.k12 * x) / right.k22},
           "That is one visit to each row, as in a sweep row by row: solve both together."},
          {solved({right.k11, -right.k12, right.k22}, jv),
           "The sign of k12: −r_x r_y/I, and the inverse turns it."},
          {solved({right.k22, right.k12, right.k11}, jv),
           "k11 and k22 change places in the inverse; and r_y² belongs to k11, r_x² to k22."},
          {solved(right, jv, 1), "The determinant: divide by k11 k22 − k12²."},
          {solved(right, jv, right.k11 * right.k22 + right.k12 * right.k12),
           "The determinant is k11 k22 − k12²."},
          {{-1, 2}, "The sign: the pin has to make both row velocities 0."},
          {{-(jv[0] + right.k12 * y) / right.k11, y},
           "That is one visit to each row, as in a sweep row by row: solve both together."},
          {solved({6, 2, 3}, jv), "Both bodies give way: sum over both."},
          {solved({1.125, -1.25, 3}, jv), "Both bodies give way: sum over both."},
          {solved({5.025, 0.75, 3.9}, jv), "Inverse masses add up: 1/m of one and 1/m of the other."},
          {solved({right.k11, -1.25, right.k22}, jv), "k12 has a term −r_x r_y/I of each body."},
          {solved({right.k11, 2, right.k22}, jv), "k12 has a term −r_x r_y/I of each body."},
          {solved({right.k11, -3.25, right.k22}, jv), "k12 has a term −r_x r_y/I of each body."},
          {solved({2.5, 0, 2.5}, jv), "A push at an arm turns its body, too: r²/I."},
          {solved({2.5 + 0.125 + 2, -0.25 + 1, 2.5 + 0.5 + 0.5}, jv),
           "The turning has the inverse inertia, not the inverse mass."},
          {solved({2.5 + 6.5 / 4, -6.5 / 2, 2.5 + 6.5}, jv), "Each body has its own arm."}};
}

/// Both impulses of a visit. One mistake explains both, or else whatever explains one of them. `moved`: the
/// bodies have been pushed, and `holds`: as they should.
void grade_impulses(Grade& grade, const Pair& given, bool moved, bool holds) {
  List<Wrong> known = wrong_impulses();
  for (const Wrong& wrong : wrong_impulses()) {
    if (is_near(given, wrong.impulse)) known = {wrong};
  }
  for (int i = 0; i < 2; ++i) {
    ExpectedNumber expected{.what = i == 0 ? "2 and 0.5 kg: impulse along x (N s)" : "and along y (N s)",
                            .value = i == 0 ? 1.0 : -2.0,
                            .tolerance = block_rounding};
    if (holds && moved)
      expected.misconceptions = {{-expected.value, "Note what was pushed: px and py grow by it."}};
    if (moved) expected.misconceptions.push_back({0, "Note what was pushed: px and py grow by it."});
    for (const Wrong& wrong : known) expected.misconceptions.push_back({wrong.impulse[i], wrong.what});
    grade.number(expected, given[i]);
  }
}

/// What is left after one visit, of the second visit, and after it.
void grade_what_is_left(Grade& grade, Scene& scene, bool moved, bool is_given) {
  const char* const opposite = "Body 2 gets (x, y), and body 1 the opposite: push(pin, one, two, x, y).";
  grade.number(
      {.what = "what is left of j·v along y (m/s)",
       .value = 0,
       .misconceptions = {{11.25, moved ? opposite : "The velocities have not changed: push both bodies."},
                          {22.5, is_given ? opposite : ""},
                          {7.25, is_given ? opposite : ""},
                          {4, is_given ? opposite : ""}},
       .tolerance = block_rounding},
      row_velocities(scene.pin, scene.one, scene.two)[1]);
  visit(scene.pin, scene.one, scene.two);
  grade.number({.what = "what is left of it after a second visit (m/s)",
                .value = 0,
                .misconceptions = {{-11.25, "The sum has acted before: push what this visit adds."}},
                .tolerance = block_rounding},
               row_velocities(scene.pin, scene.one, scene.two)[1]);
  grade.number({.what = "after a second visit: impulse along x (N s)",
                .value = 1,
                .misconceptions = {{0, is_given ? "Add to what the pin has given before." : ""}},
                .tolerance = block_rounding},
               scene.pin.px);
}

/// Whether the pin gives what it has to.
bool grade_two_bodies(Grade& grade) {
  Scene scene = two_bodies();
  visit(scene.pin, scene.one, scene.two);
  const Pair given = {scene.pin.px, scene.pin.py};
  const bool moved = scene.two.vx != -5.625 || scene.two.vy != 11.25;
  grade_impulses(grade, given, moved, is_near(row_velocities(scene.pin, scene.one, scene.two), {0, 0}));
  const bool is_given = is_near(given, {1, -2});
  grade_what_is_left(grade, scene, moved, is_given);
  return is_given;
}

/// The rod of the lesson with twice its mass: K = (1.25 -0.75; -0.75 1.25), and gravity has given (0, -0.2)
/// m/s.
void grade_rod(Grade& grade, bool gives) {
  const double half = 0.70710678118654752;
  Scene scene{.pin = {.r2x = -half, .r2y = -half},
              .two = {.inverse_mass = 0.5, .inverse_inertia = 1.5, .vy = -0.2}};
  visit(scene.pin, scene.one, scene.two);
  const char* const ground =
      gives ? "Body 1 is the ground: its 1/m and 1/I are 0, and it has no mass to divide by." : "";
  const double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Misconception> wrong = {{std::nan(""), ground}, {infinity, ground}, {0, ground}};
  grade.number({.what = "rod of 2 kg at 45 degrees: impulse along x (N s)",
                .value = 0.15,
                .misconceptions = wrong,
                .tolerance = block_rounding},
               scene.pin.px);
  grade.number(
      {.what = "and along y (N s)", .value = 0.25, .misconceptions = wrong, .tolerance = block_rounding},
      scene.pin.py);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 12,
      .task = "One visit to a pin: its 2 x 2 block, both impulses together, and both bodies.",
      .file = "lessons/12_blocks/exercise.cpp",
      .hints = {"Two equations: k11 x + k12 y = −jv_x and k12 x + k22 y = −jv_y.",
                "The inverse of K is (k22 −k12; −k12 k11) over k11 k22 − k12².",
                "x = −(k22 jv_x − k12 jv_y) / det, y = −(k11 jv_y − k12 jv_x) / det; add both to the pin's "
                "sums, and push."},
      .grade = [](Grade& grade) {
        const bool gives = grade_two_bodies(grade);
        grade_rod(grade, gives);
      }};
}

}  // namespace cairn::exercise12
