// Exercise 01, graded: against central differences of c, at twenty rails and arms.
#include "exercise.cpp"

namespace cairn::exercise01 {
namespace {

constexpr double step = 1e-5;        // [m or rad] of the differences
constexpr double difference = 1e-9;  // step^2 / 6 and the rounding 1e-16 / step of numbers near 1

/// The distance of the point from the rail, once the body has moved by (x, y) and turned by angle.
double distance(const Rail& rail, const FixedList<double, 3>& moved) {
  const double c = std::cos(moved[2]), s = std::sin(moved[2]);
  const double x = moved[0] + c * rail.arm_x - s * rail.arm_y;
  const double y = moved[1] + s * rail.arm_x + c * rail.arm_y;
  return -std::sin(rail.angle) * x + std::cos(rail.angle) * y;
}

double slope_of_distance(const Rail& rail, int axis) {
  FixedList<double, 3> forth = {}, back = {};
  forth[axis] = step;
  back[axis] = -step;
  return (distance(rail, forth) - distance(rail, back)) / (2 * step);
}

/// The i-th of twenty: slopes from -1.5 to 1.4 rad, arms all around the body.
Rail rail_at(int i) {
  return {.angle = -1.5 + 0.153 * i, .arm_x = std::sin(2.4 * i + 1), .arm_y = std::cos(1.7 * i)};
}

/// The largest difference between an entry and its slope.
double worst_entry(int axis) {
  double worst = 0;
  for (int i = 0; i < 20; ++i) {
    const double off = std::abs(jacobian(rail_at(i))[axis] - slope_of_distance(rail_at(i), axis));
    worst = std::isnan(off) ? off : std::max(worst, off);
  }
  return worst;
}

void grade_thirty(Grade& grade) {
  const double half = std::sqrt(3.0) / 2;
  const Rail thirty{.angle = std::acos(half), .arm_x = 0.4, .arm_y = 0.2};
  const double turn = 0.4 * half + 0.2 * 0.5;
  const FixedList<double, 3> j = jacobian(thirty);
  const char* const level = "That is for a level rail: this one rises by 30 degrees.";
  const char* const no_unit = "n = (−tan, 1) is too long: across the rail, with length 1, is (−sin, cos).";
  const char* const not_turned =
      "That is the arm of a level rail. Its x and y are those of now: do not turn them.";
  const char* const lower = "c grows on the upper side: n points to the lower one here, too.";
  const bool knows_only_level = j[0] == 0;
  grade.number({.what = "a rail of 30 degrees: j_x",
                .value = -0.5,
                .misconceptions = {{half, "That is along the rail: there the point may go. j points across."},
                                   {0.5, "c grows on the upper side: to the right means down into the rail."},
                                   {-0.5 / half, no_unit},
                                   {0, level}},
                .tolerance = difference},
               j[0]);
  grade.number({.what = "a rail of 30 degrees: j_y",
                .value = half,
                .misconceptions = {{0.5, "That is along the rail: there the point may go. j points across."},
                                   {-half, "c shrinks on the lower side: upwards it grows."},
                                   {1, knows_only_level ? level : no_unit}},
                .tolerance = difference},
               j[1]);
  grade.number(
      {.what = "with the arm (0.4, 0.2) m: j_theta (m)",
       .value = turn,
       .misconceptions = {{-turn, j[1] < 0
                                      ? lower
                                      : "The order: r × n, with n to the upper side, is r_x n_y − r_y n_x."},
                          {0, "The point moves as well when the body turns: where is the arm?"},
                          {0.4 * half - 0.2 * 0.5, "A sign: r_x n_y − r_y n_x, and n_x is negative here."},
                          {0.4 * -0.5 + 0.2 * half, "That is r·n. The arm comes in as r × n."},
                          {0.4 * 0.5 - 0.2 * half, "That is r × t, with t along the rail: take n across it."},
                          {0.4 * half, "Both parts of the arm count: r_x n_y − r_y n_x."},
                          {0.2 * 0.5, "Both parts of the arm count: r_x n_y − r_y n_x."},
                          {0.4, knows_only_level ? level : not_turned}},
       .tolerance = difference},
      j[2]);
}

}  // namespace

Exercise exercise() {
  return {.lesson = 1,
          .task = "The row j of a point that slides along a straight rail: equation (5).",
          .file = "lessons/01_constraint_and_jacobian/exercise.cpp",
          .hints = {"Which unit vector n points across the rail, to its upper side? c = n·p.",
                    "n = (−sin, cos) of the angle. How does the point p move when only the body turns?",
                    "By ω (−r_y, r_x). So j_θ = n_x (−r_y) + n_y r_x."},
          .grade = [](Grade& grade) {
            grade_thirty(grade);
            grade.number({.what = "20 rails: largest difference of j_x from dc/dx", .tolerance = difference},
                         worst_entry(0));
            grade.number({.what = "20 rails: largest difference of j_y from dc/dy", .tolerance = difference},
                         worst_entry(1));
            grade.number({.what = "20 rails: largest difference of j_theta from dc/dtheta (m)",
                          .tolerance = difference},
                         worst_entry(2));
          }};
}

}  // namespace cairn::exercise01
