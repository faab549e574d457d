// Exercise 05, graded: intervals and clamped values.
#include <limits>

#include "exercise.hpp"

namespace cairn::exercise05 {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// How an infinite bound is compared, and shown: as a number beyond all forces.
double shown(double bound) {
  const double most = 1e99;
  return bound > most ? most : (bound < -most ? -most : bound);
}

ExpectedNumber bound(const char* what, double value, const char* otherwise) {
  ExpectedNumber expected{.what = what, .value = shown(value), .tolerance = 0};
  for (const double wrong : {0.0, infinite, -infinite, 50.0, -50.0}) {
    if (shown(wrong) != shown(value)) expected.misconceptions.push_back({shown(wrong), otherwise});
  }
  return expected;
}

void grade_clamp(Grade& grade, double (*clamped_by)(double, const Interval&)) {
  const Interval between{.lower = -2, .upper = 5};
  grade.number({.what = "λ = -20 N in [-2, 5] (N)",
                .value = -2,
                .tolerance = 0,
                .misconceptions = {{0, "What is out of the interval goes to its end, not to 0."},
                                   {-20, "Nothing was clamped."},
                                   {5, "That is the other end."}}},
               clamped_by(-20, between));
  grade.number({.what = "λ = 60 N in [-2, 5] (N)",
                .value = 5,
                .tolerance = 0,
                .misconceptions = {{0, "What is out of the interval goes to its end, not to 0."},
                                   {60, "Nothing was clamped."},
                                   {-2, "That is the other end."}}},
               clamped_by(60, between));
  grade.number(
      {.what = "λ = 3 N in [-2, 5] (N)",
       .value = 3,
       .tolerance = 0,
       .misconceptions = {{5, "What is in the interval stays."}, {-2, "What is in the interval stays."}}},
      clamped_by(3, between));
}

}  // namespace

void grade(Grade& grade, Answer answer) {
  const auto [interval_by, clamped_by] = answer;
  const Interval joint = interval_by(RowKind::joint, 50), contact = interval_by(RowKind::contact, 50);
  const Interval rope = interval_by(RowKind::rope, 50), motor = interval_by(RowKind::motor, 50);
  grade.number(bound("joint: lower bound (N)", -infinite, "A joint pulls as hard as it has to."),
               shown(joint.lower));
  grade.number(bound("joint: upper bound (N)", infinite, "A joint pushes as hard as it has to."),
               shown(joint.upper));
  grade.number(bound("contact: lower bound (N)", 0, "A contact does not pull."), shown(contact.lower));
  grade.number(bound("contact: upper bound (N)", infinite, "A contact pushes as hard as it has to."),
               shown(contact.upper));
  grade.number(
      bound("rope: lower bound (N)", -infinite, "A rope pulls as hard as it has to, which is a negative λ."),
      shown(rope.lower));
  grade.number(bound("rope: upper bound (N)", 0, "A rope does not push."), shown(rope.upper));
  grade.number(bound("motor of 50 N: lower bound (N)", -50, "A motor brakes with its strength."),
               shown(motor.lower));
  grade.number(bound("motor of 50 N: upper bound (N)", 50, "A motor drives with its strength."),
               shown(motor.upper));
  grade_clamp(grade, clamped_by);
}

Exercise exercise() {
  return {
      .lesson = 5,
      .task = "The interval of each kind of row (2.2), and the clamp. Infinite is shown as 1e+99.",
      .file = "lessons/05_sweep_and_bounds/exercise.cpp",
      .hints = {"Which of the four can pull, and which can push?",
                "Infinite is std::numeric_limits<double>::infinity(). A contact: 0 to infinity; a rope the "
                "other way round.",
                "clamped: the smaller of the upper bound and (the larger of the lower bound and lambda)."},
      .grade = [](Grade& marks) {
        grade(marks, {interval_of, clamped});
      }};
}

}  // namespace cairn::exercise05
