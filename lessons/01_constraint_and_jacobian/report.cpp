// Lesson 01. The rod in lines and rows, and what has to be true of it.
#include "lesson.hpp"

namespace cairn::one_row {

namespace {

/// A number with its minus sign; on a terminal there are no raised digits.
std::string number(double value, int digits = 3) {
  return (value < 0 ? "−" : "") + fmt::format("{:.{}g}", std::abs(value), digits);
}

std::string triple(const Vec3<double>& v, int digits = 3) {
  return fmt::format("({}, {}, {})", number(v.x(), digits), number(v.y(), digits), number(v.z(), digits));
}

std::string term(double factor, double value) {
  return in_brackets(number(factor)) + " × " + in_brackets(number(value));
}

std::string verdict(double rate) {
  if (rate == 0) return "allowed";
  return rate > 0 ? "longer" : "shorter";
}

}  // namespace

void print_scene(Lesson& lesson, const Rod& rod) {
  lesson.print(fmt::format(
      "Scene: a rod of {} m from the origin to ({}, {}) m on a unit box with its centre at ({}, {}) m: "
      "r = ({}, {}) m",
      number(rod.length), number(rod.settings.anchor.x()), number(rod.settings.anchor.y()),
      number(rod.pose.position.x()), number(rod.pose.position.y()), number(rod.arm.x()),
      number(rod.arm.y())));
}

void print_derivative(Lesson& lesson, const Rod& rod) {
  const Quotient& coarse = rod.quotients.front();
  lesson.print(
      fmt::format("The box moves by h = {:g} m, or turns by {:g} rad, both ways:", coarse.h, coarse.h));
  lesson.print("        c at −h (m)   c at +h (m)   c grows by, for 1 of it   j");
  const char* const names[] = {"x", "y", "θ"};
  for (int k = 0; k < 3; ++k) {
    lesson.print(fmt::format("  {}   {:>12}  {:>12}   {:>14}            {:>10}", names[k],
                             fixed(coarse.backward[k], 6), fixed(coarse.forward[k], 6),
                             fixed(coarse.slope[k], 6), fixed(rod.jacobian(k), 6)));
  }
  std::string steps = "  h              ";
  std::string errors = "  difference to j";
  for (const int i : {0, 2, 4, 8, 14, 20}) {
    steps += fmt::format(" {:>8.0e}", rod.quotients[i].h);
    errors += fmt::format(" {:>8.0e}", rod.quotients[i].error);
  }
  lesson.print(steps);
  lesson.print(errors);
  lesson.print();
}

void print_motions(Lesson& lesson, const Rod& rod) {
  const Vec3<double>& j = rod.jacobian;
  const Vec3<double>& v = rod.settings.velocity;
  lesson.print("The velocity of --vx, --vy and --omega:");
  lesson.print(fmt::format("(5)   dc/dt = j·v = {} + {} + {} = {} m/s: {}", term(j.x(), v.x()),
                           term(j.y(), v.y()), term(j.z(), v.z()), fixed(rod.motion.rate, 4),
                           verdict(rod.motion.rate)));
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

void check_derivative(Lesson& lesson, const Rod& rod) {
  // |p| and the length are the same sum, taken from the box and from the scene: a few roundings of 10 m.
  lesson.check_small("c where the rod was made, eq (3) (m)", rod.error, 8 * epsilon * 10);
  lesson.check_small(
      "the library's row of this rod has the same c and j",
      std::max(std::abs(rod.row.error - rod.error), (rod.row.jacobian_b - rod.jacobian).norm()),
      8 * epsilon * 10);
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
  lesson.check_equal("j·v is how fast c changes while the box moves, eq (5) (m/s)", change,
                     rod.jacobian.dot(v), speed * quotient_tolerance(small_step));
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
}

CsvTable quotients_table(const Rod& rod) {
  CsvTable table{.header = {"h", "slope_x", "slope_y", "slope_theta_metre", "largest_difference"}};
  for (const Quotient& q : rod.quotients)
    table.rows.push_back({q.h, q.slope[0], q.slope[1], q.slope[2], q.error});
  return table;
}

}  // namespace cairn::one_row
