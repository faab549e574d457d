// Lesson 01. Constraint and Jacobian: c says where, j says which way.
#include "lessons/lesson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pictures.hpp"
#include "rod.hpp"

namespace {

using namespace cairn;
using namespace cairn::one_row;
using render::fixed;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double small_step = 1e-5;  // of central differences: near the best one for double

LessonInfo info() {
  return {
      .number = 1,
      .name = "constraint_and_jacobian",
      .title = "Where, and which way",
      .idea =
          "A constraint is a number c that has to be 0. Its derivative j has three numbers a body: with a "
          "velocity j tells how fast c changes, and with a strength λ the force that keeps it.",
      .paper = "paper 2.1, eq (3)-(5), (9), (10)",
      .equations = {"(3)   c(x, y, θ) = |p| − length = 0        p: the anchor on the box",
                    "(4)   dc/dt = 0                            with β = 0: c is to stay as it is",
                    "(5)   dc/dt = j v,  j = (u_x, u_y, r × u)  u = p / |p|, r: from the centre to p",
                    "(10)  f = jᵀ λ                             (9): f has a force and a torque"},
      .needs = {"lesson 00"},
      .reads = {"src/constraints/distance_joint.cpp", "src/constraints/constraint.hpp",
                "tests/constraints/jacobian_tests.cpp"},
      .question =
          "A box hangs on a rod of 5 m, which goes from (0, 0) to (3, −4) on its left side. Its velocity "
          "(v_x, v_y, ω) is (0.8, 0.6, 0), or (0.6, −0.8, 0), or (1, 0.5, −0.5). How fast does each make "
          "the rod longer, in m/s? Which of them does a rod allow?",
      .hints = {"Only what the anchor does along the rod makes it longer. Across the rod it may move.",
                "The rod points along u = (0.6, −0.8). When the box turns, the anchor moves too: up for a "
                "negative ω, as it is on the left.",
                "j = (0.6, −0.8, 0.4), and the third is 0.6 − 0.4 − 0.2."},
      .parameters = {{"x", 3, 1, 6, "m", "anchor, to the right of the pivot"},
                     {"y", -4, -6, -1, "m", "anchor, above the pivot"},
                     {"turn", 0, -180, 180, "°", "of the box about its anchor"},
                     {"vx", 1, -10, 10, "m/s", "velocity of the box"},
                     {"vy", 2, -10, 10, "m/s", "velocity of the box"},
                     {"omega", 0.5, -5, 5, "rad/s", "how fast it turns"},
                     {"lambda", -10, -1000, 1000, "N", "strength of the rod; negative: it pulls"},
                     {"seed", 1, 0, 1e6, "", "of the random poses", Parameter::Kind::whole}},
      .cover = 3,
      .next = "lesson02_effective_mass   (how large λ has to be)"};
}

/// A number with its minus sign; on a terminal there are no raised digits.
std::string number(double value, int digits = 3) {
  return (value < 0 ? "−" : "") + fmt::format("{:.{}g}", std::abs(value), digits);
}

std::string triple(const Vec3<double>& v, int digits = 3) {
  return fmt::format("({}, {}, {})", number(v.x(), digits), number(v.y(), digits), number(v.z(), digits));
}

void print_derivative(Lesson& lesson, const Rod& rod) {
  const Quotient& coarse = rod.quotients.front();
  lesson.print(
      fmt::format("The box moves by h = {:g} m, or turns by {:g} rad, both ways:", coarse.h, coarse.h));
  lesson.print("        c at −h (m)   c at +h (m)   c grows by, for 1 of it   j");
  const char* const names[] = {"x", "y", "θ"};
  for (std::size_t k = 0; k < 3; ++k) {
    lesson.print(fmt::format("  {}   {:>12}  {:>12}   {:>14}            {:>10}", names[k],
                             fixed(coarse.backward[k], 6), fixed(coarse.forward[k], 6),
                             fixed(coarse.slope[k], 6), fixed(rod.jacobian(static_cast<int>(k)), 6)));
  }
  std::string steps = "  h              ";
  std::string errors = "  difference to j";
  for (const std::size_t i :
       {std::size_t{0}, std::size_t{2}, std::size_t{4}, std::size_t{8}, std::size_t{14}, std::size_t{20}}) {
    steps += fmt::format(" {:>8.0e}", rod.quotients[i].h);
    errors += fmt::format(" {:>8.0e}", rod.quotients[i].error);
  }
  lesson.print(steps);
  lesson.print(errors);
  lesson.print();
}

std::string in_brackets(double value) { return value < 0 ? "(" + number(value) + ")" : number(value); }

std::string product(double factor, double value) { return in_brackets(factor) + " × " + in_brackets(value); }

std::string verdict(double rate) {
  if (rate == 0) return "allowed";
  return rate > 0 ? "longer" : "shorter";
}

void print_motions(Lesson& lesson, const Rod& rod) {
  const Vec3<double>& j = rod.jacobian;
  const Vec3<double>& v = rod.settings.velocity;
  lesson.print(fmt::format("(5)   dc/dt = j v = {} + {} + {} = {} m/s", product(j.x(), v.x()),
                           product(j.y(), v.y()), product(j.z(), v.z()), fixed(j.dot(v), 4)));
  for (const Motion& motion : rod.asked) {
    lesson.print(fmt::format("  v = {:<18} j v = {:>7} m/s   {}", triple(motion.velocity),
                             fixed(motion.rate, 4), verdict(motion.rate)));
  }
  lesson.print();
  lesson.print(fmt::format("(10)  f = jᵀ λ = {} × {} N: force ({}, {}) N, torque {} N m", triple(j),
                           number(rod.settings.lambda), number(rod.force.x()), number(rod.force.y()),
                           number(rod.force.z())));
  lesson.print("  motions that the rod allows            v                 power f·v (W)");
  for (const Motion& motion : rod.allowed) {
    lesson.print(fmt::format("    {:<26} {:<26} {:>8}", motion.name, triple(motion.velocity),
                             fixed(rod.force.dot(motion.velocity), 4)));
  }
  lesson.print();
}

void print_kinds(Lesson& lesson, const std::vector<KindOfRows>& kinds) {
  lesson.print("Every kind of row in the library, at 20 random poses: largest |j − difference|");
  std::string line;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    line += fmt::format("  {:<18} {} {:<5} {:>7.1e} ", kinds[i].name, kinds[i].rows,
                        kinds[i].rows == 1 ? "row" : "rows", kinds[i].error);
    if (i % 2 == 0 && i + 1 < kinds.size()) continue;
    lesson.print(line);
    line.clear();
  }
  lesson.print();
}

void check_derivative(Lesson& lesson, const Rod& rod, const std::vector<KindOfRows>& kinds) {
  // |p| and the length are the same sum, taken from the box and from the scene: a few roundings of 10 m.
  lesson.check_small("c where the rod was made, eq (3) (m)", rod.error, 8 * epsilon * 10);
  lesson.check_small("j is the derivative of c, by central differences", quotient(rod, small_step).error,
                     quotient_tolerance(small_step));
  // The error is a h² (1 + b h²), with b below 10: at h = 0.01 that is a thousandth.
  const double order = std::log2(quotient(rod, 0.02).error / quotient(rod, 0.01).error);
  lesson.check_equal("half the step of a difference, a quarter of its error: order", order, 2, 0.01);
  const Vec3<double>& v = rod.settings.velocity;
  const double speed = v.norm();
  const double t = speed > 0 ? small_step / speed : 1;
  const double change =
      (error_at(rod, carried(rod.pose, v, t)) - error_at(rod, carried(rod.pose, v, -t))) / (2 * t);
  lesson.check_equal("j v is how fast c changes while the box moves, eq (5) (m/s)", change,
                     rod.jacobian.dot(v), speed * quotient_tolerance(small_step));
  double largest = 0;
  for (const KindOfRows& kind : kinds) largest = std::max(largest, kind.error);
  lesson.check_small("the same holds for every kind of row in the library", largest,
                     quotient_tolerance(small_step));
}

void check_force(Lesson& lesson, const Rod& rod) {
  const double lambda = std::abs(rod.settings.lambda);
  double power = 0;
  for (const Motion& motion : rod.allowed) power = std::max(power, std::abs(rod.force.dot(motion.velocity)));
  // Sums of three products, each of at most 2 m/s times lambda; u is rounded, too.
  lesson.check_small("f = jᵀ λ does no work in what the rod allows (W)", power, 16 * epsilon * 2 * lambda);
  // The torque is that of a pull along the rod at the anchor: its lever is the distance from the rod's line
  // to the centre of the box, which is p × centre / |p|.
  const Vec2<double>& p = rod.settings.anchor;
  const double lever = cross(p, rod.pose.position) / rod.length;
  lesson.check_equal("its torque is the pull times the lever arm of the centre (N m)", rod.force.z(),
                     lever * rod.settings.lambda, 16 * epsilon * 10 * lambda);
  // Along the tangent for one second, the anchor goes from the end of one leg to that of the hypotenuse.
  const double gone = error_at(rod, carried(rod.pose, rod.allowed[0].velocity, 1));
  lesson.check_equal("1 s of swing, straight on: c = √(length² + 1) − length (m)", gone,
                     std::hypot(rod.length, 1) - rod.length, 16 * epsilon * 10);
}

CsvTable quotients_table(const Rod& rod) {
  CsvTable table{.header = {"h", "slope_x", "slope_y", "slope_theta_metre", "largest_difference"}};
  for (const Quotient& q : rod.quotients)
    table.rows.push_back({q.h, q.slope[0], q.slope[1], q.slope[2], q.error});
  return table;
}

void run(Lesson& lesson) {
  const Rod rod = hang_box({.anchor = {lesson.real("x"), lesson.real("y")},
                            .turn = lesson.real("turn") * pi / 180,
                            .velocity = {lesson.real("vx"), lesson.real("vy"), lesson.real("omega")},
                            .lambda = lesson.real("lambda")});
  const std::vector<KindOfRows> kinds =
      compare_every_kind(static_cast<std::uint64_t>(lesson.whole("seed")), small_step);
  lesson.print(fmt::format(
      "Scene: a rod of {} m from the origin to ({}, {}) m on a unit box with its centre at ({}, {}) m: "
      "r = ({}, {}) m",
      number(rod.length), number(rod.settings.anchor.x()), number(rod.settings.anchor.y()),
      number(rod.pose.position.x()), number(rod.pose.position.y()), number(rod.arm.x()),
      number(rod.arm.y())));
  lesson.predict();
  lesson.print();
  print_derivative(lesson, rod);
  print_motions(lesson, rod);
  print_kinds(lesson, kinds);
  std::vector<double> rates;
  for (const Motion& motion : rod.asked) rates.push_back(motion.rate);
  lesson.answer(rates, 0.01,
                "It is j v. Where that is 0 the rod allows the motion: of three freedoms one row takes one, "
                "and two are left, swinging and turning about the anchor.");
  check_derivative(lesson, rod, kinds);
  check_force(lesson, rod);
  lesson.film(rod_shots(rod, kinds));
  lesson.data(quotients_table(rod));
  lesson.fingerprint({rod.error, rod.jacobian.x(), rod.jacobian.y(), rod.jacobian.z(), rod.force.z()});
}

}  // namespace

int main(int argc, char** argv) { return cairn::run_lesson(info(), run, argc, argv); }
