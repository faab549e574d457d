// Exercise 03, graded: single values, two time steps, and a box that settles.
#include "exercise.cpp"

namespace cairn::exercise03 {
namespace {

constexpr double few_roundings = 1e-14;  // of numbers near 1, after at most fifty operations
constexpr double no_limit = std::numeric_limits<double>::infinity();
const char* const slop_is_depth = "The slop is a depth: subtract it from the depth, not from a speed.";
const char* const too_fast = "max_speed is the most: take the smaller of the two.";
const char* const apart = "Bodies that are apart: the row must not pull bodies together.";

/// What is left of a depth after some steps without gravity, each of which moves by zeta dt.
double left_of(double depth, const Recovery& recovery, int steps) {
  for (int i = 0; i < steps; ++i) depth -= wanted_speed(depth, recovery) * recovery.dt;
  return depth;
}

ExpectedNumber without_slop(const char* what, double depth, const Recovery& r) {
  const double right = r.beta * depth / r.dt;
  return {
      .what = what,
      .value = right,
      .misconceptions = {{-right, "The sign: c is −depth, and ζ = −β c / Δt."},
                         {r.beta * depth, "A speed is a distance over Δt."},
                         {depth / r.dt, "Only the share β of the error, in each step."},
                         {(1 - r.beta) * depth / r.dt, "β is the share that goes, not the one that stays."},
                         {right / r.dt, "One Δt too many: a speed is a distance over Δt."},
                         {no_limit, too_fast},
                         {right * r.dt * r.dt, "Divide by Δt: a short step has to be fast to get as far."}},
      .tolerance = few_roundings};
}

void grade_slop(Grade& grade, const Recovery& sloppy) {
  grade.number(
      {.what = "0.105 m deep with a slop of 5 mm: zeta (m/s)",
       .value = 1,
       .misconceptions = {{1.05, "Subtract the slop: only what is deeper is taken back."},
                          {1.045, slop_is_depth},
                          {0.8, "β takes its share of what is deeper than the slop: subtract first."},
                          {1.1, "The slop makes the error smaller, not larger."}},
       .tolerance = few_roundings},
      wanted_speed(0.105, sloppy));
  grade.number(
      {.what = "0.004 m deep with a slop of 5 mm: zeta (m/s)",
       .value = 0,
       .misconceptions = {{-0.01, "Not below 0: the row must not pull bodies together."},
                          {0.035, slop_is_depth},
                          {0.04, "Within the slop ζ is 0."},
                          {0.05, "Within the slop ζ is 0: the least that is left of the depth is 0."}},
       .tolerance = few_roundings},
      wanted_speed(0.004, sloppy));
  grade.number(
      {.what = "not touching, 0.01 m apart: zeta (m/s)",
       .value = 0,
       .misconceptions = {{-0.1, apart},
                          {-0.15, apart},
                          {0.05, "Bodies that are apart are no error: where the depth is below 0, ζ is 0."},
                          {0.1, "Bodies that are apart are no error: where the depth is below 0, ζ is 0."}},
       .tolerance = few_roundings},
      wanted_speed(-0.01, sloppy));
}

void grade_limit(Grade& grade, const Recovery& limited) {
  const char* const to_nothing = "What is too fast goes to max_speed, not to 0.";
  const bool stops = wanted_speed(0.1, limited) == 0;
  grade.number({.what = "0.1 m deep, at most 0.05 m/s: zeta (m/s)",
                .value = 0.05,
                .misconceptions = {{1, "The limit is not kept."},
                                   {0.5, "max_speed limits ζ, not the depth."},
                                   {0, to_nothing},
                                   {0.001, "max_speed is a speed already: no Δt."},
                                   {0.01, "max_speed limits ζ itself, β included."}},
                .tolerance = few_roundings},
               wanted_speed(0.1, limited));
  Recovery both = limited;
  both.slop = 0.005;
  grade.number({.what = "the same with a slop of 5 mm: zeta (m/s)",
                .value = 0.05,
                .misconceptions = {{0, stops ? to_nothing
                                             : "First the slop, then the limit: max_speed is the last word."},
                                   {0.95, "The limit is not kept here, where there is a slop too."}},
                .tolerance = few_roundings},
               wanted_speed(0.1, both));
}

}  // namespace

Exercise exercise() {
  return {.lesson = 3,
          .task = "The velocity that a contact's row asks for: equation (7), with a slop and a limit.",
          .file = "lessons/03_drift_and_baumgarte/exercise.cpp",
          .hints =
              {"A contact has c = −depth. What is ζ without slop and limit?",
               "β depth / Δt. Subtract the slop from the depth first, and let nothing below 0 be left of it.",
               "min(β max(depth − slop, 0) / Δt, max_speed)."},
          .grade = [](Grade& grade) {
            const Recovery plain{.beta = 0.2, .slop = 0, .max_speed = no_limit, .dt = 0.02};
            const Recovery slow{.beta = 0.3, .slop = 0, .max_speed = no_limit, .dt = 0.05};
            Recovery sloppy = plain, limited = plain;
            sloppy.slop = 0.005;
            limited.max_speed = 0.05;
            grade.number(without_slop("0.1 m deep, beta 0.2, dt 0.02 s: zeta (m/s)", 0.1, plain),
                         wanted_speed(0.1, plain));
            grade.number(without_slop("0.2 m deep, beta 0.3, dt 0.05 s: zeta (m/s)", 0.2, slow),
                         wanted_speed(0.2, slow));
            grade_slop(grade, sloppy);
            grade_limit(grade, limited);
            grade.number({.what = "three steps from 0.1 m, beta 0.2: depth left (m)",
                          .value = 0.1 * 0.8 * 0.8 * 0.8,
                          .tolerance = few_roundings},
                         left_of(0.1, plain, 3));
          }};
}

}  // namespace cairn::exercise03
