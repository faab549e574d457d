// Exercise 07, graded: a box of 2 kg on two feet, feet that break, and a box of 0.5 kg that is pulled up.
#include "exercise.cpp"

namespace cairn::exercise07 {
namespace {

constexpr double visit_rounding = 1e-13;  // a few dozen operations on numbers below 100

constexpr const char* counted_twice =
    "The foot's sum is twice what the box has received: count each push once.";

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
  grade.number({.what = "first visit: how fast the box rises (m/s)",
                .value = -2,
                .tolerance = visit_rounding,
                .misconceptions = {{-10, "The box has not moved: apply the push to velocity and spin."},
                                   {6, "A push of 1 N s changes the velocity by 1/m."}}},
               landing.box.velocity);
  grade.number(
      {.what = "first visit: how fast the box turns (rad/s)",
       .value = -8,
       .tolerance = visit_rounding,
       .misconceptions = {{0, "A push away from the centre turns the box as well."},
                          {8, "A push at the left turns the box clockwise: the sign of a place counts."},
                          {-4, "A push of 1 N s at a place changes the spin by place/I."},
                          {32, "The place counts: a push at the centre does not turn the box."}}},
      landing.box.spin);
}

void grade_sum(Grade& grade) {
  const Landing one = landed(1000, 1), two = landed(1000, 2);
  grade.number({.what = "sweep 1: impulse of the left foot (N s)",
                .value = 16,
                .tolerance = visit_rounding,
                .misconceptions = {{0, "Nothing was given: a foot that comes down needs a push up."},
                                   {1000, "The clamp has two ends: no more than is needed, either."},
                                   {32, counted_twice}}},
               one.left.impulse);
  grade.number({.what = "sweep 1: impulse of the right foot (N s)",
                .value = 6.4,
                .tolerance = visit_rounding,
                .misconceptions = {{16, "The box has not moved: apply the push to velocity and spin."}}},
               one.right.impulse);
  // The left foot rises at 0.625 16 + 0.375 6.4 − 10 = 2.4 m/s; 2.4 / 0.625 = 3.84 is too much.
  grade.number(
      {.what = "sweep 2: impulse of the left foot (N s)",
       .value = 12.16,
       .tolerance = visit_rounding,
       .misconceptions = {{16, "A push may be negative, only the sum may not: clamp the sum."},
                          {0, "The sum is what was given before and the correction: add them, then clamp."},
                          {19.84, "A foot that rises gets less: the correction is negative here."}}},
      two.left.impulse);
  grade.number(
      {.what = "20 sweeps: how fast the box rises (m/s)",
       .value = 0,
       .tolerance = 1e-7,  // 0.6 a visit, 40 visits
       .misconceptions = {{1.2, "The clamped push must also be the one that is applied to the box."}}},
      landed(1000, 20).box.velocity);
}

void grade_ends(Grade& grade) {
  const Landing weak = landed(12, 1);
  grade.number({.what = "feet of 12 N s at most: impulse of the left foot (N s)",
                .value = 12,
                .tolerance = visit_rounding,
                .misconceptions = {{16, "A foot gives no more than `strongest`."}, {24, counted_twice}}},
               weak.left.impulse);
  grade.number({.what = "feet of 12 N s at most: how fast the left foot comes down (m/s)",
                .value = -10 + 0.625 * 12 + 0.375 * 8.8,
                .tolerance = visit_rounding,
                .misconceptions = {{2.4, "Apply what the clamp has left: the new sum less the old one."}}},
               weak.box.velocity - 0.25 * weak.box.spin);
  const Landing twice = landed(9, 2);
  grade.number({.what = "feet of 9 N s at most, 2 sweeps: impulse of the left foot (N s)",
                .value = 9,
                .tolerance = visit_rounding,
                .misconceptions = {{10.6, "The most is for the sum of all visits, not for each push."},
                                   {11.36, "The most is for the sum of all visits, not for each push."}}},
               twice.left.impulse);
  Box light{.inverse_mass = 2, .inverse_inertia = 10, .velocity = -3};
  Foot foot{.place = 0, .strongest = 1000};
  visit(foot, light);
  light.velocity += 8;  // somebody pulls it up
  visit(foot, light);
  grade.number({.what = "0.5 kg, pulled up at 8 m/s afterwards: impulse (N s)",
                .value = 0,
                .tolerance = visit_rounding,
                .misconceptions = {{-2.5, "A foot cannot pull: the sum is never below 0."},
                                   {-3, counted_twice},
                                   {1.5, "A push may be negative, only the sum may not: clamp the sum."}}},
               foot.impulse);
  grade.number({.what = "and how fast it rises then (m/s)",
                .value = 5,
                .tolerance = visit_rounding,
                .misconceptions = {{0, "Apply what the clamp has left: the new sum less the old one."},
                                   {2, counted_twice},
                                   {8, "A push may be negative, only the sum may not: clamp the sum."}}},
               light.velocity);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 7,
      .task = "A visit to a foot: clamp the sum of its pushes, between 0 and the most that it can give.",
      .file = "lessons/07_clamp_the_sum/exercise.cpp",
      .hints = {"What must not be negative: this push, or all that the foot has given?",
                "The new sum is the old one and the correction, clamped. Then which push is left?",
                "before = foot.impulse; foot.impulse = std::clamp(before + correction, 0.0, foot.strongest); "
                "push = foot.impulse - before."},
      .grade = [](Grade& grade) {
        grade_first_visit(grade);
        grade_sum(grade);
        grade_ends(grade);
      }};
}

}  // namespace cairn::exercise07
