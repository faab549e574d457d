// Exercise 03, graded: single values, and a box that settles.
#include <limits>

#include "exercise.hpp"

namespace cairn::exercise03 {
namespace {

constexpr double few_roundings = 1e-14;  // of numbers near 1, after at most fifty operations
const char* const apart = "Bodies that are apart are not drawn together.";

/// What is left of a depth after some steps without gravity, each of which moves by zeta dt.
double left_of(Answer answer, double depth, const Recovery& recovery, int steps) {
  for (int i = 0; i < steps; ++i) depth -= answer(depth, recovery) * recovery.dt;
  return depth;
}

void grade_slop(Grade& grade, Answer answer, const Recovery& plain) {
  Recovery sloppy = plain;
  sloppy.slop = 0.005;
  grade.number({.what = "0.105 m deep with a slop of 5 mm: zeta (m/s)",
                .value = 1,
                .tolerance = few_roundings,
                .misconceptions = {{1.05, "The slop is not taken back: only what is deeper."},
                                   {1.1, "The slop makes the error smaller, not larger."}}},
               answer(0.105, sloppy));
  grade.number({.what = "0.004 m deep with a slop of 5 mm: zeta (m/s)",
                .value = 0,
                .tolerance = few_roundings,
                .misconceptions = {{-0.01, "Within the slop nothing is asked for: never a negative speed."},
                                   {0.04, "Within the slop nothing is asked for."}}},
               answer(0.004, sloppy));
  grade.number({.what = "not touching, 0.01 m apart: zeta (m/s)",
                .value = 0,
                .tolerance = few_roundings,
                .misconceptions = {{-0.1, apart}, {-0.15, apart}}},
               answer(-0.01, sloppy));
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  Recovery plain{.beta = 0.2, .slop = 0, .max_speed = std::numeric_limits<double>::infinity(), .dt = 0.02};
  grade.number({.what = "0.1 m deep, beta 0.2, dt 0.02 s: zeta (m/s)",
                .value = 1,
                .tolerance = few_roundings,
                .misconceptions = {{-1, "The sign: C is -depth, and zeta = -beta c / dt."},
                                   {0.02, "A speed: the share of the error, over dt."},
                                   {5, "Only the share beta of it in each step."},
                                   {0.0004, "Divide by dt: a short step has to move fast to get as far."}}},
               answer(0.1, plain));
  grade_slop(grade, answer, plain);
  Recovery limited = plain;
  limited.max_speed = 0.5;
  grade.number({.what = "0.1 m deep, at most 0.5 m/s: zeta (m/s)",
                .value = 0.5,
                .tolerance = few_roundings,
                .misconceptions = {{1, "The limit has not been kept."}}},
               answer(0.1, limited));
  grade.number({.what = "three steps from 0.1 m, beta 0.2: depth left (m)",
                .value = 0.0512,
                .tolerance = few_roundings},
               left_of(answer, 0.1, plain, 3));
}

Exercise exercise() {
  return {
      .lesson = 3,
      .task = "The velocity that a contact's row asks for: equation (7), with a slop and a limit.",
      .file = "lessons/03_drift_and_baumgarte/exercise.cpp",
      .hints = {"A contact has c = -depth. What is zeta without slop and limit?",
                "beta depth / dt. The slop is taken off the depth first, and nothing below 0 is left of it.",
                "min(beta max(depth - slop, 0) / dt, max_speed)."},
      .grade = [](Grade& marks) { grade(marks, wanted_speed); }};
}

}  // namespace cairn::exercise03
