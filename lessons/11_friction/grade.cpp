// Exercise 11, graded: blocks of 2 and 0.5 kg on a slope of 30 degrees for one step of 0.02 s, and after it.
#include "exercise.cpp"

namespace cairn::exercise11 {
namespace {

// g dt = 0.2 m/s: the slope takes 0.1 of it along, and the normal impulse for each kg is 0.2 cos 30 N s.
constexpr double along = 0.1, normal = 0.17320508075688773;
constexpr double slope_rounding = 1e-15;  // a few operations on numbers below 2
constexpr double heavy = 2, light = 0.5;  // [kg]

constexpr const char* both_ways = "Friction acts both ways: its interval is -mu N to +mu N.";
constexpr const char* the_sum = "Each correction was within the bound, but not their sum. Clamp the sum.";

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
  const Sliding uphill = updated(on_slope(heavy, 0.6, -along), 1);
  const bool gives = holds.contact.tangent_impulse != 0, gives_uphill = uphill.contact.tangent_impulse != 0;
  grade.number(
      {.what = "2 kg, mu = 0.6, downhill at 0.1 m/s: tangent impulse (N s)",
       .value = -heavy * along,
       .tolerance = slope_rounding,
       .misconceptions = {{heavy * along, "The sign: friction acts against the sliding."},
                          {0, gives_uphill ? both_ways : ""},
                          {-0.5 * heavy * normal, "mu is that of the contact."},
                          {-0.6 * heavy * normal, "No more than stops the sliding: the bound is the most."},
                          {-along, "A speed is no impulse: divide it by the inverse mass."},
                          {-along / heavy, "Equation (22): divide by the inverse mass."}}},
      holds.contact.tangent_impulse);
  grade.number(
      {.what = "2 kg, mu = 0.6: slides on at (m/s)",
       .value = 0,
       .tolerance = slope_rounding,
       .misconceptions = {{2 * along, "The sign: friction acts against the sliding."},
                          {along, gives ? "The velocity has not changed." : ""},
                          {along - heavy * heavy * along, "inverse_mass is 1/m already: multiply by it."},
                          {along - heavy * along,
                           "An impulse is no change of velocity: multiply it by the inverse mass."}}},
      holds.block.slide);
}

void grade_sliding(Grade& grade) {
  const Sliding slides = updated(on_slope(light, 0.5, 10 * along), 1);
  const bool gives = slides.contact.tangent_impulse != 0, clamps = slides.contact.tangent_impulse > -0.5;
  const bool is_right = std::abs(slides.contact.tangent_impulse + 0.5 * light * normal) <= slope_rounding;
  const bool gives_little = updated(on_slope(heavy, 0.6, along), 1).contact.tangent_impulse != 0;
  grade.number(
      {.what = "0.5 kg, mu = 0.5, downhill at 1 m/s: tangent impulse (N s)",
       .value = -0.5 * light * normal,
       .tolerance = slope_rounding,
       .misconceptions = {{-light * 10 * along, "Friction is at most mu times the normal impulse."},
                          {-light * normal, "The bound is the whole normal impulse. Where is mu?"},
                          {-2 * light * normal, "mu times the normal impulse: multiply."},
                          {0, gives_little
                                  ? "Where the bound is not enough, friction gives as much as it may."
                                  : ""}}},
      slides.contact.tangent_impulse);
  grade.number(
      {.what = "0.5 kg, mu = 0.5: slides on at (m/s)",
       .value = 10 * along - 0.5 * normal,
       .tolerance = slope_rounding,
       .misconceptions = {{0,
                           clamps ? "Apply what the clamp has left of the correction, not all of it." : ""},
                          {10 * along, gives ? "The velocity has not changed." : ""}}},
      slides.block.slide);
  const Sliding uphill = updated(on_slope(heavy, 0.5, -along), 1);
  grade.number(
      {.what = "2 kg, mu = 0.5, uphill at 0.1 m/s: tangent impulse (N s)",
       .value = 0.5 * heavy * normal,
       .tolerance = slope_rounding,
       .misconceptions = {{0, gives ? both_ways : ""},
                          {heavy * along, is_right ? "The bound holds uphill, too: -mu N and +mu N." : ""}}},
      uphill.contact.tangent_impulse);
}

void grade_sums(Grade& grade) {
  const Sliding once = updated(on_slope(heavy, 0.5, along), 1),
                twice = updated(on_slope(heavy, 0.5, along), 2);
  const char* const add_to_it = "Add to what the row has given before, and clamp then.";
  const double bound = 0.5 * heavy * normal;
  const bool clamps = std::abs(once.contact.tangent_impulse + bound) <= slope_rounding;
  const bool is_right = clamps && std::abs(once.block.slide - along + 0.5 * normal) <= slope_rounding;
  const bool keeps = std::abs(twice.contact.tangent_impulse + bound) <= slope_rounding;
  grade.number({.what = "2 kg, mu = 0.5, updated twice: tangent impulse (N s)",
                .value = -bound,
                .tolerance = slope_rounding,
                .misconceptions = {{-heavy * along, clamps ? the_sum : ""},
                                   {bound - heavy * along, is_right ? add_to_it : ""}}},
               twice.contact.tangent_impulse);
  grade.number(
      {.what = "2 kg, mu = 0.5, updated twice: slides on at (m/s)",
       .value = along - 0.5 * normal,
       .tolerance = slope_rounding,
       .misconceptions = {{along - normal,
                           "The sum has acted before: apply only the difference of the new and the old."}}},
      twice.block.slide);
  Sliding less = updated(on_slope(heavy, 0.6, along), 1);
  less.contact.normal_impulse /= 2;  // in its own update the normal row has taken half of its push back
  less = updated(less, 1);
  grade.number({.what = "2 kg, mu = 0.6, then only half of the normal impulse: tangent impulse (N s)",
                .value = -0.3 * heavy * normal,
                .tolerance = slope_rounding,
                .misconceptions = {{-heavy * along,
                                    keeps ? "The bound is that of the normal impulse as it is now." : ""},
                                   {0, is_right && !keeps ? add_to_it : ""}}},
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
