// Exercise 11, graded: blocks of 2 and 0.5 kg on a slope of 30 degrees for one step of 0.02 s, and after it.
#include "exercise.cpp"

namespace cairn::exercise11 {
namespace {

// g dt = 0.2 m/s: the slope takes 0.1 of it along, and the normal impulse for each kg is 0.2 cos 30 N s.
constexpr double along = 0.1, normal = 0.17320508075688773;
constexpr double slope_rounding = 1e-15;  // a few operations on numbers below 2
constexpr double heavy = 2, light = 0.5;  // [kg]

struct Sliding {
  Contact contact = {};
  Block block = {};
};

Sliding updated(Sliding sliding, int times) {
  for (int i = 0; i < times; ++i) update(sliding.contact, sliding.block);
  return sliding;
}

Sliding on_slope(double mass, double friction, double slide) {
  return {.contact = {.normal_impulse = mass * normal, .friction = friction},
          .block = {.inverse_mass = 1 / mass, .slide = slide}};
}

void grade_holding(Grade& grade) {
  const Sliding holds = updated(on_slope(heavy, 0.6, along), 1);
  grade.number({.what = "2 kg, mu = 0.6, downhill at 0.1 m/s: tangent impulse (N s)",
                .value = -heavy * along,
                .tolerance = slope_rounding,
                .misconceptions = {{heavy * along, "The sign: friction acts against the sliding."},
                                   {-along, "A speed is no impulse: divide it by the inverse mass."},
                                   {-along / heavy, "Equation (22): divide by the inverse mass."}}},
               holds.contact.tangent_impulse);
  grade.number(
      {.what = "2 kg, mu = 0.6: slides on at (m/s)",
       .value = 0,
       .tolerance = slope_rounding,
       .misconceptions = {{2 * along, "The sign: friction acts against the sliding."},
                          {along, "The velocity has not changed."},
                          {along - heavy * along,
                           "An impulse is no change of velocity: multiply it by the inverse mass."}}},
      holds.block.slide);
}

void grade_sliding(Grade& grade) {
  const Sliding slides = updated(on_slope(light, 0.5, 10 * along), 1);
  grade.number({.what = "0.5 kg, mu = 0.5, downhill at 1 m/s: tangent impulse (N s)",
                .value = -0.5 * light * normal,
                .tolerance = slope_rounding,
                .misconceptions = {{-light * 10 * along, "Friction is at most mu times the normal impulse."},
                                   {-light * normal, "The bound is the whole normal impulse. Where is mu?"},
                                   {0, "Where the bound is not enough, friction gives as much as it may."}}},
               slides.contact.tangent_impulse);
  grade.number({.what = "0.5 kg, mu = 0.5: slides on at (m/s)",
                .value = 10 * along - 0.5 * normal,
                .tolerance = slope_rounding,
                .misconceptions = {{0, "Apply what the clamp has left of the correction, not all of it."},
                                   {10 * along, "The velocity has not changed."}}},
               slides.block.slide);
  const Sliding uphill = updated(on_slope(heavy, 0.5, -along), 1);
  grade.number({.what = "2 kg, mu = 0.5, uphill at 0.1 m/s: tangent impulse (N s)",
                .value = 0.5 * heavy * normal,
                .tolerance = slope_rounding,
                .misconceptions = {{0, "Friction acts both ways: its interval is -mu N to +mu N."}}},
               uphill.contact.tangent_impulse);
}

void grade_sums(Grade& grade) {
  const Sliding thrice = updated(on_slope(heavy, 0.5, along), 3);
  grade.number({.what = "2 kg, mu = 0.5, updated three times: tangent impulse (N s)",
                .value = -0.5 * heavy * normal,
                .tolerance = slope_rounding,
                .misconceptions = {{-heavy * along,
                                    "Each correction was within the bound, but not their sum. Clamp the "
                                    "sum."}}},
               thrice.contact.tangent_impulse);
  grade.number(
      {.what = "2 kg, mu = 0.5, updated three times: slides on at (m/s)",
       .value = along - 0.5 * normal,
       .tolerance = slope_rounding,
       .misconceptions = {{-0.5 * normal,
                           "The sum has acted before: apply only the difference of the new and the old."}}},
      thrice.block.slide);
  Sliding less = updated(on_slope(heavy, 0.6, along), 1);
  less.contact.normal_impulse /= 2;  // in its own update the normal row has taken half of its push back
  less = updated(less, 1);
  grade.number(
      {.what = "2 kg, mu = 0.6, then only half of the normal impulse: tangent impulse (N s)",
       .value = -0.3 * heavy * normal,
       .tolerance = slope_rounding,
       .misconceptions = {{-heavy * along, "The bound is that of the normal impulse as it is now."}}},
      less.contact.tangent_impulse);
}

}  // namespace

Exercise exercise() {
  return {.lesson = 11,
          .task = "One update of a friction row: within mu times what the normal row has given so far.",
          .file = "lessons/11_friction/exercise.cpp",
          .hints = {"Which impulse stops the sliding? And how large may the sum of all of them be?",
                    "bound = mu times the normal impulse; the new sum is clamped to -bound .. bound.",
                    "sum' = clamp(sum - slide / inverse_mass, -bound, bound); slide grows by inverse_mass "
                    "(sum' - sum)."},
          .grade = [](Grade& grade) {
            grade_holding(grade);
            grade_sliding(grade);
            grade_sums(grade);
          }};
}

}  // namespace cairn::exercise11
