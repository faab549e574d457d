// Exercise 03, graded: two wheels after one visit, three after one sweep, and when it is time to stop.
#include "exercise.cpp"

namespace cairn::exercise03 {
namespace {

constexpr double few_roundings = 64 * 2.2204e-16;  // a dozen operations on numbers below 16

/// What is left of the wheels, and how many sweeps there have been.
struct Swept {
  List<Wheel> wheels = {};
  int sweeps = 0;
};

Swept swept(List<Wheel> wheels, double limit, int most) {
  Swept result{.wheels = std::move(wheels)};
  result.sweeps = sweeps_until(result.wheels, limit, most);
  return result;
}

/// j·v is 2·3 + 0.5·3 = 7.5 m/s and j M⁻¹ jᵀ = 4·0.5 + 0.25·12 = 5: the impulse is -1.5.
List<Wheel> pair() { return {{2, 0.5, 3}, {0.5, 12, 3}}; }

/// The first wheel is held. Pair 1 stops wheel 2; pair 2 then slips at 1 m/s, and makes pair 1 slip at
/// -1/2 m/s. Each later sweep halves that: numbers that a computer has exactly.
List<Wheel> train() { return {{1, 0, 0}, {0.5, 4, 2}, {0.25, 16, 4}}; }

void grade_visit(Grade& grade) {
  const Swept once = swept(pair(), 0.01, 1);
  const double a = once.wheels[0].spin, b = once.wheels[1].spin;
  const char* const one_wheel = "Both wheels give way: j M⁻¹ jᵀ is a sum over the two.";
  grade.number(
      {.what = "two wheels, one visit: spin of the first (rad/s)",
       .value = 1.5,
       .misconceptions = {{3, b == 3 ? "Nothing has turned: change the wheels of the list."
                                     : "The push has two ends: it changes the first wheel, too."},
                          {4.5, "The sign: the impulse is −j·v / (j M⁻¹ jᵀ)."},
                          {2.1, "Two wheels that both turn counterclockwise slip: j·v is a sum here."},
                          {3 - 7.5 / 7, "(22): each radius comes in squared, as j stands twice in j M⁻¹ jᵀ."},
                          {2.4, "The radii are missing in j M⁻¹ jᵀ: j is (r_a, r_b)."},
                          {-0.75, one_wheel},
                          {0.5, one_wheel},
                          {-4.5, "A slip is no impulse: divide it by j M⁻¹ jᵀ."},
                          {3 - 37.5, "Divide by j M⁻¹ jᵀ: do not multiply."},
                          {2.25,
                           "A push at the rim turns a large wheel more: M⁻¹ jᵀ λΔt has the radius in it."},
                          {0, "M⁻¹ is missing: the inverse of I says how much an impulse changes a spin."},
                          {-3, "inverse_inertia is 1/I already: multiply by it."}},
       .tolerance = few_roundings},
      a);
  grade.number(
      {.what = "and of the second (rad/s)",
       .value = -6,
       .misconceptions = {{3, a == 1.5 ? "The push has two ends: it changes the second wheel, too." : ""},
                          {12, "Both numbers of j are positive here: both spins change the same way."},
                          {-15, "The radius of the second wheel is missing."},
                          {2.25, "M⁻¹ of the second wheel is missing."}},
       .tolerance = few_roundings},
      b);
}

void grade_sweep(Grade& grade) {
  const Swept once = swept(train(), 0.01, 1);
  const double middle = once.wheels[1].spin, last = once.wheels[2].spin;
  grade.number({.what = "three wheels, one sweep: spin of the one that is held (rad/s)", .value = 0},
               once.wheels[0].spin);
  grade.number(
      {.what = "of the second (rad/s)",
       .value = -1,
       .misconceptions = {{0, last == 4 ? "Only the first pair has been visited: a sweep visits all."
                                        : "The order: a sweep goes from the first pair to the last."},
                          {-2, "Each push acts immediately: the next pair has to find the new spins."}},
       .tolerance = few_roundings},
      middle);
  grade.number({.what = "of the third (rad/s)", .value = 2, .tolerance = few_roundings}, last);
}

/// After k sweeps pair 1 slips at -2⁻ᵏ m/s, and pair 2 not at all.
void grade_stop(Grade& grade) {
  grade.number(
      {.what = "three wheels, until no pair slips faster than 0.1 m/s: sweeps",
       .value = 4,
       .misconceptions =
           {{0, "No sweep has been counted."},
            {1, "After one sweep pair 1 slips at −0.5 m/s: look at all pairs, and at the size of the slip."},
            {3, "One too few: after three sweeps pair 1 slips at 0.125 m/s."},
            {5, "One too many: look at the slips after the sweep, not at those that it has found."},
            {60, "It has not stopped before `most`: is the largest slip looked at anew after each sweep?"}}},
      swept(train(), 0.1, 60).sweeps);
  grade.number({.what = "until no pair slips faster than 0.125 m/s: sweeps",
                .value = 3,
                .misconceptions = {{4, "Three sweeps leave just 0.125 m/s, and that is not faster."}}},
               swept(train(), 0.125, 60).sweeps);
  grade.number({.what = "where no pair slips faster from the beginning: sweeps",
                .value = 0,
                .misconceptions = {{1, "Look before the first sweep as well."}}},
               swept(train(), 5, 60).sweeps);
  grade.number({.what = "at most two sweeps: sweeps",
                .value = 2,
                .misconceptions = {{4, "There are `most` sweeps at most, whatever slips then."},
                                   {3, "One more than `most`."},
                                   {1, "One less than `most`."}}},
               swept(train(), 0.1, 2).sweeps);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 3,
      .task = "Sweeps over wheels whose rims touch, until no pair slips faster than a limit.",
      .file = "lessons/03_sequential_impulses/exercise.cpp",
      .hints =
          {"What does a visit need to know of its two wheels? Lesson 02 has it for boxes; here j has one "
           "number for each wheel, its radius.",
           "The masses of lesson 02 are moments of inertia here. How often does a radius come into "
           "j M⁻¹ jᵀ, and how often into what an impulse does to a spin?",
           "Right after its own visit a pair never slips. When do you have to look, then, and at which "
           "pairs? "
           "Do the three wheels of the grader by hand: radii 1, 0.5, 0.25 m, 1/I 0, 4, 16, spins 0, 2, 4."},
      .grade = [](Grade& grade) {
        grade_visit(grade);
        grade_sweep(grade);
        grade_stop(grade);
      }};
}

}  // namespace cairn::exercise03
