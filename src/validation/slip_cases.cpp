// Floor 8. One step of a rope round a post, which is held or slips: B32b.
#include <string>

#include <cairn/validation/case_list.hpp>
#include <cairn/validation/case_problems.hpp>
#include <cairn/validation/worst.hpp>

namespace cairn {

namespace {

using namespace cairn::cases;

const double slip_friction = 0.3;
const double slip_light = 1;   // [kg], the other weight is that times a ratio
const double slip_bead = 0.5;  // [kg]
const double slip_fall = standard_gravity * standard_dt;

/// The direction from the post's middle to bead i of n, counted from the right.
Vec2<double> bead_direction(int i, int n) {
  const double angle = (i + 0.5) * pi / n;
  return {std::cos(angle), std::sin(angle)};
}

/// The rod along u from a to b: it keeps their distance.
ConstraintRow<double> taut_row(BodyId a, BodyId b, const Vec2<double>& u) {
  ConstraintRow<double> row;
  row.a = a;
  row.b = b;
  row.jacobian_a = {-u.x(), -u.y(), 0};
  row.jacobian_b = {u.x(), u.y(), 0};
  return row;
}

/// n beads without weight on a round post, tied to each other by rods; from the first one hangs a weight of
/// `ratio` times that on the last one. All has fallen for one step from rest. Points: nothing turns.
VelocityProblem<double> slipping_rope(int n, double ratio) {
  VelocityProblem<double> problem = empty_problem<double>();
  BodyId last = add_body<double>(problem, ratio * slip_light, 1, {0, -slip_fall, 0});
  for (int i = 0; i < n; ++i) {
    const BodyId bead = add_body<double>(problem, slip_bead, 1, {0, 0, 0});
    const Vec2<double> out = bead_direction(i, n);
    Vec2<double> way(0, 1);
    if (i > 0) way = (out - bead_direction(i - 1, n)).normalized();
    add_row(problem, taut_row(last, bead, way));
    ConstraintRow<double> normal;
    normal.b = bead;
    normal.jacobian_b = {out.x(), out.y(), 0};
    normal.bounds = Bounds<double>::unilateral();
    const int place = add_row(problem, normal);
    ConstraintRow<double> friction = normal;
    friction.jacobian_b = {out.y(), -out.x(), 0};
    friction.bounds = Bounds<double>::coulomb(slip_friction, place);
    add_row(problem, friction);
    last = bead;
  }
  const BodyId light = add_body<double>(problem, slip_light, 1, {0, -slip_fall, 0});
  add_row(problem, taut_row(last, light, {0, -1}));
  return problem;
}

/// The speed of the heavy weight after one step from rest, as a share of g dt.
double measured_slip(const SolverMaker<double>& make, int n, double ratio) {
  VelocityProblem<double> problem = slipping_rope(n, ratio);
  // n + 2 points on a straight line cost 0.93 (n + 2)^2 sweeps a digit. Sharp corners and friction cost up to
  // three times as many; enough for 14 digits.
  make({.iterations = 40 * (n + 2) * (n + 2)})->solve(problem);
  return -problem.velocity[{1}].y() / slip_fall;
}

/// The same by the laws of motion, where the rope slips. All beads have one speed u along the post, and the
/// weights u cos(h), as the rods are at h to the tangents. The push T' - T at a bead, from T on the heavy
/// side:
///   bead m u / dt = (T - T') cos(h) - mu (T + T') sin(h)
/// T' is linear in u, and so is what the light weight asks for at the other end, T' = m (g + u cos(h) / dt).
double expected_slip(int n, double ratio) {
  const double h = pi / (2 * n), c = std::cos(h), s = std::sin(h);
  // Tensions are constant + slope * u, for g = dt = 1.
  double constant = ratio * slip_light, slope = -ratio * slip_light * c;
  for (int i = 0; i < n; ++i) {
    constant = constant * (c - slip_friction * s) / (c + slip_friction * s);
    slope = (slope * (c - slip_friction * s) - slip_bead) / (c + slip_friction * s);
  }
  const double u = (constant - slip_light) / (slip_light * c - slope);
  return u * c;
}

ValidationResult rope_held_or_slipping(const EngineMaker&) {
  const std::string any = ": worst of 3, 6, 12 corners and 2 solvers";
  const std::string rounding = "14 digits of sweeps, and the rounding of numbers near 1 in each: 1e-12";
  Worst held = Worst("speed of the weight, over g dt, at 0.9999 of the ratio that is held" + any)
                   .by("0")
                   .since(rounding);
  Worst slips = Worst("speed over g dt at 1.0001, 1.01 and 2 times that ratio" + any)
                    .by("u cos h, mass of a bead u/dt = (T - T') cos h - mu (T + T') sin h")
                    .since(rounding);
  for (const SolverMaker<double>& make : paper_solvers<double>()) {
    for (const int n : {3, 6, 12}) {
      const double ratio = capstan_ratio(n, slip_friction);
      held.add(0, measured_slip(make, n, 0.9999 * ratio), 1e-12);
      for (const double load : {1.0001, 1.01, 2.0}) {
        slips.add(expected_slip(n, load * ratio), measured_slip(make, n, load * ratio), 1e-12);
      }
    }
  }
  return {.numbers = {held.number(), slips.number()}};
}

}  // namespace

void add_slip_cases(ValidationCases& cases) {
  cases.push_back({.id = "B32b",
                   .title = "A rope round a post that slips speeds up as the laws of motion say",
                   .run = rope_held_or_slipping});
}

}  // namespace cairn
