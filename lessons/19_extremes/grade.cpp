// Exercise 19, graded: what is predicted, what is measured sweep by sweep, by (R / (1 + R))ᵏ, and what ends
// it.
#include "exercise.cpp"

#include <fmt/format.h>

namespace cairn::exercise19 {
namespace {

constexpr double error_rounding = 1e-11;  // of hundreds of sweeps, with a dozen operations each
constexpr int most_sweeps = 5000;
constexpr double strength = 9.81, time_step = 0.01;  // [m/s²], [s]

struct Case {
  double below = 1;  // [kg]
  double above = 1;
  double share = 0.01;

  double ratio() const { return above / below; }
  double rate() const { return ratio() / (1 + ratio()); }  // of a sweep
  double exact() const { return std::log(share) / std::log(rate()); }
  std::string name() const { return fmt::format("{:g} kg on {:g} kg, to {:g}", above, below, share); }
};

void grade_prediction(Grade& grade, const Case& each, const Study& got) {
  const double ratio = each.ratio(), exact = each.exact();
  ExpectedNumber number{
      .what = each.name() + ": predicted sweeps", .value = std::ceil(exact), .tolerance = 0};
  number.misconceptions = {
      {0, "Nothing is predicted."},
      {std::ceil(std::log(each.share) / std::log(ratio)), "R is no rate: a sweep leaves R / (1 + R)."},
      {std::floor(exact), "One too few: round up."},
      {std::ceil(std::log(each.share) / std::log(1 / (1 + ratio))),
       "Mind which box is above: R = above / below."},
      {std::ceil(2 * exact), "That is Jacobi, whose rate is the square root: Gauss-Seidel is twice as fast."},
      {std::ceil(exact / std::log(10.0)),
       "Mind the logarithms: rate^k = share, so k = log(share) / log(rate)."},
      {std::ceil(4.6 * ratio),
       "4.6 R is about right for 1 % and a large R; this asks for the exact number."}};
  number.misconceptions.push_back(
      {std::ceil((1 - each.share) / (1 - each.rate())),
       "Each sweep takes the same share of what is left, and less and less: rate^k, not 1 - k (1 - rate)."});
  const std::string for_another =
      fmt::format("That is for 1 %: the share asked for is {:g} here.", each.share);
  if (each.share != 0.01) {
    number.misconceptions.push_back({std::ceil(std::log(0.01) / std::log(each.rate())), for_another.c_str()});
  }
  if (ratio > 1) {
    number.misconceptions.push_back({std::ceil(std::log(each.share) / std::log(1 - 1 / ratio)),
                                     "A sweep leaves R / (1 + R), not 1 - 1 / R: the light box falls, too."});
  }
  grade.number(number, got.predicted);
}

double error_after(const Study& got, int sweeps) {
  return sweeps <= got.errors.size() ? got.errors[sweeps - 1] : std::nan("");
}

/// With m1 below m2 and T = m1 + m2: the ground gives m1 of T in sweep 1, in units of g Δt, and m1 m2 / T in
/// sweep 2.
void grade_errors(Grade& grade, const Case& each, const Study& got) {
  const double below = each.below, whole = each.below + each.above, rate = each.rate(), first = below / whole;
  const bool is_noted = error_after(got, 1) != 1;
  grade.number(
      {.what = each.name() + ": error after sweep 1",
       .value = rate,
       .misconceptions = {{first, "The error is what the load lacks, not what it has."},
                          {1 - 1 / whole, "A speed is no impulse: multiply it by the effective mass."},
                          {1 - first * time_step, "A load is a force: the impulse over Δt."},
                          {1 + first, "The sign: the ground pushes up."},
                          {1, error_after(got, 2) != 1
                                  ? "Errors are noted after each sweep: the 1 of before is none of them."
                                  : ""},
                          {100 * rate, "A share, not percent."},
                          {0, "The ground stops the lower box alone: an impulse of below v."},
                          {1 - below / each.above, "The exact load is that of both boxes."}},
       .tolerance = error_rounding},
      error_after(got, 1));
  grade.number(
      {.what = each.name() + ": error after sweep 2",
       .value = rate * rate,
       .misconceptions =
           {{rate,
             is_noted ? "Action and reaction: the contact between the boxes pushes the lower one down." : ""},
            {-first, "Divide by 1/m + 1/m between the boxes: do not multiply by the masses."},
            {1 - 2 * first - first * rate, "Gravity acts once, before the sweeps: they are one step."},
            {0, "Two bodies give way between the boxes: the effective mass has both in it."},
            {1 - first * rate, "Add up what the ground gives: do not keep the last push alone."}},
       .tolerance = error_rounding},
      error_after(got, 2));
  grade.number({.what = each.name() + ": error after sweep 3",
                .value = rate * rate * rate,
                .misconceptions = {{1 - first - 2 * first * rate,
                                    "The contact between the boxes slows the upper one down."}},
                .tolerance = error_rounding},
               error_after(got, 3));
}

constexpr const char* not_stopped = "It has not stopped: end where the error is at most the share.";

void grade_count(Grade& grade, const Case& each, const Study& got) {
  const double value = std::ceil(each.exact());
  const bool comes_down = !got.errors.empty() && got.errors.back() <= each.share;
  const bool begins_high = error_after(got, 1) > each.share;
  grade.number(
      {.what = each.name() + ": measured sweeps",
       .value = value,
       .misconceptions = {{0, "Nothing is measured."},
                          {most_sweeps, comes_down ? not_stopped : ""},
                          {value - 1, "Note the error of the last sweep as well, and end then."},
                          {std::ceil(std::log(0.01) / std::log(each.rate())),
                           "End where the error is at most the share that was asked for."},
                          {value + 1, "One too many: look at the error after the sweep, not before it."},
                          {1, begins_high ? "It has stopped after one sweep." : ""}},
       .tolerance = 0},
      got.errors.size());
}

/// Five sweeps do not get there; the prediction does not know of them.
void grade_at_most(Grade& grade) {
  const Case each{.below = 2, .above = 30};
  const double exact = std::ceil(each.exact());
  const Study got = study(each.below, each.above, strength, time_step, each.share, 5);
  grade.number({.what = each.name() + ", at most 5 sweeps: measured sweeps",
                .value = 5,
                .misconceptions = {{exact, "`at_most` ends it, too."}, {6, "At most 5: one too many."}},
                .tolerance = 0},
               got.errors.size());
  grade.number({.what = each.name() + ", at most 5 sweeps: predicted sweeps",
                .value = exact,
                .misconceptions = {{5, "That is what was measured: predict it, before the first sweep."}},
                .tolerance = 0},
               got.predicted);
}

void grade_case(Grade& grade, const Case& each) {
  const Study got = study(each.below, each.above, strength, time_step, each.share, most_sweeps);
  grade_prediction(grade, each, got);
  grade_errors(grade, each, got);
  grade_count(grade, each, got);
}

}  // namespace

Exercise exercise() {
  return {
      .lesson = 19,
      .task = "Predict the sweeps of a heavy box on a light one; then sweep, and count them.",
      .file = "lessons/19_extremes/exercise.cpp",
      .hints =
          {"A sweep leaves R / (1 + R) of the error. For which k is its k-th power the share?",
           "k = log(share) / log(R / (1 + R)), rounded up. The loop: the ground stops the lower box; then "
           "both boxes get the same velocity, by an impulse of (v1 - v2) / (1/m1 + 1/m2).",
           "error = 1 - sum of the ground's impulses / ((m1 + m2) g dt)."},
      .grade = [](Grade& grade) {
        grade_case(grade, {.below = 2, .above = 30});
        grade_case(grade, {.below = 0.5, .above = 1.5, .share = 0.001});
        grade_case(grade, {.below = 2, .above = 500, .share = 0.05});
        grade_at_most(grade);
      }};
}

}  // namespace cairn::exercise19
