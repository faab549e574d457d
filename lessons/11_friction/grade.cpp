// Exercise 11, graded: a block of 1 kg on a slope of 30 degrees for one step of 0.02 s, and what comes after.
#include "exercise.hpp"

namespace cairn::exercise11 {
namespace {

// g dt = 0.2 m/s: the slope takes 0.1 of it along, and the normal impulse is 0.2 cos 30 = 0.17320508... N s.
constexpr double along = 0.1, normal = 0.17320508075688773;
constexpr double slope_rounding = 1e-15;  // a few operations on numbers below 1

struct Sliding {
  Contact contact = {};
  Block block = {};
};

Sliding updated(Answer answer, Sliding sliding, int times) {
  for (int i = 0; i < times; ++i) answer(sliding.contact, sliding.block);
  return sliding;
}

Sliding on_slope(double friction, double slide) {
  return {.contact = {.normal_impulse = normal, .friction = friction},
          .block = {.inverse_mass = 1, .slide = slide}};
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  grade.number({.what = "mu = 0.6, downhill at 0.1 m/s: holds, slides on at (m/s)",
                .value = 0,
                .tolerance = slope_rounding,
                .misconceptions = {{0.2, "The sign: friction acts against the sliding."},
                                   {along, "The velocity has not changed."}}},
               updated(answer, on_slope(0.6, along), 1).block.slide);
  grade.number({.what = "mu = 0.5: cannot hold, slides on at (m/s)",
                .value = along - 0.5 * normal,
                .tolerance = slope_rounding,
                .misconceptions = {{0, "Friction is at most mu times the normal impulse."},
                                   {along, "The velocity has not changed."}}},
               updated(answer, on_slope(0.5, along), 1).block.slide);
  grade.number(
      {.what = "mu = 0.5, updated three times: tangent impulse (N s)",
       .value = -0.5 * normal,
       .tolerance = slope_rounding,
       .misconceptions = {{-0.1, "Each correction was within the bound, but not their sum. Clamp the sum."}}},
      updated(answer, on_slope(0.5, along), 3).contact.tangent_impulse);
  grade.number({.what = "mu = 0.5, uphill at 0.1 m/s: tangent impulse (N s)",
                .value = 0.5 * normal,
                .tolerance = slope_rounding,
                .misconceptions = {{0, "Friction acts both ways: its interval is -mu N to +mu N."},
                                   {0.1, "Friction is at most mu times the normal impulse, both ways."}}},
               updated(answer, on_slope(0.5, -along), 1).contact.tangent_impulse);
  Sliding less = updated(answer, on_slope(0.6, along), 1);
  less.contact.normal_impulse =
      normal / 2;  // in its own update the normal row has taken half of its push back
  less = updated(answer, less, 1);
  grade.number({.what = "mu = 0.6, then only half of the normal impulse: tangent impulse (N s)",
                .value = -0.3 * normal,
                .tolerance = slope_rounding,
                .misconceptions = {{-0.1, "The bound leans on the normal impulse as it is now."}}},
               less.contact.tangent_impulse);
}

Exercise exercise() {
  return {.lesson = 11,
          .task = "One update of a friction row: within mu times what the normal row has given so far.",
          .file = "lessons/11_friction/exercise.cpp",
          .hints = {"Which impulse stops the sliding? And how large may the sum of all of them be?",
                    "bound = mu times the normal impulse; the new sum is clamped to -bound .. bound.",
                    "sum' = clamp(sum - slide / inverse_mass, -bound, bound); slide grows by inverse_mass "
                    "(sum' - sum)."},
          .grade = [](Grade& marks) { grade(marks, update); }};
}

}  // namespace cairn::exercise11
