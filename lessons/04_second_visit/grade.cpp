// Exercise 04, graded: a box of 2 kg on two feet, feet that break, and a box of 0.5 kg that is pulled up.
#include "exercise.cpp"

namespace cairn::exercise04 {
namespace {

constexpr double visit_rounding = 1e-13;  // a few dozen operations on numbers below 100

constexpr const char* not_moved = "The box has not moved: apply the push to velocity and spin.";
constexpr const char* nothing_given = "Nothing was given: a foot that comes down needs a push up.";
constexpr const char* backwards = "The sign: what is left for the box is the new sum less the old one.";
constexpr const char* sum_again = "Apply the change of the sum, not the sum: the old one was applied before.";
constexpr const char* second_visit = "A push may be negative, only the sum may not: clamp the sum.";
constexpr const char* counted_twice =
    "The foot's sum is twice what the box has received: count each push once.";

bool is_near(double got, double value) { return std::abs(got - value) <= visit_rounding; }

/// A box of 2 kg and 0.5 kg m² has landed at 10 m/s. A_11 = 1/2 + 0.25²/0.5 = 0.625, A_12 = 0.375 per kg.
struct Landing {
  Box box = {.inverse_mass = 0.5, .inverse_inertia = 2, .velocity = -10};
  Foot left = {.place = -0.25};
  Foot right = {.place = 0.25};
};

Landing landed(double strongest, int sweeps) {
  Landing landing;
  landing.left.strongest = landing.right.strongest = strongest;
  for (int k = 0; k < sweeps; ++k) {
    visit(landing.left, landing.box);
    visit(landing.right, landing.box);
  }
  return landing;
}

void grade_first_visit(Grade& grade) {
  Landing landing{.left = {.place = -0.25, .strongest = 1000}};
  visit(landing.left, landing.box);
  const bool is_given = landing.left.impulse != 0, is_backwards = is_near(landing.box.velocity, -18);
  grade.number({.what = "first visit: how fast the box rises (m/s)",
                .value = -2,
                .misconceptions = {{-10, is_given ? not_moved : nothing_given},
                                   {-18, backwards},
                                   {15.6, "A push of 1 N s changes the velocity by 1/m."},
                                   {6, "A push of 1 N s changes the velocity by 1/m."}},
                .tolerance = visit_rounding},
               landing.box.velocity);
  grade.number(
      {.what = "first visit: how fast the box turns (rad/s)",
       .value = -8,
       .misconceptions =
           {{0, is_given ? "A push away from the centre turns the box as well." : nothing_given},
            {8, is_backwards ? backwards
                             : "A push at the left turns the box clockwise: the sign of a place counts."},
            {2, "The place comes in once here: its square is in j M⁻¹ jᵀ."},
            {-6.4, "A push of 1 N s at a place changes the spin by place/I."},
            {-4, "A push of 1 N s at a place changes the spin by place/I."},
            {32, "The place counts: a push at the centre does not turn the box."}},
       .tolerance = visit_rounding},
      landing.box.spin);
}

void grade_sum(Grade& grade) {
  const char* const not_noted = "The box was pushed, and foot.impulse does not know of it.";
  const char* const forgotten = "The sum is what was given before and the correction: add them, then clamp.";
  const Landing one = landed(1000, 1), two = landed(1000, 2), many = landed(1000, 20);
  const bool is_noted = is_near(one.left.impulse, 16) && is_near(one.right.impulse, 6.4);
  const bool has_moved = one.box.velocity != -10;
  grade.number({.what = "sweep 1: impulse of the left foot (N s)",
                .value = 16,
                .misconceptions = {{0, has_moved ? not_noted : nothing_given},
                                   {1000, "The clamp has two ends: no more than is needed, either."},
                                   {32, counted_twice}},
                .tolerance = visit_rounding},
               one.left.impulse);
  grade.number({.what = "sweep 1: impulse of the right foot (N s)",
                .value = 6.4,
                .misconceptions = {{16, not_moved}},
                .tolerance = visit_rounding},
               one.right.impulse);
  // The left foot rises at 0.625 16 + 0.375 6.4 − 10 = 2.4 m/s; 2.4 / 0.625 = 3.84 is too much.
  grade.number({.what = "sweep 2: impulse of the left foot (N s)",
                .value = 12.16,
                .misconceptions = {{16, second_visit},
                                   {0, is_noted ? forgotten : ""},
                                   {28.16, "The clamped sum is all of it: set foot.impulse to it."},
                                   {19.84, "A foot that rises gets less: the correction is negative here."}},
                .tolerance = visit_rounding},
               two.left.impulse);
  const bool takes_back = is_near(two.left.impulse, 12.16);
  const char* const clamped_each = is_near(two.left.impulse, 16) ? second_visit : "";
  grade.number(
      {
          .what = "20 sweeps: how fast the box rises (m/s)",
          .value = 0,
          .misconceptions = {{1.2, takes_back
                                       ? "The clamped push must also be the one that is applied to the box."
                                       : clamped_each},
                             {7.28, sum_again}},
          .tolerance = 1e-7  // 0.6 a visit, 40 visits
      },
      many.box.velocity);
}

constexpr const char* left_over = "Apply what the clamp has left: the new sum less the old one.";

/// What a foot gives at most.
void grade_strongest(Grade& grade) {
  const bool gives = landed(1000, 1).left.impulse != 0;
  const Landing weak = landed(12, 1);
  grade.number(
      {.what = "feet of 12 N s at most: impulse of the left foot (N s)",
       .value = 12,
       .misconceptions = {{16, "A foot gives no more than `strongest`."},
                          {24, counted_twice},
                          {0,
                           gives ? "What is too much goes to `strongest`: the foot still gives that." : ""}},
       .tolerance = visit_rounding},
      weak.left.impulse);
  grade.number({.what = "feet of 12 N s at most: how fast the left foot comes down (m/s)",
                .value = -10 + 0.625 * 12 + 0.375 * 8.8,
                .misconceptions = {{2.4, is_near(weak.left.impulse, 12) ? left_over : ""}},
                .tolerance = visit_rounding},
               weak.box.velocity - 0.25 * weak.box.spin);
  const Landing twice = landed(9, 2);
  grade.number({.what = "feet of 9 N s at most, 2 sweeps: impulse of the left foot (N s)",
                .value = 9,
                .misconceptions = {{10.6, "The most is for the sum of all visits, not for each push."},
                                   {11.36, "The most is for the sum of all visits, not for each push."}},
                .tolerance = visit_rounding},
               twice.left.impulse);
}

/// A foot that has pushed, and does not pull.
void grade_pulled_up(Grade& grade) {
  Box light{.inverse_mass = 2, .inverse_inertia = 10, .velocity = -3};
  Foot foot{.place = 0, .strongest = 1000};
  visit(foot, light);
  light.velocity += 8;  // somebody pulls it up
  visit(foot, light);
  grade.number({.what = "0.5 kg, pulled up at 8 m/s afterwards: impulse (N s)",
                .value = 0,
                .misconceptions = {{-2.5, "A foot cannot pull: the sum is never below 0."},
                                   {-3, counted_twice},
                                   {1.5, second_visit}},
                .tolerance = visit_rounding},
               foot.impulse);
  grade.number({.what = "and how fast it rises then (m/s)",
                .value = 5,
                .misconceptions = {{0, foot.impulse < 0 ? "" : left_over},
                                   {2, counted_twice},
                                   {8, foot.impulse > 0 ? second_visit : left_over}},
                .tolerance = visit_rounding},
               light.velocity);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 4,
      .task = "A visit to a foot: clamp the sum of its pushes, between 0 and the most that it can give.",
      .file = "lessons/04_second_visit/exercise.cpp",
      .hints = {"What must not be negative: this push, or all that the foot has given?",
                "The new sum is the old one and the correction, clamped. Then which push is left?",
                "before = foot.impulse; foot.impulse = std::clamp(before + correction, 0.0, foot.strongest); "
                "push = foot.impulse - before."},
      .grade = [](Grade& grade) {
        grade_first_visit(grade);
        grade_sum(grade);
        grade_strongest(grade);
        grade_pulled_up(grade);
      }};
}

}  // namespace cairn::exercise04
